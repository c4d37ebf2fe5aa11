// SPDX-License-Identifier: BSL-1.0
#include <carom/properties/features/feature_groups.hpp>
#include <carom/properties/features/geometry.hpp>

namespace carom::properties::features {
namespace {

using V = Vector3<double>;

/// Turns the lever arm along this direction and keeps about its length. Does nothing if the direction is zero.
void turn_along(Collision& c, Body& b, const V& direction) {
  if (!is_zero(direction)) {
    set_exact_lever_arm(c, b, turned_along(lever_arm(c, b), with_few_bits(direction)));
  }
}

V some_axis(Stream& stream) {
  V axis = V::Zero();
  const int which = stream.integer(0, 2);
  axis[which] = stream.chance(2) ? 1 : -1;
  return axis;
}

}  // namespace

std::vector<Feature> of_lever_arm() {
  constexpr auto special = FeatureKind::special_value;
  constexpr auto relation = FeatureKind::relation;
  return for_both({
      {"at_origin", special, "the centre of mass is at the origin",
       "X may be missing, or confused with the body's origin (failure case 7)", false,
       [](const Collision&, const Body& b) { return is_zero(b.position); },
       [](Stream&, Collision& c, Body& b) {
         Body& other = &b == &c.a ? c.b : c.a;
         const V of_other = lever_arm(c, other);
         c.point = lever_arm(c, b);
         b.position.setZero();
         other.position = c.point - of_other;
       }},
      {"lever_arm_zero", special, "the contact is at the centre of mass", "r = 0 (failure case 6)", false,
       [](const Collision& c, const Body& b) { return is_zero(lever_arm(c, b)); },
       [](Stream&, Collision& c, Body& b) { b.position = c.point; }},
      {"lever_arm_along_axis", special, "the lever arm lies along a coordinate axis",
       "a box that is hit at the middle of a face", false,
       [](const Collision& c, const Body& b) { return nonzero_components(lever_arm(c, b)) == 1; },
       [](Stream& stream, Collision& c, Body& b) { turn_along(c, b, some_axis(stream)); }},
      {"lever_arm_in_plane", special, "exactly one component of the lever arm is zero",
       "a box that is hit at the middle of an edge", false,
       [](const Collision& c, const Body& b) { return nonzero_components(lever_arm(c, b)) == 2; },
       [](Stream& stream, Collision& c, Body& b) {
         V r = with_few_bits(lever_arm(c, b));
         const int zero = stream.integer(0, 2);
         for (int i = 0; i < 3; ++i) {
           r[i] = i == zero ? 0 : (r[i] == 0 ? size_of(r) : r[i]);
         }
         set_exact_lever_arm(c, b, r);
       }},
      {"lever_arm_along_normal", relation, "the lever arm lies along the normal",
       "spheres; a solver may skip the terms with r × N = 0", false,
       [](const Collision& c, const Body& b) { return are_parallel(lever_arm(c, b), c.normal); },
       [](Stream& stream, Collision& c, Body& b) {
         c.normal = with_few_bits(c.normal);
         turn_along(c, b, stream.chance(4) ? negated(c.normal) : (&b == &c.a ? negated(c.normal) : c.normal));
       }},
      {"lever_arm_across_normal", relation, "the lever arm is orthogonal to the normal",
       "a glancing hit at the end of a rod", false,
       [](const Collision& c, const Body& b) { return are_orthogonal(lever_arm(c, b), c.normal); },
       [](Stream& stream, Collision& c, Body& b) {
         c.normal = with_few_bits(c.normal);
         set_exact_lever_arm(c, b, turned_across(stream, lever_arm(c, b), c.normal));
       }},
      {"lever_arm_along_velocity", relation, "the lever arm lies along the velocity",
       "a body that flies towards its contact point", false,
       [](const Collision& c, const Body& b) { return are_parallel(lever_arm(c, b), b.velocity); },
       [](Stream&, Collision& c, Body& b) {
         if (is_zero(b.velocity)) {
           b.velocity = V{1, 0.5, -0.25};
         }
         b.velocity = with_few_bits(b.velocity);
         turn_along(c, b, b.velocity);
       }},
  });
}

}  // namespace carom::properties::features
