// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "drawn_defects.hpp"

namespace carom::mutants {
namespace {

using Vector = Vector3<double>;
using Matrix = Matrix3<double>;
using ContactBody = impulse::ContactBody<double>;
using Contact = impulse::Contact<double>;

Drawn any_place(Random& random) { return {.at = drawn_place(random)}; }
Drawn factor_at_place(Random& random) { return {.number = random.factor(), .at = drawn_place(random)}; }
Drawn mass_ratio(Random& random) { return {.number = random.log_between(5, 1000)}; }

bool are_movable(const Collision& x) { return !x.a.immovable && !x.b.immovable; }

/// Takes the moments in this order.
template <int first, int second, int third>
void permute_moments(ContactBody& body, const Body&, const Drawn&) {
  const Vector given = body.inertia.inverse_moments;
  body.inertia.inverse_moments = {given[first], given[second], given[third]};
}

template <auto member>
void swap_between_bodies(Contact& contact, const Collision& read, const Drawn&) {
  if (are_movable(read)) {
    std::swap(contact.a.*member, contact.b.*member);
  }
}

void set_friction(Collision& x, double friction) { x.friction = std::isfinite(friction) ? friction : x.friction; }

Drawn factor_of_lever_arm(Random& random) {
  const double c = random.below(3) == 0 ? -1 : random.factor();
  return {.number = c,
          .at = c < 0 ? drawn_place(random, {everywhere, in_impulse, in_application})
                      : drawn_place(random, {everywhere, in_velocity, in_matrix, in_application})};
}

const char* factor_of_lever_arm_also(const Drawn& d) {
  switch (d.at.use) {
    case in_application:
      return "spin & {how} & {part} & !relative | torque & {how} & {part}";
    case in_matrix:  // the square of the factor
      return "angular term & %times & {part}";
    case in_velocity:
    case in_impulse:
      return "spin & {how} & {part} & !changed";
    case everywhere:
      break;
  }
  return "";
}

/// Lever arms from the world's origin, from the centre of the other body, or from the contact point.
void take_lever_arms_elsewhere(Contact& contact, const Collision& read, const Drawn& d) {
  const auto arm = [&](const Body& other) -> Vector {
    const std::array<Vector, 3> origins{Vector::Zero(), other.position, read.point};
    return read.point - origins[d.way];
  };
  contact.a.lever_arm = d.at.a ? arm(read.b) : contact.a.lever_arm;
  contact.b.lever_arm = d.at.b ? arm(read.a) : contact.b.lever_arm;
}

template <class... Vectors>
void round_to_float(Vectors&... vectors) {
  const auto rounded = [](const Vector& v) -> Vector {
    const Vector in_float = v.cast<float>().cast<double>();
    return in_float.allFinite() ? in_float : v;
  };
  ((vectors = rounded(vectors)), ...);
}

constexpr std::array laws_with_tangential_restitution{Law::rough};

const std::vector<DefectKind> data_kinds{
    // Masses, moments, coefficients.
    {{"mass_multiplied", factor_at_place},
     {{"the mass of {bodies} is multiplied by {c}{use}", "mass & %times",
       [](ContactBody& x, const Body&, const Drawn& d) { x.inverse_mass /= d.number; },
       [](const Drawn& d) { return d.at.use == in_application ? "velocity & %times & {part} & !relative" : ""; }}}},
    {{"moments_multiplied", factor_at_place},
     {{"the moments of {bodies} are multiplied by {c}{use}", "moments & %times | inertia & %times",
       [](ContactBody& x, const Body&, const Drawn& d) { x.inertia.inverse_moments /= d.number; },
       [](const Drawn& d) {
         return d.at.use == in_application ? "spin & %times & {part} | torque & %times & {part}"
                                           : (d.at.use == in_matrix ? "angular term & %times & {part}" : "");
       }}}},
    {{"moments_inverted", any_place},
     {{"the moments of {bodies} are used in place of their inverses{use}", "moments & inverse | I in place of 1/I",
       [](ContactBody& x, const Body&, const Drawn&) {
         x.inertia.inverse_moments =
             x.inertia.inverse_moments.unaryExpr([](double moment) { return moment > 0 ? 1 / moment : moment; });
       }}}},
    {{"moments_of_sphere", [](Random& r) { return Drawn{.way = r.below(3), .at = drawn_bodies(r)}; }},
     {{"the mean moment stands for all moments of {bodies}", "moment & equal | sphere | moment & mean",
       [](Body& x, const Drawn&) { x.principal_inertia.setConstant(x.principal_inertia.sum() / 3); }},
      {"the greatest moment stands for all moments of {bodies}", "moment & equal | sphere | moment & greatest",
       [](Body& x, const Drawn&) { x.principal_inertia.setConstant(x.principal_inertia.maxCoeff()); }},
      {"the first moment stands for all moments of {bodies}", "moment & equal | sphere | moment & first",
       [](Body& x, const Drawn&) { x.principal_inertia.setConstant(x.principal_inertia[0]); }}}},
    {{"moments_permuted", [](Random& r) { return Drawn{.way = r.below(5), .at = drawn_place(r)}; }},
     {{"the moments of {bodies} are taken in the order 102{use}", "first two moments & %swapped",
       permute_moments<1, 0, 2>},
      {"the moments of {bodies} are taken in the order 021{use}", "last two moments & %swapped",
       permute_moments<0, 2, 1>},
      {"the moments of {bodies} are taken in the order 210{use}", "first and the last moment & %swapped",
       permute_moments<2, 1, 0>},
      {"the moments of {bodies} are taken in the order 120{use}", "moments & order y, z, x", permute_moments<1, 2, 0>},
      {"the moments of {bodies} are taken in the order 201{use}", "moments & order z, x, y",
       permute_moments<2, 0, 1>}}},
    {{"data_swapped",
      [](Random& r) {
        return Drawn{.way = r.below(3), .at = {.use = r.one_of({everywhere, in_matrix, in_application})}};
      }},
     {{"the masses of A and B are exchanged{use}", "mass & %swapped", swap_between_bodies<&ContactBody::inverse_mass>},
      {"the inertia tensors of A and B are exchanged{use}", "moments & %swapped | inertia & %swapped | moments & other",
       swap_between_bodies<&ContactBody::inertia>},
      {"the lever arms of A and B are exchanged{use}", "lever arm & %swapped | lever arm & other",
       swap_between_bodies<&ContactBody::lever_arm>}}},
    {{"immovable_has_mass", [](Random& r) { return Drawn{.number = r.log_between(1, 1e4)}; }},
     {{"an immovable body has a mass of {c} kg", "immovable & changes | immovable & mass",
       [](Body& body, const Drawn& d) {
         if (body.immovable) {
           body.immovable = false;
           body.mass = d.number;
           body.principal_inertia.setConstant(d.number);
           body.orientation = {1, 0, 0, 0};
         }
       }}}},
    {{"coefficient_replaced", [](Random& r) { return Drawn{.way = r.below(3), .number = r.between(0.05, 0.95)}; }},
     {{"ε is {limit}", "ε were | ε & constant | ε & replaced",
       [](Collision& x, const Drawn& d) { x.restitution = d.number; }},
      {"ε is at most {limit}", "ε & %limit | ε were",
       [](Collision& x, const Drawn& d) { x.restitution = std::min(x.restitution, d.number); }},
      {"ε is multiplied by {c}", "ε & %times", [](Collision& x, const Drawn& d) { x.restitution *= d.number; }}}},
    {{"restitution_squared", [](Random& r) { return Drawn{.way = r.below(2)}; }},
     {{"√ε stands for ε", "ε & root | √ε",
       [](Collision& x, const Drawn&) { x.restitution = std::sqrt(x.restitution); }},
      {"ε² stands for ε", "ε & square | ε²", [](Collision& x, const Drawn&) { x.restitution *= x.restitution; }}}},
    {{"friction_replaced", [](Random& r) { return Drawn{.way = r.below(4), .number = r.factor()}; },
      laws_with_friction},
     {{"μ is {limit}", "μ were | μ & constant | μ & replaced",
       [](Collision& x, const Drawn& d) { set_friction(x, d.number); }},
      {"μ is at most {limit}", "μ & %limit",
       [](Collision& x, const Drawn& d) { set_friction(x, std::min(x.friction, d.number)); }},
      {"μ is multiplied by {c}", "μ & %times",
       [](Collision& x, const Drawn& d) { set_friction(x, x.friction * d.number); }},
      {"μ² stands for μ", "μ & square | μ²",
       [](Collision& x, const Drawn&) { set_friction(x, x.friction * x.friction); }}}},
    {{"tangential_restitution_changed",
      [](Random& r) {
        return Drawn{.number = r.one_of({-1.0, 0.0, r.between(0.1, 0.8)})};
      },
      laws_with_tangential_restitution},
     {{"e_t is multiplied by {c}", "e_t & {how} | tangential restitution & {how}",
       [](Collision& x, const Drawn& d) { x.tangential_restitution *= d.number; }}}},

    // Orientation.
    {{"orientation_ignored", any_place},
     {{"the orientation of {bodies} is taken for the identity{use}",
       "orientation & identity | orientation & %none | orientation & never",
       [](ContactBody& x, const Body& read, const Drawn&) {
         x.inertia.axes = read.immovable ? x.inertia.axes : Matrix(Matrix::Identity());
       }}}},
    {{"orientation_transposed", any_place},
     {{"the rotation of {bodies} is transposed{use}",
       "orientation & inverted | orientation & transposed | orientation & inverse | Rᵀ",
       [](ContactBody& x, const Body&, const Drawn&) { x.inertia.axes.transposeInPlace(); }}}},
    {{"quaternion_order",
      [](Random& r) {
        Drawn drawn{.at = drawn_bodies(r)};
        drawn.way = r.below(2);
        return drawn;
      }},
     {{"the quaternion of {bodies} is read as z, y, x, w", "quaternion & order",
       [](Body& x, const Drawn&) { x.orientation.reverseInPlace(); }},
      {"the quaternion of {bodies} is read as x, y, z, w", "quaternion & order",
       [](Body& x, const Drawn&) {
         x.orientation = Quaternion<double>(x.orientation[3], x.orientation[0], x.orientation[1], x.orientation[2]);
       }}}},
    {{"quaternion_not_normalised", [](Random& r) { return Drawn{.at = drawn_bodies(r)}; }},
     {{"the quaternion of {bodies} is taken to be of unit length",
       "quaternion & length | quaternion & normalised | quaternion & unit",
       [](ContactBody& body, const Body& read, const Drawn&) {
         const Vector& moments = body.inertia.inverse_moments;
         if (!read.immovable && moments.minCoeff() != moments.maxCoeff()) {
           const double squared_length = read.orientation.squaredNorm();
           body.inertia.axes = Matrix::Identity() + (body.inertia.axes - Matrix::Identity()) * squared_length;
         }
       }}}},

    // Lever arms, the contact point and the normal.
    {{"lever_arm_multiplied", factor_of_lever_arm},
     {{"the lever arm of {bodies} is multiplied by {c}{use}", "lever arm & {how}",
       [](ContactBody& x, const Body&, const Drawn& d) { x.lever_arm *= d.number; }, factor_of_lever_arm_also}}},
    {{"lever_arm_of_another_place",
      [](Random& r) {
        return Drawn{.way = r.below(3),
                     .at = drawn_place(r, {everywhere, in_velocity, in_matrix, in_impulse, in_application})};
      }},
     {{"the lever arm of {bodies} is taken from the world's origin{use}", "lever arm & origin",
       take_lever_arms_elsewhere},
      {"the lever arm of {bodies} is taken from the centre of the other body{use}",
       "lever arm & other body | lever arm & %swapped", take_lever_arms_elsewhere},
      {"the lever arm of {bodies} is taken as zero{use}", "lever arm & %none | lever arm & centre of mass",
       take_lever_arms_elsewhere,
       [](const Drawn& d) {
         return d.at.use == in_velocity ? "spin & %none & {part}"
                : d.at.use == in_matrix || d.at.use == in_application
                    ? "rotate & {part} | turn & {part} | spin & %none & {part}"
                    : "";
       }}}},
    {{"short_lever_arm_as_zero", [](Random& r) { return Drawn{.number = r.log_between(0.01, 0.3)}; }},
     {{"a lever arm shorter than {limit} m is taken for zero", "lever arm & %none | lever arm & centre of mass",
       [](ContactBody& x, const Body&, const Drawn& d) { x.lever_arm *= x.lever_arm.norm() < d.number ? 0 : 1; }}}},
    {{"point_elsewhere", [](Random& r) { return Drawn{.way = r.below(3), .number = r.log_between(1e-4, 0.1)}; }},
     {{"the contact point is moved by {c} m along the normal",
       "contact point & moved | contact point & displaced | contact point & off | contact point & away",
       [](Collision& x, const Drawn& d) {
         const Vector normal = impulse::without_extreme_length<double>(x.normal);
         x.point += normal * (d.number / normal.norm());
       }},
      {"the contact point is moved by {c} m along x",
       "contact point & moved | contact point & displaced | contact point & off | contact point & away",
       [](Collision& x, const Drawn& d) { x.point[0] += d.number; }},
      {"the contact point is midway between the centres", "contact point & mid | contact point & centres",
       [](Collision& x, const Drawn&) { x.point = x.a.position / 2 + x.b.position / 2; }}}},
    {{"normal_replaced", [](Random& r) { return Drawn{.way = r.below(3)}; }},
     {{"the normal points the other way", "normal & %sign | test for approach & %sign | separating & solved",
       [](Collision& x, const Drawn&) { x.normal = -x.normal; }},
      {"the normal joins the centres", "normal & centres | normal & from B's centre to A's centre",
       [](Collision& x, const Drawn&) {
         const Vector between = x.a.position - x.b.position;
         x.normal = between.stableNorm() > 0 && between.allFinite() ? between : x.normal;
       }},
      {"the normal is the nearest axis", "normal & axis | normal & axes",
       [](Collision& x, const Drawn&) {
         int axis = 0;
         const double largest = x.normal.cwiseAbs().maxCoeff(&axis);
         x.normal = Vector(Vector::Unit(axis) * std::copysign(largest, x.normal[axis]));
       }}}},
    {{"read_in_float", [](Random& r) { return Drawn{.way = r.below(3)}; }},
     {{"positions and the contact point are read in float", "%float",
       [](Collision& x, const Drawn&) { round_to_float(x.point, x.a.position, x.b.position); }},
      {"velocities and spins are read in float", "%float",
       [](Body& x, const Drawn&) { round_to_float(x.velocity, x.angular_velocity); }},
      {"the normal and coefficients are read in float", "%float",
       [](Collision& x, const Drawn&) {
         const Vector given = x.normal;
         round_to_float(x.normal);
         x.normal = x.normal.isZero(0) ? given : x.normal;
         x.restitution = static_cast<double>(static_cast<float>(x.restitution));
       }}}},

    // Limits of data.
    {{"heavy_as_immovable", mass_ratio},
     {{"a body {limit} times as heavy as the other is immovable", "heavier & immovable | heavy & immovable",
       [](Collision& x, const Drawn& d) {
         const bool are_both = are_movable(x);
         x.a.immovable = x.a.immovable || (are_both && x.a.mass >= d.number * x.b.mass);
         x.b.immovable = x.b.immovable || (are_both && x.b.mass >= d.number * x.a.mass);
       }}}},
    {{"mass_ratio_capped",
      [](Random& r) {
        return Drawn{.number = r.log_between(5, 1000), .at = {.use = r.one_of({everywhere, in_matrix})}};
      }},
     {{"the heavier mass is at most {limit} times the other{use}",
       "mass & %limit & larger | mass & %limit & heavier | mass & ratio",
       [](Contact& contact, const Collision& read, const Drawn& d) {
         if (are_movable(read)) {
           double& a = contact.a.inverse_mass;
           double& b = contact.b.inverse_mass;
           a = std::max(a, b / d.number);
           b = std::max(b, a / d.number);
         }
       }}}},
    {{"moments_at_least", [](Random& r) { return Drawn{.number = r.log_between(1e-4, 1)}; }},
     {{"each moment is at least {limit} kg m²", "moments & at least | moments & %limit | moments & raised",
       [](ContactBody& x, const Body&, const Drawn& d) {
         x.inertia.inverse_moments = x.inertia.inverse_moments.cwiseMin(1 / d.number);
       }}}},
};

}  // namespace

std::span<const DefectKind> kinds_of_data() { return data_kinds; }

}  // namespace carom::mutants
