// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <optional>

#include <carom/scene/prediction.hpp>

namespace carom::scene {
namespace {

using Bernstein = std::array<double, 5>;

struct Halves {
  Bernstein first, second;
};

/// De Casteljau's subdivision at a share of the interval.
Halves divided(const Bernstein& whole, double share) {
  Bernstein row = whole;
  Halves halves{};
  for (std::size_t level = 0; level < 5; ++level) {
    halves.first[level] = row[0];
    halves.second[4 - level] = row[4 - level];
    for (std::size_t k = 0; k + level < 4; ++k) {
      row[k] = (1 - share) * row[k] + share * row[k + 1];
    }
  }
  return halves;
}

/// The search divides an interval at this share of its length if the sign in the middle is not certain.
constexpr double beside_the_middle = 15.0 / 32;

/// The first part of [begin, end] in which the quartic is not certainly positive, as narrow as the bounds allow.
/// `error` bounds the error of each coefficient. A subdivision computes four rows, with three roundings each.
std::optional<Crossing> first_in(const Bernstein& b, double begin, double end, double error, double resolution) {
  const auto [least, greatest] = std::minmax_element(b.begin(), b.end());
  if (*least > error) {
    return std::nullopt;
  }
  const bool crosses = b[0] > error && b[4] < -error;
  const Crossing here{Decision::bounded, 0.5 * (begin + end), 0.5 * (end - begin) * (1 + 4 * roundoff)};
  const bool is_least = end - begin <= resolution || here.s <= begin || here.s >= end;
  if (is_least || *greatest <= error) {
    return crosses ? here : Crossing{Decision::undecided};
  }
  const double divided_error = error + 12 * roundoff * std::max(*greatest, -*least);
  double share = 0.5;
  Halves halves = divided(b, share);
  if (std::abs(halves.first[4]) <= divided_error) {
    share = beside_the_middle;
    halves = divided(b, share);
    // The sign is uncertain at both points of division. So the quartic is hardly larger than its error, and a further
    // division is useless.
    if (crosses && std::abs(halves.first[4]) <= divided_error) {
      return here;
    }
  }
  const double middle = begin + share * (end - begin);
  if (auto found = first_in(halves.first, begin, middle, divided_error, resolution)) {
    return found;
  }
  return first_in(halves.second, middle, end, divided_error, resolution);
}

}  // namespace

UncertainQuartic squared_gap(const RelativeState& pair, const Path& a, const Path& b, double span) {
  // The squared gap as a polynomial in τ on [0, 1], with s = τ span.
  const Vector3<double>& d = pair.distance;
  const Vector3<double> v = pair.velocity * span;
  const Vector3<double> h = (a.acceleration - b.acceleration) * (0.5 * span * span);
  const std::array<double, 5> power{d.dot(d) - pair.radii * pair.radii, 2 * d.dot(v), v.dot(v) + 2 * d.dot(h),
                                    2 * v.dot(h), h.dot(h)};
  // Bernstein coefficient j is the sum over k of shares[j][k] power[k], with shares[j][k] = C(j, k)/C(4, k) and
  // binomials C.
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
  // If the error of d + v τ + h τ² is at most `error`, the error of its square is at most (2 size + error) error. The
  // products and sums have fewer than 24 roundings.
  return {bernstein, (2 * size + error) * error + 24 * roundoff * (size * size + pair.radii * pair.radii), span};
}

Crossing first_crossing(const UncertainQuartic& quartic) {
  return first_in(quartic.bernstein, 0, quartic.span, quartic.error, quartic.span * 0x1p-56).value_or(Crossing{});
}

namespace {

TimeBounds up_to(double horizon, const TimeBounds& bounds) { return bounds.earliest > horizon ? TimeBounds{} : bounds; }

template <class Other>
TimeBounds exactly(const Path& path, const Other& other, double now, double horizon, ExactCounts& counts) {
  ++counts.predictions;
  const std::optional<ExactTime> contact = exact_contact(path, other, now);
  return contact ? up_to(horizon, contact->bounds()) : TimeBounds{};
}

/// If bounds are wider than this share of the time to the horizon, exact bounds replace them, because other events
/// would fall between wide bounds.
constexpr double widest_share = 0x1p-24;

TimeBounds bounded_or_exact(const Crossing& crossing, const auto& exactly, double now, double horizon) {
  switch (crossing.decision) {
    case Decision::none:
      return {};
    case Decision::bounded:
      if (crossing.error <= widest_share * (horizon - now)) {
        return up_to(horizon, bounds_from(now, crossing));
      }
      break;
    case Decision::undecided:
      break;
  }
  return exactly();
}

}  // namespace

TimeBounds contact_between(const Path& a, const Path& b, const RelativeState& pair, double now, double horizon,
                           ExactCounts& counts) {
  Crossing crossing;
  if (a.acceleration == b.acceleration) {
    crossing = first_crossing(squared_gap(pair));
  } else if (horizon > now) {
    crossing = first_crossing(squared_gap(pair, a, b, horizon - now));
  }
  return bounded_or_exact(
      crossing, [&] { return exactly(a, b, now, horizon, counts); }, now, horizon);
}

TimeBounds contact_between(const Path& sphere, const Reach& plane, double now, double horizon, ExactCounts& counts) {
  const Crossing crossing = first_crossing(height_over(sphere, plane, now));
  return bounded_or_exact(
      crossing, [&] { return exactly(sphere, plane, now, horizon, counts); }, now, horizon);
}

}  // namespace carom::scene
