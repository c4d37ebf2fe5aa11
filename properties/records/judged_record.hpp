// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <carom/collision/json/record.hpp>
#include <carom/collision/law.hpp>
#include <carom/properties/invariants/invariant.hpp>
#include <carom/properties/records/digits.hpp>

/// Recorded collisions: a collision, and the velocities after it.
namespace carom::properties::records {

/// An invariant that a record violates.
struct Broken {
  const Invariant* invariant = nullptr;
  double ratio = std::numeric_limits<double>::infinity();  // the residual divided by the permitted residual
  std::string words;                                       // the fault, with numbers: "linear momentum along y: …"
};

/// The coefficients with which a law would give the recorded velocities. A coefficient that the record does not show
/// has no value.
struct Implied {
  std::optional<double> restitution;             // ε: the contact collides
  std::optional<double> friction;                // μ: it collides, and the contact point slips afterwards
  std::optional<double> tangential_restitution;  // e_t: it collides, and the contact point slips before
};

/// Whether a law is satisfied. No value if the record lacks what the law needs, or if numbers leave their range.
using Satisfied = PerLaw<std::optional<bool>>;

struct JudgedRecord {
  Satisfied satisfied;         // of each judged law
  std::vector<Broken> broken;  // under the law, likely causes first
  Implied implied;
  bool separates = false;       // the bodies do not approach
  bool holds_reversed = false;  // whether the record holds under the law with −N; if it holds with N, false unless the
                                // digits leave open whether the bodies approach
};

/// Judges a record by the law. If `all_laws`, it also says which other laws the record satisfies.
///
/// A residual passes if it is at most a sum of two parts. The first part is 32 ulps of its scale in the precision of
/// the numbers (docs/reference/yardstick.md). The second part is the first-order effect of half a unit of the last
/// digit of each number. Precondition: the collision is valid.
[[nodiscard]] JudgedRecord judged(const Record& record, const Resolution& resolution, Law law, bool all_laws);

}  // namespace carom::properties::records
