// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <carom/properties/families/family.hpp>

namespace carom::tool {

/// What a witness adds to its collision.
struct WitnessFacts {
  std::string subject;  // as the command line names it
  std::string invariant;
};

/// A collision read from a file.
struct ReadCollision {
  std::string place;  // "FILE", "FILE:7" for a line, "FILE: /3" for an element of an array
  properties::Case one;
  std::optional<WitnessFacts> witness;
  std::string contact_class = {};  // the field `class`; empty where there is none
};

/// The whole of a file. Throws UsageError, which names it, where it cannot be read.
[[nodiscard]] std::string content_of_file(const std::string& file);

/// Whether a collision of which ε, μ or e_t is out of range, and nothing else is wrong, is read all the same.
enum class OutOfRange { refused, kept };

/// Reads a witness, a collision, an array of either, or JSON Lines of either. Throws UsageError that names the file,
/// the place in it, and what was expected, also where a collision is invalid; a witness that an invalid collision was
/// answered is an exception. A collision may have the class of its contact beside its fields, or beside itself in a
/// record that holds it: `"class": "crate on floor"`.
[[nodiscard]] std::vector<ReadCollision> read_collisions(const std::string& file,
                                                         OutOfRange out_of_range = OutOfRange::refused);

/// The same of the text that such a file holds.
[[nodiscard]] std::vector<ReadCollision> collisions_of(const std::string& text, const std::string& file,
                                                       OutOfRange out_of_range = OutOfRange::refused);

}  // namespace carom::tool
