// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <carom/properties/draws/relative_velocity.hpp>
#include <carom/properties/features/feature_groups.hpp>
#include <carom/properties/features/geometry.hpp>

namespace carom::properties::features {
namespace {

using V = Vector3<double>;

constexpr const char* axis_names[] = {"x", "y", "z"};

/// Whether the angle between the normal and this half-axis is at most about 2⁻¹⁰ rad, but not zero.
bool is_near(const V& n, int axis, double sign) {
  const double squared_rest = squared_length(n) - n[axis] * n[axis];
  return !is_zero(n) && n[axis] * sign > 0 && squared_rest > 0 && squared_rest <= 0x1p-20 * n[axis] * n[axis];
}

V near_axis(Stream& stream, double size, int axis, double sign) {
  V n;
  n[axis] = sign * size;
  for (const int other : {(axis + 1) % 3, (axis + 2) % 3}) {
    n[other] = size * stream.power_of_two(-40, -12);
  }
  return n;
}

Feature along_axis(int axis, double sign) {
  return special_value(
      std::string("normal_") + (sign > 0 ? "plus_" : "minus_") + axis_names[axis],
      std::string("the normal is exactly along ") + (sign > 0 ? "+" : "−") + axis_names[axis],
      "floors and walls; some tangent bases divide by zero here (Frisvad's basis of 2012 at −z)",
      [=](const Collision& c) { return nonzero_components(c.normal) == 1 && c.normal[axis] * sign > 0; },
      [=](Stream&, Collision& c) {
        const double size = size_of(c.normal);
        c.normal = V::Unit(axis) * (sign * size);
      });
}

Feature near_axis(int axis, double sign) {
  return special_value(
      std::string("normal_near_") + (sign > 0 ? "plus_" : "minus_") + axis_names[axis],
      std::string("the normal is within 0.001 of ") + (sign > 0 ? "+" : "−") + axis_names[axis] +
          ", and not exactly along it",
      "tangent bases have their thresholds here", [=](const Collision& c) { return is_near(c.normal, axis, sign); },
      [=](Stream& stream, Collision& c) { c.normal = near_axis(stream, size_of(c.normal), axis, sign); });
}

Feature of_length(const char* name, const char* statement, const char* why, double low, double high, int low_exponent,
                  int high_exponent) {
  return special_value(
      name, statement, why, [=](const Collision& c) { return length(c.normal) >= low && length(c.normal) < high; },
      [=](Stream& stream, Collision& c) {
        c.normal *= stream.power_of_two(low_exponent, high_exponent) / size_of(c.normal);
      });
}

std::vector<Feature> of_components() {
  return {special_value(
              "normal_in_plane", "exactly one component of the normal is zero",
              "scenes in a plane; some terms of r × N vanish",
              [](const Collision& c) { return nonzero_components(c.normal) == 2; },
              [](Stream& stream, Collision& c) { put_in_plane(stream, c.normal); }),
          special_value(
              "normal_ties", "exactly two components of the normal have the same nonzero magnitude",
              "the least or the largest component is not unique, and tangent bases choose an axis by it",
              [](const Collision& c) {
                const V n = c.normal.cwiseAbs();
                return has_ties(c.normal) && !(n[0] == n[1] && n[1] == n[2]);
              },
              [](Stream& stream, Collision& c) {
                const int from = stream.integer(0, 2);
                if (c.normal[from] == 0) {
                  c.normal[from] = size_of(c.normal);
                }
                c.normal[(from + 1) % 3] = stream.chance(2) ? c.normal[from] : -c.normal[from];
                if (std::abs(c.normal[(from + 2) % 3]) == std::abs(c.normal[from])) {
                  c.normal[(from + 2) % 3] *= 0.5;
                }
              }),
          special_value(
              "normal_diagonal", "the three components of the normal have the same magnitude",
              "no component is the largest; the test |n| ≥ 1/√3 depends on rounding",
              [](const Collision& c) {
                const V n = c.normal.cwiseAbs();
                return n[0] == n[1] && n[1] == n[2];
              },
              [](Stream& stream, Collision& c) {
                const double size = size_of(c.normal);
                for (int i = 0; i < 3; ++i) {
                  c.normal[i] = stream.chance(2) ? size : -size;
                }
              }),
          special_value(
              "normal_unit", "the normal has length 1 except for rounding, and is not along an axis",
              "the normals of most engines",
              [](const Collision& c) {
                return std::abs(squared_length(c.normal) - 1) <= 0x1p-50 && nonzero_components(c.normal) > 1;
              },
              [](Stream& stream, Collision& c) {
                if (nonzero_components(c.normal) == 1) {
                  c.normal = stream.direction();
                  c.normal[0] = 0.5;
                  c.normal[1] += c.normal[1] == 0 ? 1 : 0;
                }
                c.normal /= length(c.normal);
              })};
}

/// Lengths where solvers have thresholds. The limits define the features, and no judgement depends on them. The drawn
/// lengths are well within them, up to a factor of 2: 2⁻¹⁸ = 3.8e-6, 2⁻⁵ = 0.031, 2⁻⁴⁰ = 9.1e-13. The limit 1e-300 is
/// above the least normal number, 2.2e-308.
std::vector<Feature> of_lengths() {
  return {
      of_length("normal_long", "the normal is 10 to 10⁶ long", "a solver may assume ‖N‖ = 1 (failure case 11)", 10, 1e6,
                5, 18),
      of_length("normal_very_long", "the normal is 10¹⁰ long or longer", "N·N, N·K N overflow in binary32", 1e10, 1e300,
                40, 100),
      of_length("normal_short", "the normal is 10⁻⁶ to 0.1 long", "thresholds for a zero normal", 1e-6, 0.1, -18, -5),
      of_length("normal_very_short", "the normal is shorter than 10⁻¹⁰", "thresholds for a zero normal", 1e-300, 1e-10,
                -100, -40)};
}

}  // namespace

std::vector<Feature> of_normal() {
  std::vector<Feature> features;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      features.push_back(along_axis(axis, sign));
      features.push_back(near_axis(axis, sign));
    }
  }
  for (const std::vector<Feature>& more : {of_components(), of_lengths()}) {
    features.insert(features.end(), more.begin(), more.end());
  }
  return features;
}

