// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>

#include "document/document.h"

namespace inkflate {

/// The document without these pins and their tracks.
Document without_pins(Document document, std::set<PinId> const& gone);

}  // namespace inkflate
