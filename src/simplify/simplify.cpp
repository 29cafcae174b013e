// SPDX-License-Identifier: Apache-2.0
#include "simplify/simplify.h"

namespace inkflate {

Result<Drawing> simplify(Sketch const& sketch, SimplifyOptions const& /*options*/,
                         Progress const& /*progress*/) {
  return Drawing{sketch, {}, {}};  // in work
}

}  // namespace inkflate
