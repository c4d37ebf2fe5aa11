// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <carom/properties/draws/relative_velocity.hpp>
#include <carom/properties/features/feature_groups.hpp>
#include <carom/properties/features/geometry.hpp>

namespace carom::properties::features {
namespace {

using V = Vector3<double>;

/// The normal speed v_n and the tangential speed v_t, times ‖N‖: |N·V⁻| and ‖N × V⁻‖.
struct Parts {
  double normal;
  double tangential;
};

/// Whether a part is positive but less than about √u times the other, with u = 2⁻⁵³. In the sum of both squares,
/// rounding then loses the square of the part.
bool is_slight(double part, double other) {
  constexpr double slight = 1e-8;
  return part > 0 && part < slight * other;
}

Parts parts_of(const Collision& c) {
  const V v = relative_velocity(c);
  return {std::abs(dot(c.normal, v)), length(cross(c.normal, v))};
}

/// Makes w × r = 0, so V⁻ = v_A − v_B without the rounding of a cross product.
void spin_along_lever_arms(Collision& c) {
  for (Body* b : {&c.a, &c.b}) {
    if (!is_zero(b->angular_velocity) && !is_zero(lever_arm(c, *b))) {
      b->angular_velocity = turned_along(b->angular_velocity, lever_arm(c, *b));
    }
  }
}

/// Sets V by the velocity of one body. The other velocity gets few bits, so the sum is exact.
void set_approach(Stream& stream, Collision& c, const V& relative) {
  spin_along_lever_arms(c);
  if (stream.chance(2)) {
    c.b.velocity = with_few_bits(c.b.velocity);
    c.a.velocity = c.b.velocity + relative;
  } else {
    c.a.velocity = with_few_bits(c.a.velocity);
    c.b.velocity = c.a.velocity - relative;
  }
}

/// Stops one body, whose velocity could swamp the smaller parts of V.
void rest_one(Stream& stream, Collision& c) { (stream.chance(2) ? c.a : c.b).velocity.setZero(); }

/// Lets the spin of A alone cause V. A's lever arm r becomes orthogonal to N, so (N × r) × r = −‖r‖² N. V is a positive
/// multiple of −N + δ N × r / ‖r‖, with δ between `across`/2 and `across`.
void approach_by_spin_of_a(Stream& stream, Collision& c, double across) {
  const V r = with_few_bits(turned_across(stream, lever_arm(c, c.a), c.normal));
  const double spin = size_of(c.a.angular_velocity) / size_of(r) / size_of(c.normal);
  set_exact_lever_arm(c, c.a, r);
  c.a.angular_velocity = plus(cross(c.normal, r), c.normal, across * size_of(r)) * spin;
  if (!is_zero(c.b.angular_velocity) && !is_zero(lever_arm(c, c.b))) {
    c.b.angular_velocity = turned_along(c.b.angular_velocity, lever_arm(c, c.b));
  }
  if (stream.chance(2)) {
    c.a.velocity.setZero();
  }
  c.b.velocity = c.a.velocity;
}

double speed(const Collision& c) { return size_of(relative_velocity(c)); }

}  // namespace

// NOLINTNEXTLINE(readability-function-size): a table
std::vector<Feature> of_approach() {
  return {
      pair_relation(
          "head_on", "V⁻ lies along the normal",
          "a tangent basis that is built from V⁻ has no direction (failure case 3)",
          [](const Collision& c) { return are_parallel(relative_velocity(c), c.normal); },
          [](Stream& stream, Collision& c) {
            c.normal = with_few_bits(c.normal);
            if (stream.chance(4)) {
              approach_by_spin_of_a(stream, c, 0);
              return;
            }
            const V approach = negated(c.normal) * (speed(c) / size_of(c.normal));
            if (stream.chance(2)) {
              rest_one(stream, c);
            }
            set_approach(stream, c, approach);
          }),
      pair_relation(
          "near_head_on", "v_t is not zero, and is less than 10⁻⁸ v_n",
          "a tangent basis that is built from V⁻ is rounding noise",
          [](const Collision& c) {
            const Parts parts = parts_of(c);
            return is_slight(parts.tangential, parts.normal);
          },
          [](Stream& stream, Collision& c) {
            c.normal = with_few_bits(c.normal);
            if (stream.chance(4)) {
              approach_by_spin_of_a(stream, c, 0x1p-32);
              return;
            }
            const V along = negated(c.normal) * (speed(c) / size_of(c.normal));
            const V across = turned_across(stream, along, c.normal);
            const double ratio = stream.power_of_two(-40, -28);
            rest_one(stream, c);
            set_approach(stream, c, plus(along, across, ratio));
          }),
      pair_relation(
          "grazing", "v_n is not zero, and is less than 10⁻⁸ v_t", "thresholds on the approach (failure cases 38, 39)",
          [](const Collision& c) {
            const Parts parts = parts_of(c);
            return is_slight(parts.normal, parts.tangential);
          },
          [](Stream& stream, Collision& c) {
            c.normal = with_few_bits(c.normal);
            const V along = negated(c.normal) * (speed(c) / size_of(c.normal));
            const V across = turned_across(stream, along, c.normal);
            const double ratio = stream.power_of_two(-40, -28);
            rest_one(stream, c);
            set_approach(stream, c, plus(across, along, ratio));
          }),
      pair_relation(
          "approach_along_axis", "V⁻ has one nonzero component", "terms of r × V and K V vanish",
          [](const Collision& c) { return nonzero_components(relative_velocity(c)) == 1; },
          [](Stream& stream, Collision& c) {
            V approach = V::Zero();
            int axis = stream.integer(0, 2);
            while (c.normal[axis] == 0) {
              axis = (axis + 1) % 3;
            }
            approach[axis] = c.normal[axis] > 0 ? -speed(c) : speed(c);
            if (stream.chance(2)) {
              rest_one(stream, c);
            }
            set_approach(stream, c, approach);
          }),
      pair_relation(
          "approach_by_spin", "both velocities are zero, and the bodies approach by spin alone",
          "a solver that uses only the linear terms sees no approach",
          [](const Collision& c) { return is_zero(c.a.velocity) && is_zero(c.b.velocity); },
          [](Stream&, Collision& c) {
            c.a.velocity.setZero();
            c.b.velocity.setZero();
          }),
      pair_relation(
          "momenta_opposite", "m_A v_A = −m_B v_B ≠ 0", "in the frame of the centre of mass, sums of momenta vanish",
          [](const Collision& c) {
            return !c.a.immovable && !c.b.immovable && !is_zero(c.a.velocity) &&
                   V(c.a.velocity * c.a.mass) == V(c.b.velocity * -c.b.mass);
          },
          [](Stream& stream, Collision& c) {
            make_movable(stream, c, c.a);
            make_movable(stream, c, c.b);
            // The masses become powers of two, so their quotient is exact.
            for (Body* b : {&c.a, &c.b}) {
              int exponent = 0;
              std::frexp(b->mass, &exponent);
              b->principal_inertia *= std::ldexp(1.0, exponent - 1) / b->mass;
              b->mass = std::ldexp(1.0, exponent - 1);
            }
            Body& leads = is_zero(c.b.velocity) || (!is_zero(c.a.velocity) && stream.chance(2)) ? c.a : c.b;
            Body& follows = &leads == &c.a ? c.b : c.a;
            if (is_zero(leads.velocity)) {
              leads.velocity = negated(c.normal) / size_of(c.normal);
            }
            follows.velocity = negated(leads.velocity) * (leads.mass / follows.mass);
          }),
  };
}

}  // namespace carom::properties::features
