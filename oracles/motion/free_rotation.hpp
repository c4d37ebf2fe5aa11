// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>

#include <carom/collision/vector.hpp>
#include <carom/oracles/motion/known.hpp>

namespace carom::oracles {

/// A body that turns freely. At time 0 its axes are those of the world.
struct FreeBody {
  Vector3<double> principal_inertia;  // J₁ < J₂ < J₃ < J₁ + J₂, > 0 [kg m²]
  Vector3<double> angular_velocity;   // w at time 0, with 2 E J₂ ≠ L² [rad/s]
};

/// w in body axes, by Jacobi's elliptic functions (L. Landau, E. Lifshitz, Mechanics, §37).
[[nodiscard]] std::array<Known, 3> free_angular_velocity(const FreeBody& body, double time);

/// A unit quaternion from body axes to world axes. The exact attitude is within `bound`, an angle in rad.
struct KnownAttitude {
  Quaternion<double> value{1, 0, 0, 0};
  double bound = 0;
};

/// The attitude: short Taylor series of q' = ½ q w, one after the other, each from the w of Jacobi's functions. A
/// rotation keeps the error of an attitude, so the bound is the sum of the errors of the series.
[[nodiscard]] KnownAttitude free_attitude(const FreeBody& body, double time);

}  // namespace carom::oracles
