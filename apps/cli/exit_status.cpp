// SPDX-License-Identifier: Apache-2.0
#include "cli/exit_status.h"

#include <signal.h>
#include <unistd.h>

#include <array>

namespace inkflate::cli {
namespace {

// Only calls that are allowed inside a signal handler.
void end_with_fault(int /*signal*/) {
  constexpr std::array message = {
      "inkflate: this is our own fault; please report what led to it\n"};
  std::size_t size = 0;
  while (message[0][size] != '\0') ++size;
  if (::write(STDERR_FILENO, message[0], size) < 0) {
    // Nowhere left to say it.
  }
  ::_exit(static_cast<int>(ExitStatus::OurOwnFault));
}

}  // namespace

ExitStatus exit_status(ErrorCode code) {
  switch (code) {
    case ErrorCode::BadOption:
      return ExitStatus::WrongUsage;
    case ErrorCode::BadInput:
    case ErrorCode::TooLarge:
    case ErrorCode::Unsupported:
    case ErrorCode::NothingThere:
      return ExitStatus::InputRefused;
    case ErrorCode::FileSystem:
      return ExitStatus::CannotReadOrWrite;
    case ErrorCode::Cancelled:  // nobody can cancel here
      return ExitStatus::OurOwnFault;
  }
  CHECK(false, "unknown error code");
}

void end_faults_with_status() {
  // A closed pipe is an ordinary write error.
  ::signal(SIGPIPE, SIG_IGN);
#ifndef INKFLATE_SANITIZE  // the sanitizers tell more
  // An own stack, because the program's may be what ran out.
  static std::array<char, 16384> stack;
  stack_t alternative = {};
  alternative.ss_sp = stack.data();
  alternative.ss_size = stack.size();
  ::sigaltstack(&alternative, nullptr);
  struct sigaction action = {};
  action.sa_handler = end_with_fault;
  action.sa_flags = SA_ONSTACK;
  for (int const signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL}) {
    ::sigaction(signal, &action, nullptr);
  }
#else
  static_cast<void>(end_with_fault);
#endif
}

}  // namespace inkflate::cli