namespace {

using Coefficient = double Collision::*;

Feature exactly(const char* name, Coefficient coefficient, double value, const char* statement, const char* why) {
  return special_value(
      name, statement, why, [=](const Collision& c) { return c.*coefficient == value; },
      [=](Stream&, Collision& c) { c.*coefficient = value; });
}

/// The coefficient is strictly between `low` and `high`.
Feature between(const char* name, Coefficient coefficient, double low, double high, const char* statement,
                const char* why) {
  return special_value(
      name, statement, why, [=](const Collision& c) { return c.*coefficient > low && c.*coefficient < high; },
      [=](Stream& stream, Collision& c) { c.*coefficient = low + (high - low) * stream.between(0.0625, 0.9375); });
}

}  // namespace

std::vector<Feature> of_coefficients() {
  constexpr auto restitution = &Collision::restitution;
  constexpr auto friction = &Collision::friction;
  constexpr auto tangential = &Collision::tangential_restitution;
  constexpr const char* not_read = "only the laws with friction read it; a solver of another law must not";
  return {
      exactly("restitution_zero", restitution, 0, "ε = 0", "no rebound; outcomes vanish (failure case 20)"),
      exactly("restitution_one", restitution, 1, "ε = 1", "energy is conserved; 1 − ε vanishes (failure case 48)"),
      exactly("restitution_half", restitution, 0.5, "ε = 1/2", "ε and 1 − ε are equal"),
      exactly("friction_zero", friction, 0, "μ = 0", "the default; a solver may branch on it"),
      between("friction_some", friction, 0, 1, "0 < μ < 1", not_read),
      exactly("friction_one", friction, 1, "μ = 1", not_read),
      between("friction_great", friction, 8, 1e9, "μ > 8", "μ = ∞ times 0 (failure case 29)"),
      exactly("tangential_restitution_zero", tangential, 0, "e_t = 0", "the default"),
      between("tangential_restitution_positive", tangential, 0, 1, "0 < e_t < 1", not_read),
      between("tangential_restitution_negative", tangential, -1, 0, "−1 < e_t < 0", not_read),
      exactly("tangential_restitution_one", tangential, 1, "e_t = 1", not_read),
      exactly("tangential_restitution_minus_one", tangential, -1, "e_t = −1", not_read),
      pair_relation(
          "restitution_equals_friction", "ε = μ, and neither is 0 or 1", "the two coefficients may be confused",
          [](const Collision& c) { return c.restitution == c.friction && c.restitution != 0 && c.restitution != 1; },
          [](Stream& stream, Collision& c) {
            if (c.restitution == 0 || c.restitution == 1) {
              c.restitution = stream.between(0.125, 0.875);
            }
            c.friction = c.restitution;
          }),
  };
}

namespace {

/// The normal speed v_n and the tangential speed v_t, times ‖N‖: |N·V⁻| and ‖N × V⁻‖.
struct Parts {
  double normal;
  double tangential;
};

/// Whether a part is positive but less than √u = 1.05e-8 times the other, with u = 2⁻⁵³. In the sum of both squares,
/// rounding then loses the square of the part.
bool is_slight(double part, double other) {
  constexpr double slight = 1e-8;  // just below √u
  return part > 0 && part < slight * other;
}

Parts parts_of(const Collision& c) {
  const V v = relative_velocity(c);
  return {std::abs(dot(c.normal, v)), length(cross(c.normal, v))};
}

/// Sets V by the velocity of one body. The other velocity gets few bits, so the sum is exact.
void set_approach(Stream& stream, Collision& c, const V& relative) {
  // Makes w × r = 0, so V⁻ = v_A − v_B without the rounding of a cross product.
  spin_along_lever_arm(c, c.a);
  spin_along_lever_arm(c, c.b);
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
  const double scale = size_of(c.a.angular_velocity) / size_of(r) / size_of(c.normal);
  set_exact_lever_arm(c, c.a, r);
  c.a.angular_velocity = plus(cross(c.normal, r), c.normal, across * size_of(r)) * scale;
  spin_along_lever_arm(c, c.b);
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
            return are_movable(c) && !is_zero(c.a.velocity) &&
                   V(c.a.velocity * c.a.mass) == V(c.b.velocity * -c.b.mass);
          },
          [](Stream& stream, Collision& c) {
            make_both_movable(stream, c);
            // The masses become powers of two, so their quotient is exact.
            for (Body* b : {&c.a, &c.b}) {
              int exponent = 0;
              std::frexp(b->mass, &exponent);
              set_mass(*b, std::ldexp(1.0, exponent - 1));
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
