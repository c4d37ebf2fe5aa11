// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <carom/properties/features/feature_groups.hpp>
#include <carom/properties/features/geometry.hpp>

namespace carom::properties::features {
namespace {

using V = Vector3<double>;

V along_axis(Stream& stream, const V& v) {
  V result = V::Zero();
  const int axis = stream.integer(0, 2);
  result[axis] = stream.chance(2) ? size_of(v) : -size_of(v);
  return result;
}

bool has_minus_zero(const V& v) {
  for (int i = 0; i < 3; ++i) {
    if (v[i] == 0 && std::signbit(v[i])) {
      return true;
    }
  }
  return false;
}

std::vector<BodyFeature> of_velocity() {
  constexpr auto special = FeatureKind::special_value;
  constexpr auto relation = FeatureKind::relation;
  return {
      {"velocity_zero", special, "the velocity is zero", "a body at rest, or one that spins in place", false,
       [](const Collision&, const Body& b) { return is_zero(b.velocity); },
       [](Stream&, Collision&, Body& b) { b.velocity.setZero(); }},
      {"velocity_along_axis", special, "the velocity has one nonzero component",
       "the first scene that a programmer tries", false,
       [](const Collision&, const Body& b) { return nonzero_components(b.velocity) == 1; },
       [](Stream& stream, Collision&, Body& b) { b.velocity = along_axis(stream, b.velocity); }},
      {"velocity_in_plane", special, "the velocity has two nonzero components", "scenes in a plane", false,
       [](const Collision&, const Body& b) { return nonzero_components(b.velocity) == 2; },
       [](Stream& stream, Collision&, Body& b) { put_in_plane(stream, b.velocity); }},
      {"velocity_ties", special, "two components of the velocity have the same nonzero magnitude",
       "a search for the largest component has two results", false,
       [](const Collision&, const Body& b) { return has_ties(b.velocity); },
       [](Stream& stream, Collision&, Body& b) {
         const int from = stream.integer(0, 2);
         if (b.velocity[from] == 0) {
           b.velocity[from] = size_of(b.velocity);
         }
         b.velocity[(from + 1) % 3] = stream.chance(2) ? b.velocity[from] : -b.velocity[from];
       }},
      {"velocity_along_normal", relation, "the velocity lies along the normal", "the drop test", false,
       [](const Collision& c, const Body& b) { return are_parallel(b.velocity, c.normal); },
       [](Stream&, Collision& c, Body& b) {
         b.velocity = turned_along(b.velocity, &b == &c.a ? negated(c.normal) : c.normal);
       }},
      {"velocity_across_normal", relation, "the velocity is orthogonal to the normal",
       "a sliding body, or a body that only the other one approaches", false,
       [](const Collision& c, const Body& b) { return are_orthogonal(b.velocity, c.normal); },
       [](Stream& stream, Collision& c, Body& b) {
         c.normal = with_few_bits(c.normal);
         b.velocity = turned_across(stream, b.velocity, c.normal);
       }},
      {"minus_zero", special, "a component of the velocity or of the spin is −0",
       "copysign, 1/x, and signs read from bits", false,
       [](const Collision&, const Body& b) { return has_minus_zero(b.velocity) || has_minus_zero(b.angular_velocity); },
       [](Stream& stream, Collision&, Body& b) {
         const int component = stream.integer(0, 2);
         V& v = stream.chance(2) ? b.velocity : b.angular_velocity;
         v[component] = -0.0;
       }},
  };
}

std::vector<BodyFeature> of_spin() {
  constexpr auto special = FeatureKind::special_value;
  constexpr auto relation = FeatureKind::relation;
  return {
      {"spin_zero", special, "the body does not spin", "the body moves like a point mass", false,
       [](const Collision&, const Body& b) { return is_zero(b.angular_velocity); },
       [](Stream&, Collision&, Body& b) { b.angular_velocity.setZero(); }},
      {"spin_along_axis", special, "the angular velocity has one nonzero component", "scenes in a plane", false,
       [](const Collision&, const Body& b) { return nonzero_components(b.angular_velocity) == 1; },
       [](Stream& stream, Collision&, Body& b) { b.angular_velocity = along_axis(stream, b.angular_velocity); }},
      {"spin_along_normal", relation, "the body spins about the normal",
       "a solver may add this spin to the slip (failure case 56)", false,
       [](const Collision& c, const Body& b) { return are_parallel(b.angular_velocity, c.normal); },
       [](Stream& stream, Collision& c, Body& b) {
         b.angular_velocity = turned_along(b.angular_velocity, stream.chance(2) ? c.normal : negated(c.normal));
       }},
      {"spin_across_normal", relation, "the spin is orthogonal to the normal", "a rolling body", false,
       [](const Collision& c, const Body& b) { return are_orthogonal(b.angular_velocity, c.normal); },
       [](Stream& stream, Collision& c, Body& b) {
         c.normal = with_few_bits(c.normal);
         b.angular_velocity = turned_across(stream, b.angular_velocity, c.normal);
       }},
      {"spin_along_lever_arm", relation, "the spin lies along the lever arm",
       "w × r = 0, although neither w nor r is zero", false,
       [](const Collision& c, const Body& b) { return are_parallel(b.angular_velocity, lever_arm(c, b)); },
       [](Stream& stream, Collision& c, Body& b) {
         if (is_zero(lever_arm(c, b))) {
           set_exact_lever_arm(c, b, along_axis(stream, V(1, 0, 0)));
         }
         b.angular_velocity = turned_along(b.angular_velocity, lever_arm(c, b));
       }},
      {"spin_along_velocity", relation, "the spin lies along the velocity", "a bullet", false,
       [](const Collision&, const Body& b) { return are_parallel(b.angular_velocity, b.velocity); },
       [](Stream& stream, Collision&, Body& b) {
         if (is_zero(b.velocity)) {
           b.velocity = along_axis(stream, b.velocity);
         }
         b.angular_velocity = turned_along(b.angular_velocity, b.velocity);
       }},
      {"spin_equals_velocity", relation, "the angular velocity has the same components as the velocity",
       "the two vectors may be confused", false,
       [](const Collision&, const Body& b) { return !is_zero(b.velocity) && b.velocity == b.angular_velocity; },
       [](Stream& stream, Collision&, Body& b) {
         if (is_zero(b.velocity)) {
           b.velocity = along_axis(stream, b.velocity);
         }
         b.angular_velocity = b.velocity;
       }},
      {"rolling", relation, "the body moves, but its contact point does not", "the body rolls on the other one", false,
       [](const Collision& c, const Body& b) {
         return !is_zero(b.velocity) && b.velocity == cross(lever_arm(c, b), b.angular_velocity);
       },
       [](Stream& stream, Collision& c, Body& b) {
         if (is_zero(b.angular_velocity)) {
           b.angular_velocity = V{0.5, -1, 0.75};
         }
         if (stream.chance(4)) {
           // If r is orthogonal to N, r × (N × r) = ‖r‖² N: the body rolls along the normal.
           c.normal = with_few_bits(c.normal);
           const V r = with_few_bits(turned_across(stream, lever_arm(c, b), c.normal));
           set_exact_lever_arm(c, b, r);
           b.angular_velocity = cross(c.normal, r) * (size_of(b.angular_velocity) / size_of(r) / size_of(c.normal));
         }
         b.velocity = cross(lever_arm(c, b), b.angular_velocity);
       }},
  };
}

}  // namespace

std::vector<Feature> of_velocities() {
  std::vector<BodyFeature> features = of_velocity();
  for (const BodyFeature& feature : of_spin()) {
    features.push_back(feature);
  }
  features.push_back({"at_rest", FeatureKind::special_value, "the body neither moves nor spins",
                      "a target, a floor, a sleeping body", false,
                      [](const Collision&, const Body& b) { return is_at_rest(b); },
                      [](Stream&, Collision&, Body& b) {
                        b.velocity.setZero();
                        b.angular_velocity.setZero();
                      }});
  return for_both(features);
}

namespace {

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
         put_in_plane(stream, r);
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
