// SPDX-License-Identifier: GPL-3.0-or-later
// The reader of what `carom replay` is given: witnesses and collisions, one, an array or lines of them. What it does
// not take is a UsageError; what it takes is valid, unless it says that it is not.
#include <carom/collision/validate.hpp>

#include "commands/commands.hpp"
#include "commands/input_file.hpp"
#include "input.hpp"
#include "target.hpp"

namespace carom::fuzz {
namespace {

void read(std::string_view text) {
  try {
    for (const tool::ReadCollision& read : tool::collisions_of(std::string(text), "input")) {
      const bool may_be_invalid = read.witness && read.witness->invariant == "invalid_refused";
      require(may_be_invalid || validate(read.one.collision).empty(), "an invalid collision was taken for a valid one");
    }
  } catch (const tool::UsageError&) {
    return;
  }
}

}  // namespace
}  // namespace carom::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  carom::fuzz::read(carom::fuzz::Input({data, size}).text());
  return 0;
}
