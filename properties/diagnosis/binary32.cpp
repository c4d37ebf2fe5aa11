// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <carom/properties/diagnosis/binary32.hpp>
#include <carom/properties/diagnosis/evidence.hpp>

namespace carom::properties::diagnosis {
namespace {

bool is_binary32(double x) {
  return std::abs(x) <= std::numeric_limits<float>::max() && static_cast<double>(static_cast<float>(x)) == x;
}

/// Whether x has more than 20 significant bits.
bool is_long(double x) {
  int exponent = 0;
  const double scaled = std::ldexp(std::frexp(x, &exponent), 20);
  return scaled != std::trunc(scaled);
}

}  // namespace

void NarrowAnswers::add(const Collision& collision, const Outcome<double>& outcome) {
  const Outcome<double> unchanged_outcome = unchanged(collision);
  const auto before = vectors(unchanged_outcome);
  const auto after = vectors(outcome);
  bool tells = false;
  for (const OutcomeVector k : all_outcome_vectors) {
    for (int i = 0; i < 3; ++i) {
      const double x = (*after[k])[i];
      const double x_before = (*before[k])[i];
      fit_ = fit_ && (x == x_before || is_binary32(x));
      tells = tells || (x != x_before && is_long(x) && !is_binary32(x_before));
    }
  }
  ++count_;
  telling_ += tells ? 1 : 0;
}

bool NarrowAnswers::are_binary32() const { return fit_ && telling_ >= least_violated; }

Fault NarrowAnswers::fault(Precision claimed) const {
  return {fmt::format("Every velocity in its {} examined answers fits binary32, but it claims {}: it computes or "
                      "stores velocities in single precision.",
                      count_, name_of(claimed)),
          "the claimed precision, and conversions to float"};
}

}  // namespace carom::properties::diagnosis
