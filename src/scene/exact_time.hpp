// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <compare>
#include <memory>
#include <optional>
#include <utility>

#include <carom/scene/arc.hpp>
#include <carom/scene/crossing.hpp>

namespace carom::scene {

/// A plane, for contacts with spheres of one radius. N is the plane's normal, and x the centre of a sphere. The sphere
/// is clear of the plane if N·x > `reach`, and touches the plane if N·x = `reach`.
struct Reach {
  Vector3<double> normal;  // any nonzero length
  double reach = 0;
};

/// An instant: a number or a real root of a polynomial. CGAL compares instants exactly.
class ExactTime {
 public:
  struct Instant;  // a CGAL type
  explicit ExactTime(std::shared_ptr<const Instant> instant) : instant_(std::move(instant)) {}
  /// Precondition: `time` is finite.
  [[nodiscard]] static ExactTime at(double time);

  friend std::strong_ordering operator<=>(const ExactTime& left, const ExactTime& right);
  [[nodiscard]] friend bool operator==(const ExactTime& left, const ExactTime& right) {
    return (left <=> right) == std::strong_ordering::equal;
  }
  /// The greatest double not after the instant, and the least double not before it.
  [[nodiscard]] TimeBounds bounds() const;

 private:
  std::shared_ptr<const Instant> instant_;
};

/// The first instant from `now` on at which the gap of two spheres falls below 0; none if the gap never does. With the
/// centres x and the radii R, the gap is |x_A − x_B| − R_A − R_B. A gap that only touches 0 does not fall below 0.
/// Precondition: at `now` the gap is at least 0.
[[nodiscard]] std::optional<ExactTime> exact_contact(const Path& a, const Path& b, double now);

/// The first such instant for the gap N·x − reach of a sphere and a plane, under the same precondition.
[[nodiscard]] std::optional<ExactTime> exact_contact(const Path& sphere, const Reach& plane, double now);

/// The sign of the gap at a time: −1, 0 or 1.
[[nodiscard]] int sign_of_gap(const Path& a, const Path& b, double time);
[[nodiscard]] int sign_of_gap(const Path& sphere, const Reach& plane, double time);

/// The `reach` of a plane with the normal N through the point p, for spheres of radius R: the least double that is at
/// least N·p + R |N|.
[[nodiscard]] double reach_of(const Vector3<double>& normal, const Vector3<double>& point, double radius);

}  // namespace carom::scene
