// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <optional>

#include <carom/scene/arc.hpp>
#include <carom/scene/scene.hpp>

namespace carom::scene {

/// A plane onto which gravity presses spheres.
struct Support {
  Vector3<double> plane_normal{0, 0, 1};  // of the scene's plane, of any length
  Vector3<double> normal{0, 0, 1};        // n, the same direction with the length 1
  double pressing = 0;                    // −g·n > 0 [m/s²]
  Vector3<double> along{0, 0, 0};         // gravity along the plane [m/s²]; exactly 0 if the plane is level
};

/// The support of a plane; none if gravity does not press spheres onto it. A pressing or sloping gravity that is only
/// rounding error counts as 0. Precondition: the length of the normal is not 0.
[[nodiscard]] std::optional<Support> support_of(const Vector3<double>& plane_normal, const Vector3<double>& gravity);

/// The motion of a sphere on a plane from `start` on: it slips, rolls or rests, and spins about the normal n. Let p be
/// the pressing gravity, g gravity along the plane, and u = v − R w × n the slip, with the velocity v and the angular
/// velocity w (W. Leckie, M. Greenspan, "An event-based pool physics simulator", 2006, with a slope):
///
/// - Sliding: u' = g − (7/2) μ p u/‖u‖, and v' = g − μ p u/‖u‖.
/// - Rolling, if (2/7) ‖g‖ ≤ μ p: v' = (5/7) g − μ_r p v/‖v‖. A sphere at rest stays at rest if (5/7) ‖g‖ ≤ μ_r p.
/// - The spin about n slows by (5/2) μ_s p/R [rad/s²].
///
/// If u or v is along g, its direction is constant until it is 0, and the path is a parabola. If not, the arc ends by
/// `Ending::turn`: it holds the direction of the resistance while u or v turns by at most 2⁻⁸ rad. A slip that is only
/// rounding error counts as 0. The stored accelerations are rounded, and the path follows them exactly. The path does
/// not go below the plane. Without friction, nothing slows a sphere.
[[nodiscard]] Arc supported_arc(const Support& support, std::uint32_t plane, const MaterialPair& pair,
                                bool has_friction, double radius, double start, const Vector3<double>& position,
                                const Vector3<double>& velocity, const Vector3<double>& angular_velocity);

/// The motion after the end of an arc. The motion that ended (slip, rolling or spin) is 0 from then on, unless gravity
/// drives it again.
[[nodiscard]] Arc after_end(const Support& support, const MaterialPair& pair, bool has_friction, const Arc& ended,
                            double start, const Vector3<double>& position);

}  // namespace carom::scene
