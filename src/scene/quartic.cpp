// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>

#include <carom/scene/quartic.hpp>

namespace carom::scene {
namespace {

using Bernstein = std::array<double, 5>;

struct Halves {
  Bernstein first, second;
};

/// De Casteljau's subdivision at the middle: each number is the mean of two, with one rounding.
Halves halved(const Bernstein& whole) {
  Bernstein row = whole;
  Halves halves{};
  for (std::size_t level = 0; level < 5; ++level) {
    halves.first[level] = row[0];
    halves.second[4 - level] = row[4 - level];
    for (std::size_t k = 0; k + level < 4; ++k) {
      row[k] = 0.5 * (row[k] + row[k + 1]);
    }
  }
  return halves;
}

struct Search {
  double error;  // of a coefficient, at any depth
  double resolution;

  /// The first part that is not certainly positive, and down to the resolution begins so and ends below 0.
  [[nodiscard]] std::optional<Crossing> first_in(const Bernstein& b, double begin, double end) const {
    if (*std::min_element(b.begin(), b.end()) > error) {
      return std::nullopt;
    }
    const double middle = 0.5 * (begin + end);
    const bool crosses = b[0] > error && b[4] < -error;
    const bool is_least = end - begin <= resolution || middle <= begin || middle >= end;
    const Halves halves = halved(b);
    // Where a half would no longer be decided, the whole is what is known.
    if (crosses && (is_least || std::abs(halves.first[4]) <= error)) {
      return Crossing{Decision::bounded, middle, 0.5 * (end - begin) * (1 + 4 * roundoff)};
    }
    if (is_least || *std::max_element(b.begin(), b.end()) <= error) {
      return Crossing{Decision::undecided};
    }
    if (auto found = first_in(halves.first, begin, middle)) {
      return found;
    }
    return first_in(halves.second, middle, end);
  }
};

}  // namespace

UncertainQuartic squared_gap(const Beside& pair, const Path& a, const Path& b, double span) {
  // Of t in [0, 1], s = t span.
  const Vector3<double>& d = pair.distance;
  const Vector3<double> v = pair.velocity * span;
  const Vector3<double> h = (a.acceleration - b.acceleration) * (0.5 * span * span);
  const std::array<double, 5> power{d.dot(d) - pair.radii * pair.radii, 2 * d.dot(v), v.dot(v) + 2 * d.dot(h),
                                    2 * v.dot(h), h.dot(h)};
  // Power k adds C(j, k)/C(4, k) of its coefficient to Bernstein coefficient j.
  Bernstein bernstein{};
  constexpr std::array<std::array<double, 5>, 5> shares{{{1, 0, 0, 0, 0},
                                                         {1, 1.0 / 4, 0, 0, 0},
                                                         {1, 2.0 / 4, 1.0 / 6, 0, 0},
                                                         {1, 3.0 / 4, 3.0 / 6, 1.0 / 4, 0},
                                                         {1, 1, 1, 1, 1}}};
  for (std::size_t j = 0; j < 5; ++j) {
    for (std::size_t k = 0; k <= j; ++k) {
      bernstein[j] += shares[j][k] * power[k];
    }
  }
  const double h_size = h.cwiseAbs().sum();
  const double size = pair.distance_size + pair.velocity_size * span + h_size;
  const double error = pair.distance_error + span * (pair.velocity_error + 4 * roundoff * pair.velocity_size) +
                       6 * roundoff * span * span * (a.acceleration_size + b.acceleration_size);
  // |d + v t + h t²|² changes by at most (2 size + error) error; products and sums have less than 24 roundings, and 60
  // halvings of four means each 240 more.
  return {bernstein, (2 * size + error) * error + (24 + 240) * roundoff * (size * size + pair.radii * pair.radii),
          span};
}

Crossing first_crossing(const UncertainQuartic& quartic) {
  const Search search{quartic.error, quartic.span * 0x1p-56};
  return search.first_in(quartic.bernstein, 0, quartic.span).value_or(Crossing{});
}

}  // namespace carom::scene
