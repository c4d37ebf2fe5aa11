// SPDX-License-Identifier: BSL-1.0
#include <tuple>

#include <carom/properties/plan/candidate.hpp>

namespace carom::properties::plan {

bool is_less(const Candidate& x, const Candidate& y) {
  // The enumeration `Law` lists the cheapest law first.
  const auto key = [](const Candidate& c) {
    return std::tuple(c.subject.law, c.scalar_rank, c.solve_rank, c.frame, c.subject.name);
  };
  return key(x) < key(y);
}

bool differ_in_precision_alone(const Candidate& x, const Candidate& y) {
  const auto rest = [](const Candidate& c) { return std::tuple(c.subject.law, c.solve, c.frame, c.is_batch); };
  return rest(x) == rest(y) && x.scalar_rank != y.scalar_rank;
}

}  // namespace carom::properties::plan
