// SPDX-License-Identifier: BSL-1.0
#include <optional>

#include <carom/scene/prediction.hpp>
#include <carom/scene/quartic.hpp>

namespace carom::scene {
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
