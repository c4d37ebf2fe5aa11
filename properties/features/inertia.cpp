// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>

#include <carom/properties/features/feature_groups.hpp>
#include <carom/properties/features/geometry.hpp>

namespace carom::properties::features {
namespace {

using V = Vector3<double>;

void set_mass(Body& body, double mass) {
  body.principal_inertia *= mass / body.mass;
  body.mass = mass;
}

void sort_moments(Body& body, bool ascending) {
  V& moments = body.principal_inertia;
  if (moments[0] == moments[1] || moments[1] == moments[2] || moments[0] == moments[2]) {
    moments = V{moments[0], moments[0] * 1.25, moments[0] * 1.5};
  }
  std::sort(moments.data(), moments.data() + 3);
  if (!ascending) {
    std::swap(moments[0], moments[2]);
  }
}

bool are_equal(const V& moments) { return moments[0] == moments[1] && moments[1] == moments[2]; }

bool is_flat(const V& i) { return i[0] + i[1] == i[2] || i[1] + i[2] == i[0] || i[2] + i[0] == i[1]; }

}  // namespace

std::vector<Feature> of_inertia() {
  constexpr auto special = FeatureKind::special_value;
  constexpr auto relation = FeatureKind::relation;
  return for_both({
      {"mass_one", special, "the mass is 1", "m, 1/m and m² are equal, so an error in m has no effect", true,
       [](const Collision&, const Body& b) { return b.mass == 1; },
       [](Stream&, Collision&, Body& b) { set_mass(b, 1); }},
      {"mass_power_of_two", special, "the mass is a power of two other than 1", "1/m is exact", true,
       [](const Collision&, const Body& b) {
         int exponent = 0;
         return std::frexp(b.mass, &exponent) == 0.5 && b.mass != 1;
       },
       [](Stream& stream, Collision&, Body& b) {
         int exponent = 0;
         std::frexp(b.mass, &exponent);
         set_mass(b, std::ldexp(1.0, exponent == 1 ? stream.integer(2, 4) : exponent - 1));
       }},
      {"moments_equal", relation, "the three moments are equal", "spheres and cubes: a fast path without R", true,
       [](const Collision&, const Body& b) { return are_equal(b.principal_inertia); },
       [](Stream&, Collision&, Body& b) { b.principal_inertia.setConstant(greatest(b.principal_inertia)); }},
      {"moments_one", special, "the three moments are 1", "the default of many engines; J⁻¹ = J", true,
       [](const Collision&, const Body& b) { return b.principal_inertia == V(1, 1, 1); },
       [](Stream& stream, Collision& c, Body& b) {
         // Either the mass changes within its domain, or the size changes.
         const double mass = 3 * b.mass / sum(b.principal_inertia);
         if (mass >= least_mass && mass < largest_mass && stream.chance(2)) {
           b.mass = mass;
         }
         b.principal_inertia.setOnes();
         const V r = lever_arm(c, b);
         const double size = radius_of_gyration(b);
         if (length(r) > size) {
           set_lever_arm(c, b, turned_along(V(size, 0, 0), r));
         }
       }},
      {"moments_two_equal", relation, "exactly two moments are equal", "discs, cylinders, capsules", true,
       [](const Collision&, const Body& b) {
         const V& i = b.principal_inertia;
         return !are_equal(i) && (i[0] == i[1] || i[1] == i[2] || i[2] == i[0]);
       },
       [](Stream& stream, Collision&, Body& b) {
         V& i = b.principal_inertia;
         const int other = stream.integer(0, 2);
         i[(other + 1) % 3] = i[(other + 2) % 3];
         i[other] = i[(other + 1) % 3] * 1.5;
       }},
      {"moments_ascending", relation, "the moments ascend", "sorted moments, or eigenvalues in the order of a library",
       true,
       [](const Collision&, const Body& b) {
         return b.principal_inertia[0] < b.principal_inertia[1] && b.principal_inertia[1] < b.principal_inertia[2];
       },
       [](Stream&, Collision&, Body& b) { sort_moments(b, true); }},
      {"moments_descending", relation, "the moments descend", "a sort of the moments swaps the axes", true,
       [](const Collision&, const Body& b) {
         return b.principal_inertia[0] > b.principal_inertia[1] && b.principal_inertia[1] > b.principal_inertia[2];
       },
       [](Stream&, Collision&, Body& b) { sort_moments(b, false); }},
      {"flat", relation, "one moment is the sum of the other two",
       "a thin plate; solvers that check the triangle inequality", true,
       [](const Collision&, const Body& b) { return is_flat(b.principal_inertia); },
       [](Stream& stream, Collision&, Body& b) {
         V& i = b.principal_inertia;
         const int sum = stream.integer(0, 2);
         i[sum] = i[(sum + 1) % 3] + i[(sum + 2) % 3];
       }},
      {"immovable", special, "the body is immovable", "walls and floors (failure cases 25 to 27)", false,
       [](const Collision&, const Body& b) { return b.immovable; },
       [](Stream&, Collision& c, Body& b) {
         if (!(&b == &c.a ? c.b : c.a).immovable) {
           b.immovable = true;
           b.mass = 1;
           b.principal_inertia.setOnes();
           b.orientation = Quaternion<double>(1, 0, 0, 0);
         }
       },
       true},
  });
}

}  // namespace carom::properties::features
