// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/cases/family.hpp>

namespace carom::properties {

inline constexpr int chung_ooi_count = 8;

/// The impact of this number, from 1 to 8, in Y. Chung, J. Ooi, "Benchmark tests for verifying discrete element
/// modelling codes at particle impact level", Granular Matter 13, 2011. The quantity that the benchmark varies is
/// random. Two spheres meet, or one meets the plane y = 0 from above. The spheres have the uniform density 2700 kg/m³;
/// e_t = 0. Throws std::invalid_argument for any other number.
///
///   1: Two equal spheres, head-on.
///   2: A sphere on the plane, normally, ε = 1.
///   3: A sphere on the plane, normally, any ε.
///   4: A sphere on the plane, obliquely, at one speed.
///   5: A sphere on the plane, obliquely, at one normal velocity.
///   6: A spinning sphere on the plane.
///   7: Two spheres with opposite equal spins.
///   8: Two spheres with different sizes and spins.
[[nodiscard]] Case chung_ooi_impact(int number, Stream& stream);

/// One of the eight impacts, at random.
[[nodiscard]] Case chung_ooi(Stream& stream);

}  // namespace carom::properties
