// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <carom/properties/cases/family.hpp>

#include "io/json_file.hpp"

namespace carom::tool {

/// The facts that a witness (a violation that can be replayed) adds to its collision.
struct WitnessFacts {
  std::string subject;  // as the command line names it
  std::string invariant;
  std::optional<Law> law = {};  // that the subject claims

  /// Whether the invariant is about invalid collisions.
  [[nodiscard]] bool is_of_invalid() const;
};

struct ReadCollision {
  std::string place;  // "FILE", "FILE:7" for a line, "FILE: element 3" for an element of an array
  properties::Case one;
  std::optional<WitnessFacts> witness;
  std::string contact_class = {};  // the field `class`; empty if there is none
};

/// Whether to keep a collision whose only defects are ε, μ or e_t out of range.
enum class OutOfRange { refused, kept };

/// The collision to read from a witness: the shrunk one, or the one that the family drew.
enum class OfWitness { shrunk, drawn };

/// Passes each collision of the file to `visit`, in order. The file is one witness or collision, an array of them, or
/// JSON Lines of them. Each line is visited before the next line is read. The field `class` of a collision, or of the
/// record that holds it, names the class of the contact. Throws UsageError that names the file, the place, and what was
/// expected. An invalid collision is an error, too, unless its witness is about invalid collisions. If `of_witness` is
/// `drawn`, every record must be a witness.
void for_each_collision(JsonFile& file, OutOfRange out_of_range, const std::function<void(const ReadCollision&)>& visit,
                        OfWitness of_witness = OfWitness::shrunk);

}  // namespace carom::tool
