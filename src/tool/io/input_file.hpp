// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <carom/properties/families/family.hpp>

#include "io/json_file.hpp"

namespace carom::tool {

/// What a witness adds to its collision.
struct WitnessFacts {
  std::string subject;  // as the command line names it
  std::string invariant;

  /// Whether that speaks of invalid collisions.
  [[nodiscard]] bool is_of_invalid() const;
};

/// A collision read from a file.
struct ReadCollision {
  std::string place;  // "FILE", "FILE:7" for a line, "FILE: /3" for an element of an array
  properties::Case one;
  std::optional<WitnessFacts> witness;
  std::string contact_class = {};  // the field `class`; empty where there is none
};

/// Whether a collision of which ε, μ or e_t is out of range, and nothing else is wrong, is read all the same.
enum class OutOfRange { refused, kept };

/// Which collision of a witness is read: that which was shrunk, or that which its family drew.
enum class OfWitness { shrunk, drawn };

/// Gives each collision of the file to `visit`, in order: of a witness, a collision, an array of either, or JSON Lines
/// of either, which are read as they are visited. Throws UsageError that names the file, the place in it, and what was
/// expected, also where a collision is invalid; a witness that an invalid collision was answered is an exception. A
/// collision may have the class of its contact beside its fields, or beside itself in a record that holds it: `"class":
/// "crate on floor"`. Where drawn ones are wanted, each has to be a witness.
void for_each_collision(JsonFile& file, OutOfRange out_of_range, const std::function<void(const ReadCollision&)>& visit,
                        OfWitness of_witness = OfWitness::shrunk);

}  // namespace carom::tool
