// SPDX-License-Identifier: Apache-2.0
#include "base/result.h"

namespace inkflate {

char const* error_code_name(ErrorCode code) {
  switch (code) {
    case ErrorCode::BadInput:
      return "bad_input";
    case ErrorCode::BadOption:
      return "bad_option";
    case ErrorCode::TooLarge:
      return "too_large";
    case ErrorCode::Unsupported:
      return "unsupported";
    case ErrorCode::NothingThere:
      return "nothing_there";
    case ErrorCode::Cancelled:
      return "cancelled";
    case ErrorCode::FileSystem:
      return "file_system";
  }
  CHECK(false, "unknown error code");
}

}  // namespace inkflate
