// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <carom/impulse/reflection_in_basis.hpp>

#include "drawn_defects.hpp"

namespace carom::mutants {
namespace {

using Vector = Vector3<double>;
using Matrix = Matrix3<double>;
using ContactBody = impulse::ContactBody<double>;
using Contact = impulse::Contact<double>;

/// N·V⁻/‖N‖ [m/s], negative if the bodies approach.
double approach_of(const Problem& p) { return p.contact.normal.dot(p.velocity) / p.contact.normal.norm(); }

double approach_of_centres(const Problem& p) {
  return p.contact.normal.dot(p.contact.a.velocity - p.contact.b.velocity);
}

Vector across(const Vector& normal, const Vector& v) { return v - normal * (normal.dot(v) / normal.squaredNorm()); }

void stop(ContactBody& body) {
  body.velocity.setZero();
  body.angular_velocity.setZero();
}

/// Multiplies ε, unless the share is of nothing.
void multiply_restitution(Problem& p, double share) { p.contact.restitution *= std::isfinite(share) ? share : 1; }

/// A power of ‖N‖, which is 1 if squares of ‖N‖ come near the limits of double.
void multiply_by_length_of_normal(Vector& f, const Problem& p, const Drawn& d) {
  constexpr double extreme = 1e6;
  constexpr double rounding = 1e-9;
  const double length = p.length_of_normal;
  const bool is_multiplied = length < extreme && 1 / length < extreme && std::abs(length - 1) >= rounding;
  f *= is_multiplied ? std::pow(length, d.way == 0 ? 1 : 2) : 1;
}

void cap_length(Vector& v, double most) {
  const double length = v.stableNorm();
  v = length > most ? Vector(v * (most / length)) : v;
}

template <Law law>
Vector impulse_of_law(const Problem& p, const Drawn&) {
  Problem other = p;
  other.law = law;
  return impulse_by_matrix(other);
}

/// The impulse along N that gives N·V⁺ = −ε N·V⁻ without friction.
Vector normal_impulse(const Problem& p, const Vector& velocity) {
  const Vector& n = p.contact.normal;
  return n * (-(1 + p.contact.restitution) * n.dot(velocity) / n.dot(p.matrix * n));
}

/// μ times the length of the normal impulse. The law `sticking` has no limit.
double limit_of_friction(const Problem& p, const Vector& along_normal) {
  return p.law == Law::sticking ? std::numeric_limits<double>::infinity() : p.contact.friction * along_normal.norm();
}

/// Friction that stops the slip of V within its limit.
Vector friction_against(const Problem& p, const Vector& velocity, const Vector& along_normal) {
  const Vector slip = across(p.contact.normal, velocity);
  const double speed = slip.norm();
  if (!(speed > 0)) {
    return Vector::Zero();
  }
  const Vector direction = slip / speed;
  const double stops = speed / direction.dot(p.matrix * direction);
  return -direction * std::min(stops, limit_of_friction(p, along_normal));
}

/// Friction takes this share of the slip over λ for what stops it.
Vector friction_of_sphere(const Problem& p, const Drawn& d) {
  const Vector along_normal = normal_impulse(p, p.velocity);
  const Vector stops = -across(p.contact.normal, p.velocity) * (d.number / impulse::inverse_mass(p.contact));
  const double limit = limit_of_friction(p, along_normal);
  return along_normal + (stops.norm() > limit ? Vector(stops * (limit / stops.norm())) : stops);
}

/// The impulse with friction limited along each tangent of the basis, by Gauss-Seidel iteration.
Vector impulse_in_box(const Problem& p, const Matrix& basis) {
  constexpr int most_rounds = 1000;
  const Matrix c = impulse::in_basis<double>(p.matrix, basis);
  Vector change = -(basis.transpose() * p.velocity);
  change[0] *= 1 + p.contact.restitution;
  Vector f = Vector::Zero();
  Vector before = Vector::Ones();
  for (int round = 0; round < most_rounds && f != before; ++round) {
    before = f;
    for (int i = 0; i < 3; ++i) {
      const double solved = f[i] + (change[i] - c.row(i).dot(f)) / c(i, i);
      const double limit = p.contact.friction * f[0];
      f[i] = i == 0 ? std::max(0.0, solved) : std::clamp(solved, -limit, limit);
    }
  }
  return basis * f;
}

/// A vector of the bodies loses a component.
Drawn drawn_component(Random& random) {
  const std::size_t vector = random.below(3);
  constexpr std::array uses{everywhere, everywhere, in_velocity};
  return {.way = vector, .axis = static_cast<int>(random.below(3)), .at = {.use = uses[vector]}};
}

constexpr std::array laws_with_tangents{Law::reflection, Law::sticking, Law::rough, Law::coulomb};
constexpr std::array laws_that_stop_slip{Law::sticking, Law::rough, Law::coulomb};
constexpr std::array coulomb{Law::coulomb};

const std::vector<DefectKind> step_kinds{
    // The relative velocity, and the test for approach.
    {{"spin_in_velocity",
      [](Random& r) {
        return Drawn{.number = r.one_of({-1.0, 0.0, 0.0174532925199433, 57.2957795130823, r.factor()}),
                     .at = drawn_bodies(r, in_velocity)};
      }},
     {{"the spin of {bodies} is multiplied by {c}{use}", "spin & {how} & !changed | lever arm & {how}",
       [](ContactBody& x, const Body&, const Drawn& d) { x.angular_velocity *= d.number; },
       [](const Drawn& d) { return d.number != 0 && d.number != -1 ? "spin & degrees" : ""; }}}},
    {{"body_at_rest", [](Random& r) { return Drawn{.way = r.below(4), .at = {.use = in_velocity}}; }},
     {{"A is taken to be at rest{use}", "velocity & A & %none | at rest & A",
       [](Contact& x, const Collision&, const Drawn&) { stop(x.a); }},
      {"B is taken to be at rest{use}", "velocity & B & %none | at rest & B",
       [](Contact& x, const Collision&, const Drawn&) { stop(x.b); }},
      {"an immovable body is taken to be at rest{use}",
       "immovable & velocity & %none | immovable & at rest | wall & at rest",
       [](ContactBody& x, const Body& read, const Drawn&) {
         if (read.immovable) {
           stop(x);
         }
       }},
      {"the spin of an immovable body is taken to be at rest{use}", "immovable & spin & %none | wall & spin & %none",
       [](ContactBody& x, const Body& read, const Drawn&) { x.angular_velocity *= read.immovable ? 0 : 1; }}}},
    {{"slow_body_asleep",
      [](Random& r) { return Drawn{.number = r.log_between(0.01, 1), .at = {.use = in_velocity}}; }},
     {{"a body slower than {limit} m/s and rad/s is taken to be at rest{use}", "velocity & %none | at rest",
       [](ContactBody& x, const Body&, const Drawn& d) {
         if (x.velocity.norm() < d.number && x.angular_velocity.norm() < d.number) {
           stop(x);
         }
       }}}},
    {{"approach_tested_wrongly",
      [](Random& r) { return Drawn{.way = r.below(3), .number = r.log_between(1e-3, 0.5)}; }},
     {{"there is no test for approach", "test for approach & %none | separating & solved",
       [](const Problem&, const Drawn&) { return true; }},
      {"the test for approach leaves the spins out", "approach & spin | approach & centres | test & without spin",
       [](const Problem& p, const Drawn&) { return approach_of_centres(p) < 0; }},
      {"an approach slower than {limit} m/s is ignored", "contact & ignored | no impulse",
       [](const Problem& p, const Drawn& d) { return approach_of(p) < -d.number; }}}},

    // The coefficients, by the velocity.
    {{"restitution_threshold", [](Random& r) { return Drawn{.number = r.log_between(0.05, 2)}; }},
     {{"ε is 0 if the approach is slower than {limit} m/s", "ε were 0 | ε & %none | inelastic | restitution & %none",
       [](Problem& p, const Drawn& d) { multiply_restitution(p, -approach_of(p) < d.number ? 0 : 1); }}}},
    {{"restitution_of_another_velocity", [](Random& r) { return Drawn{.way = r.below(3)}; }},
     {{"ε acts on the approach of the centres", "ε & centres | ε & without spin | restitution & centres",
       [](Problem& p, const Drawn&) {
         multiply_restitution(p, std::min(approach_of_centres(p), 0.0) / p.contact.normal.dot(p.velocity));
       }},
      {"ε acts on the whole relative velocity", "ε & whole | ε & ‖V",
       [](Problem& p, const Drawn&) {
         const Vector& n = p.contact.normal;
         multiply_restitution(p, -n.norm() * p.velocity.norm() / n.dot(p.velocity));
       }},
      {"ε has the wrong sign: 1 − ε", "ε & %sign | ε were multiplied by -1 | factor 1 − ε",
       [](Problem& p, const Drawn&) { multiply_restitution(p, -1); }}}},

    // The collision matrix.
    {{"matrix_wrong", [](Random& r) { return Drawn{.way = r.below(3), .number = r.log_between(0.01, 1)}; }},
     {{"entries of K off the diagonal are left out", "diagonal",
       [](Problem& p, const Drawn&) { p.matrix = Matrix(p.matrix.diagonal().asDiagonal()); }},
      {"{c} 1/kg are added to the diagonal of K", "K & added | matrix & added | diagonal & added",
       [](Problem& p, const Drawn& d) { p.matrix += Matrix::Identity() * d.number; }},
      {"1/(m_A + m_B) stands for 1/m_A + 1/m_B", "m_A + m_B | sum of the masses",
       [](Problem& p, const Drawn&) {
         if (p.contact.a.inverse_mass > 0 && p.contact.b.inverse_mass > 0) {
           const double both = 1 / p.contact.a.inverse_mass + 1 / p.contact.b.inverse_mass;
           p.matrix += Matrix::Identity() * (1 / both - impulse::inverse_mass(p.contact));
         }
       }}}},
    {{"turning_in_matrix",
      [](Random& r) {
        return Drawn{.number = r.one_of({0.0, 2.0, 0.5, r.factor()}), .at = drawn_bodies(r, in_matrix)};
      }},
     {{"the angular term of {bodies} is multiplied by {c}{use}", "angular term & {how}",
       [](ContactBody& x, const Body&, const Drawn& d) { x.inertia.inverse_moments *= d.number; },
       [](const Drawn& d) {
         return d.number > 0 ? "moments & %times & {part} | inertia & %times & {part}"
                             : "rotate & {part} | turn & {part}";
       }}}},

    // The impulse, and how it is applied.
    {{"impulse_multiplied",
      [](Random& r) {
        return Drawn{.number = r.one_of({2.0, 0.5, r.factor()})};
      }},
     {{"the impulse is multiplied by {c}", "impulse & %times & !length of the normal & !tangential & !friction & !ε",
       [](Vector& f, const Problem&, const Drawn& d) { f *= d.number; }}}},
    {{"tangential_impulse_multiplied",
      [](Random& r) {
        return Drawn{.number = r.one_of({-1.0, 0.0, r.factor()})};
      },
      laws_with_tangents},
     {{"the tangential impulse is multiplied by {c}",
       "friction & {how} | tangential & {how} | tangential impulse & {how}",
       [](Vector& f, const Problem& p, const Drawn& d) { f += across(p.contact.normal, f) * (d.number - 1); },
       [](const Drawn& d) {
         return d.number < 0 ? "tangential & multiplied by -1"
                             : (d.number == 0 ? "law were frictionless | tangential & multiplied by 0"
                                              : "friction stopped & of the slip");
       }}}},
    {{"normal_impulse_multiplied", [](Random& r) { return Drawn{.number = r.factor()}; }, laws_with_tangents},
     {{"the normal impulse is multiplied by {c}",
       "normal & impulse & %times & !length of the normal | normal part & %times",
       [](Vector& f, const Problem& p, const Drawn& d) { f += (f - across(p.contact.normal, f)) * (d.number - 1); }}}},
    {{"normal_not_normalised", [](Random& r) { return Drawn{.way = r.below(2)}; }},
     {{"the impulse is multiplied by ‖N‖ in the collision matrix",
       "length of the normal | normal & length | normal & normalised | normal & unit", multiply_by_length_of_normal},
      {"the impulse is multiplied by ‖N‖² in the collision matrix",
       "length of the normal | normal & length | normal & normalised | normal & unit", multiply_by_length_of_normal}}},
    {{"impulse_capped", [](Random& r) { return Drawn{.number = r.log_between(0.1, 100)}; }},
     {{"impulses are at most {limit} N s", "impulse & %limit",
       [](Vector& f, const Problem&, const Drawn& d) { f *= std::min(1.0, d.number / f.norm()); }}}},
    {{"outcome_capped", [](Random& r) { return Drawn{.way = r.below(2), .number = r.log_between(1, 100)}; }},
     {{"a spin after is at most {limit}", "spin & %limit | angular velocit & %limit",
       [](Outcome<double>& after, const Drawn& d) {
         cap_length(after.a.angular_velocity, d.number);
         cap_length(after.b.angular_velocity, d.number);
       }},
      {"a speed after is at most {limit}", "speed & %limit | velocit & %limit",
       [](Outcome<double>& after, const Drawn& d) {
         cap_length(after.a.velocity, d.number);
         cap_length(after.b.velocity, d.number);
       }}}},
    {{"outcome_in_float", [](Random&) { return Drawn{}; }},
     {{"the outcome is stored in float", "%float",
       [](Outcome<double>& after, const Drawn&) {
         after = map_outcome<double>(after, [](double x) { return static_cast<double>(static_cast<float>(x)); });
       }}}},
    {{"reaction_wrong",
      [](Random& r) {
        const std::size_t way = r.below(3);
        const bool is_a = r.below(2) == 0;
        return Drawn{.way = way, .at = {is_a, !is_a, in_application}};
      }},
     {{"{bodies} gets no impulse", "no reaction | %none & impulse | immovable & !each | no impulse",
       [](ContactBody& x, const Body&, const Drawn&) {
         x.inverse_mass = 0;
         x.lever_arm.setZero();
       }},
      {"the impulse on {bodies} has the wrong sign",
       "impulse & %sign | reaction & %sign | wrong direction & !spin | pushed in the same direction",
       [](ContactBody& x, const Body&, const Drawn&) {
         x.inverse_mass *= -1;
         x.lever_arm *= -1;
       }},
      {"{bodies} gets no torque", "%none & spin | no torque | rotate | turn | lever arm & %none",
       [](ContactBody& x, const Body&, const Drawn&) { x.lever_arm.setZero(); }}}},
    {{"component_dropped", drawn_component},
     {{"the {axis} component of each impulse is dropped", "impulse & component & {axis}",
       [](Vector& f, const Problem&, const Drawn& d) { f[d.axis] = 0; }},
      {"the {axis} component of each lever arm is dropped{use}", "lever arm & component & {axis}",
       [](ContactBody& x, const Body&, const Drawn& d) { x.lever_arm[d.axis] = 0; }},
      {"the {axis} component of each spin is dropped{use}", "spin & component & {axis}",
       [](ContactBody& x, const Body&, const Drawn& d) { x.angular_velocity[d.axis] = 0; }}}},

    // Friction.
    {{"other_law", [](Random& r) { return Drawn{.way = r.below(3)}; }, laws_with_friction},
     {{"it computes the law frictionless", "law were frictionless | friction & %none",
       impulse_of_law<Law::frictionless>},
      {"it computes the law reflection", "law were reflection", impulse_of_law<Law::reflection>},
      {"it computes the law sticking",
       "law were sticking | always stick | friction always stopped | not limited | unlimited | without limit | "
       "every slip",
       impulse_of_law<Law::sticking>}}},
    {{"friction_in_one_pass", [](Random& r) { return Drawn{.way = r.below(2)}; }, laws_that_stop_slip},
     {{"friction is solved once, before the normal impulse", "friction & once & before",
       [](const Problem& p, const Drawn&) -> Vector {
         const Vector friction = friction_against(p, p.velocity, normal_impulse(p, p.velocity));
         return normal_impulse(p, p.velocity + p.matrix * friction) + friction;
       }},
      {"friction is solved once, after the normal impulse", "friction & once & after",
       [](const Problem& p, const Drawn&) -> Vector {
         const Vector along_normal = normal_impulse(p, p.velocity);
         return along_normal + friction_against(p, p.velocity + p.matrix * along_normal, along_normal);
       }}}},
    {{"friction_of_spheres",
      [](Random& r) {
        return Drawn{.number = r.one_of({2.0 / 7, 2.0 / 5, 1.0 / 3, 1.0})};
      },
      laws_that_stop_slip},
     {{"friction takes {c:.3g} of the slip over λ for what stops it", "", friction_of_sphere,
       [](const Drawn& d) {
         constexpr double solid_sphere = 2.0 / 7;
         return d.number == 1
                    ? "friction & cannot turn | friction & mass alone"
                    : (d.number == solid_sphere ? "friction & solid sphere" : "friction stopped & of the slip");
       }}}},
    {{"friction_in_box", [](Random&) { return Drawn{}; }, coulomb},
     {{"friction is limited along each of two axes", "box | pyramid | each axis | by axis",
       [](Vector& f, const Problem& p, const Drawn&) {
         constexpr double rounding = 1e-9;  // the sound impulse is more accurate than the iteration
         const Vector in_box = impulse_in_box(p, impulse::stable_tangent_basis(p.contact));
         f = (in_box - f).norm() > rounding * f.norm() ? in_box : f;
       }}}},
    {{"static_friction_larger", [](Random& r) { return Drawn{.number = r.between(1.1, 3)}; }, coulomb},
     {{"it sticks up to {c} times the limit", "static | stick & %times | stick & too | sticking & limit",
       [](Vector& f, const Problem& p, const Drawn& d) {
         const Vector sticks = impulse_of_law<Law::sticking>(p, d);
         const Vector& n = p.contact.normal;
         const double limit = p.contact.friction * (n.dot(sticks) / n.norm());
         const double tangential = across(n, sticks).norm();
         constexpr double rounding = 1e-9;
         if (tangential > limit * (1 + rounding) && tangential <= d.number * limit) {
           f = sticks;
         }
       }}}},
    {{"always_slides", [](Random&) { return Drawn{}; }, laws_with_friction},
     {{"friction is μ F_n even if less would stop the slip",
       "always slid | friction & never stick | μ F_n & less | even if less | full friction",
       [](Vector& f, const Problem& p, const Drawn&) {
         const Vector n = p.contact.normal.normalized();
         const Vector slip = across(n, p.velocity);
         if (slip.norm() > 0 && p.contact.friction > 0) {
           const Vector along = n - slip * (p.contact.friction / slip.norm());
           const double change = -(1 + p.contact.restitution) * approach_of(p);
           f = along * (change / n.dot(p.matrix * along));
         }
       }}}},
    {{"spin_in_slip",
      [](Random& r) {
        return Drawn{.number = r.one_of({0.0, -1.0}), .at = drawn_bodies(r)};
      },
      laws_that_stop_slip},
     {{"the spin of {bodies} is multiplied by {c} in the slip", "",
       [](Problem& p, const Drawn& d) {
         const auto by_spin = [](const ContactBody& body, bool is_meant) -> Vector {
           return is_meant ? Vector(body.angular_velocity.cross(body.lever_arm)) : Vector(Vector::Zero());
         };
         const Vector spins = by_spin(p.contact.a, d.at.a) - by_spin(p.contact.b, d.at.b);
         p.velocity += across(p.contact.normal, spins * (d.number - 1));
       },
       [](const Drawn& d) {
         return d.at.a && d.at.b ? "spin & {how} & slip | lever arm & {how} & slip"
                                 : "spin & {how} & slip & {part} | lever arm & {how} & slip & {part}";
       }}}},
};

}  // namespace

std::span<const DefectKind> kinds_of_steps() { return step_kinds; }

}  // namespace carom::mutants
