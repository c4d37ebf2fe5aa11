// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>

#include <carom/scene/prediction.hpp>
#include <carom/scene/sphere_store.hpp>

namespace carom::scene {

/// A fast test of the flying neighbours of a flying sphere. It finds neighbours that certainly neither overlap the
/// sphere now nor touch it before the horizon. It is faster than `stay_apart`, because all neighbours share one wider
/// bound of rounding errors.
///
/// Let u be `roundoff`, P and W the bounds of positions and velocities in `Extent`, and R the sum of the radii. Let d
/// be the relative position and v the relative velocity, with 1-norms of at most 2 P and 2 W. Up to a relative 10⁻⁶,
/// these are bounds of the errors of computed numbers, here and in `RelativeState`:
/// - d: 2 · 7 u P + 2 u · 2 P = 18 u P.
/// - v: 2 · 4 u W + 2 u · 2 W = 12 u W.
/// - d·v: 2 P · 12 u W + 2 W · 18 u P + 4 u · 2 P · 2 W = 76 u P W.
///
/// So the tests are certain:
/// - Receding: the test is d·v > 128 u P W as computed. If the test passes, the exact d·v is positive.
/// - Far: the test is |d| > R + m + (‖v‖₁ + 16 u W) s as computed, with m = 256 u (P + R) and the time s to the
///   horizon. If the test passes, both sides are at most 2 P. Fewer than 8 roundings cost at most 16 u P, and d has an
///   error of 18 u P. The sum is below m.
/// - No overlap: if |d| > R + m, then |d|² − R² > (|d| + R) m. The error of the squared gap in `RelativeState` is
///   smaller: at most (2√3 |d| + 18 u P) 18 u P + 8 u (3 |d|² + R²) ≤ (|d| + R) (130 u P + 8 u R).
class QuickLook {
 public:
  /// For a sphere of this radius that is `here` at `now`.
  QuickLook(const PathState& here, double radius, const Vector3<double>& gravity, const Extent& extent, double now,
            double horizon)
      : here_(here),
        gravity_(gravity),
        now_(now),
        horizon_(horizon),
        radius_(radius),
        margin_(256 * roundoff * extent.position_size),
        velocity_margin_(16 * roundoff * extent.velocity_size),
        receding_margin_(128 * roundoff * extent.position_size * extent.velocity_size) {}

  [[nodiscard]] bool stays_apart(const Track& other, double its_radius) const {
    const double s = now_ - other.start;
    const Vector3<double> position = other.position + s * (other.velocity + (0.5 * s) * gravity_);
    const Vector3<double> distance = here_.position - position;
    const Vector3<double> velocity = here_.velocity - (other.velocity + s * gravity_);
    const double span = std::max(0.0, std::min(horizon_, other.until) - now_);
    const double touching = (radius_ + its_radius) * (1 + 256 * roundoff) + margin_;
    const double reach = touching + (velocity.cwiseAbs().sum() + velocity_margin_) * span;
    const double square = distance.dot(distance);
    const bool is_far = square > reach * reach;
    const bool recedes = distance.dot(velocity) > receding_margin_;
    return is_far | (recedes & (square > touching * touching));
  }

 private:
  PathState here_;
  Vector3<double> gravity_;
  double now_, horizon_, radius_, margin_, velocity_margin_, receding_margin_;
};

}  // namespace carom::scene
