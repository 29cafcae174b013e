// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

#include "base/rng.h"
#include "document/command.h"
#include "document/document.h"
#include "support/random_document.h"

namespace inkflate::test {

/// What a random command shall be like.
enum class Wish {
  Sensible,  // one that the document allows, wherever it allows any of this kind
  Hostile,   // with wrong ids and indices, empty lists, numbers that are none or huge
};

/// A command of one kind: its place in Command.
Command random_command(Rng& rng, Document const& document, int kind, Wish wish);

/// One of any kind, nine of ten sensible. Documents that only such commands change stay small.
Command random_command(Rng& rng, Document const& document);

inline constexpr int kCommandKinds = static_cast<int>(std::variant_size_v<Command>);

}  // namespace inkflate::test
