// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/families/family.hpp>

/// Impacts that others have published, with rigid-body answers that can be written down.
namespace carom::properties {

inline constexpr int chung_ooi_count = 8;

/// The benchmark impact of that number, 1 to 8, of Y. Chung, J. Ooi, "Benchmark tests for verifying discrete element
/// modelling codes at particle impact level", Granular Matter 13, 2011, its varied quantity drawn: spheres of uniform
/// density (2700 kg/m³: no velocity depends on it) that meet, or a plane y = 0 below one; e_t = 0.
///
///   1 two equal spheres, head-on             5 oblique, of one normal velocity
///   2 a sphere on the plane, normally, ε = 1 6 spinning, on the plane
///   3 the same with any ε                    7 two spheres of opposite equal spins
///   4 oblique, of one speed                  8 two spheres of different sizes and spins
[[nodiscard]] Case chung_ooi_impact(int number, Stream& stream);

/// One of them.
[[nodiscard]] Case chung_ooi(Stream& stream);

}  // namespace carom::properties
