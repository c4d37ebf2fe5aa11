// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <fmt/format.h>

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

Vector velocity_of_centres(const Problem& p) { return p.contact.a.velocity - p.contact.b.velocity; }

/// The impulse along N that gives N·V⁺ = −ε N·V⁻ without friction.
Vector normal_impulse(const Problem& p, const Vector& velocity) {
  const Vector& n = p.contact.normal;
  return n * (-(1 + p.contact.restitution) * n.dot(velocity) / n.dot(p.matrix * n));
}

// The relative velocity, and the test for approach.

DrawnDefect spin_in_velocity(Random& random) {
  const double c = random.one_of({-1.0, 0.0, 0.0174532925199433, 57.2957795130823, random.factor()});
  const Which which = drawn_bodies(random);
  const char* how = c < 0 ? "%sign" : (c > 0 ? "%times" : "%none");
  DrawnDefect defect{.words = fmt::format("the spin of {} is multiplied by {}", which.words, c),
                     .named_by = fmt::format("spin & {0} & !changed & {1} | lever arm & {0} & {1}", how, which.part)};
  if (c != 0 && c != -1) {
    defect.named_by += " | spin & degrees";
  }
  change_data(defect, which, in_velocity, [c](ContactBody& body, const Body&) { body.angular_velocity *= c; });
  return defect;
}

DrawnDefect body_at_rest(Random& random) {
  const int kind = static_cast<int>(random.below(4));
  constexpr std::array words{"A", "B", "an immovable body", "the spin of an immovable body"};
  DrawnDefect defect{
      .words = fmt::format("{} is taken to be at rest", words[static_cast<std::size_t>(kind)]),
      .named_by = kind < 2 ? fmt::format("velocity & {0} & %none | at rest & {0}", kind == 0 ? "A" : "B")
                           : (kind == 2 ? "immovable & velocity & %none | immovable & at rest | wall & at rest"
                                        : "immovable & spin & %none | wall & spin & %none")};
  change_data(defect, no_body, in_velocity, {});
  defect.change.data = [kind](Contact& contact, const Collision& read) {
    const std::array is_stopped{kind == 0 || (kind > 1 && read.a.immovable),
                                kind == 1 || (kind > 1 && read.b.immovable)};
    constexpr std::array bodies{&Contact::a, &Contact::b};
    for (std::size_t i = 0; i < 2; ++i) {
      ContactBody& body = contact.*bodies[i];
      if (is_stopped[i]) {
        body.angular_velocity.setZero();
        body.velocity = kind == 3 ? body.velocity : Vector(Vector::Zero());
      }
    }
  };
  return defect;
}

DrawnDefect slow_body_asleep(Random& random) {
  const double least = random.log_between(0.01, 1);
  DrawnDefect defect{.words = fmt::format("a body slower than {} m/s and rad/s is taken to be at rest", least),
                     .named_by = "velocity & %none | at rest",
                     .limit = least};
  change_data(defect, all_bodies, in_velocity, [least](ContactBody& body, const Body&) {
    if (body.velocity.norm() < least && body.angular_velocity.norm() < least) {
      body.velocity.setZero();
      body.angular_velocity.setZero();
    }
  });
  return defect;
}

DrawnDefect approach_tested_wrongly(Random& random) {
  const int kind = static_cast<int>(random.below(3));
  const double least = random.log_between(1e-3, 0.5);
  const std::array words{std::string("there is no test for approach"),
                         std::string("the test for approach leaves the spins out"),
                         fmt::format("an approach slower than {} m/s is ignored", least)};
  constexpr std::array names{"test for approach & %none | separating & solved",
                             "approach & spin | approach & centres | test & without spin",
                             "contact & ignored | no impulse"};
  DrawnDefect defect{.words = words[static_cast<std::size_t>(kind)], .named_by = names[static_cast<std::size_t>(kind)]};
  if (kind == 2) {
    defect.limit = least;
  }
  defect.change.test = [kind, least](const Problem& p) {
    return kind == 0 || (kind == 1 ? p.contact.normal.dot(velocity_of_centres(p)) < 0 : approach_of(p) < -least);
  };
  return defect;
}

// The coefficients, by the velocity.

DrawnDefect restitution_threshold(Random& random) { return restitution_threshold_at(random.log_between(0.05, 2)); }

DrawnDefect restitution_of_another_velocity(Random& random) {
  const int kind = static_cast<int>(random.below(3));
  constexpr std::array words{"acts on the approach of the centres", "acts on the whole relative velocity",
                             "has the wrong sign: 1 − ε"};
  constexpr std::array names{"ε & centres | ε & without spin | restitution & centres", "ε & whole | ε & ‖V",
                             "ε & %sign | ε were multiplied by -1 | factor 1 − ε"};
  DrawnDefect defect{.words = fmt::format("ε {}", words[static_cast<std::size_t>(kind)]),
                     .named_by = names[static_cast<std::size_t>(kind)]};
  defect.change.problem = [kind](Problem& p) {
    const double approach = p.contact.normal.dot(p.velocity);
    const double centres = p.contact.normal.dot(velocity_of_centres(p));
    const double whole = -p.contact.normal.norm() * p.velocity.norm();
    const double share = kind == 2 ? -1 : (kind == 0 ? std::min(centres, 0.0) : whole) / approach;
    p.contact.restitution *= std::isfinite(share) ? share : 1;
  };
  return defect;
}

// The collision matrix.

DrawnDefect matrix_wrong(Random& random) {
  const int kind = static_cast<int>(random.below(3));
  const double softness = random.log_between(0.01, 1);
  const std::array words{std::string("entries of K off the diagonal are left out"),
                         fmt::format("{} 1/kg are added to the diagonal of K", softness),
                         std::string("1/(m_A + m_B) stands for 1/m_A + 1/m_B")};
  constexpr std::array names{"diagonal", "K & added | matrix & added | diagonal & added",
                             "m_A + m_B | sum of the masses"};
  DrawnDefect defect{.words = words[static_cast<std::size_t>(kind)], .named_by = names[static_cast<std::size_t>(kind)]};
  defect.change.problem = [kind, softness](Problem& p) {
    if (kind == 0) {
      p.matrix = Matrix(p.matrix.diagonal().asDiagonal());
    } else if (kind == 1) {
      p.matrix += Matrix::Identity() * softness;
    } else if (p.contact.a.inverse_mass > 0 && p.contact.b.inverse_mass > 0) {
      const double both = 1 / p.contact.a.inverse_mass + 1 / p.contact.b.inverse_mass;
      p.matrix += Matrix::Identity() * (1 / both - impulse::inverse_mass(p.contact));
    }
  };
  return defect;
}

DrawnDefect turning_in_matrix(Random& random) {
  const double c = random.one_of({0.0, 2.0, 0.5, random.factor()});
  const Which which = drawn_bodies(random);
  DrawnDefect defect{
      .words = fmt::format("the angular term of {} is multiplied by {}", which.words, c),
      .named_by = fmt::format(
          fmt::runtime(c > 0 ? "angular term & %times & {0} | moments & %times & {0} | inertia & %times & {0}"
                             : "angular term & %none & {0} | rotate & {0} | turn & {0}"),
          which.part)};
  change_data(defect, which, in_matrix, [c](ContactBody& body, const Body&) { body.inertia.inverse_moments *= c; });
  return defect;
}

// The impulse, and how it is applied.

DrawnDefect impulse_multiplied(Random& random) {
  const double c = random.one_of({2.0, 0.5, random.factor()});
  DrawnDefect defect{.words = fmt::format("the impulse is multiplied by {}", c),
                     .named_by = "impulse & %times & !length of the normal & !tangential & !friction & !ε"};
  defect.change.impulse_after = [c](Vector& f, const Problem&) { f *= c; };
  return defect;
}

DrawnDefect tangential_impulse_multiplied(Random& random) {
  const double c = random.one_of({-1.0, 0.0, random.factor()});
  const char* how = c < 0 ? "%sign" : (c > 0 ? "%times" : "%none");
  DrawnDefect defect{.words = fmt::format("the tangential impulse is multiplied by {}", c),
                     .named_by = fmt::format("friction & {0} | tangential & {0} | tangential impulse & {0}", how)};
  if (c < 0) {
    defect.named_by += " | tangential & multiplied by -1";
  }
  if (c == 0) {
    defect.named_by += " | law were frictionless";
  } else if (c > 0) {
    defect.named_by += " | friction stopped & of the slip";
  }
  defect.change.impulse_after = [c](Vector& f, const Problem& p) {
    const Vector tangential = across(p.contact.normal, f);
    f = c == 0 ? Vector(f - tangential) : Vector(f + tangential * (c - 1));
  };
  return defect;
}

DrawnDefect normal_impulse_multiplied(Random& random) {
  const double c = random.factor();
  DrawnDefect defect{.words = fmt::format("the normal impulse is multiplied by {}", c),
                     .named_by = "normal & impulse & %times & !length of the normal | normal part & %times"};
  defect.change.impulse_after = [c](Vector& f, const Problem& p) { f += (f - across(p.contact.normal, f)) * (c - 1); };
  return defect;
}

DrawnDefect normal_not_normalised(Random& random) {
  const int power = random.one_of({1, 2});
  DrawnDefect defect{.words = power == 1 ? "the impulse is multiplied by ‖N‖" : "the impulse is multiplied by ‖N‖²",
                     .named_by = "length of the normal | normal & length | normal & normalised | normal & unit"};
  change_data(defect, no_body, in_matrix, {});
  defect.change.data = [](Contact& contact, const Collision& read) {
    constexpr double extreme = 1e6;  // such squares stay far from the limits of double
    const double length = read.normal.stableNorm();
    contact.normal = length < extreme && 1 / length < extreme ? read.normal : Vector(contact.normal.normalized());
  };
  defect.change.impulse_after = [power](Vector& f, const Problem& p) {
    constexpr double rounding = 1e-9;
    const double length = p.contact.normal.norm();
    f *= std::abs(length - 1) < rounding ? 1 : std::pow(length, power);
  };
  return defect;
}

DrawnDefect impulse_capped(Random& random) {
  const double most = random.log_between(0.1, 100);
  DrawnDefect defect{
      .words = fmt::format("impulses are at most {} N s", most), .named_by = "impulse & %limit", .limit = most};
  defect.change.impulse_after = [most](Vector& f, const Problem&) { f *= std::min(1.0, most / f.norm()); };
  return defect;
}

DrawnDefect outcome_capped(Random& random) {
  const bool is_spin = random.below(2) == 0;
  const double most = random.log_between(1, 100);
  DrawnDefect defect{
      .words = fmt::format("{} after is at most {}", is_spin ? "a spin" : "a speed", most),
      .named_by = is_spin ? "spin & %limit | angular velocit & %limit" : "speed & %limit | velocit & %limit",
      .limit = most};
  defect.change.outcome = [is_spin, most](Outcome<double>& after) {
    for (BodyVelocity<double>* body : {&after.a, &after.b}) {
      Vector& v = is_spin ? body->angular_velocity : body->velocity;
      const double length = v.stableNorm();
      v = length > most ? Vector(v * (most / length)) : v;
    }
  };
  return defect;
}

DrawnDefect outcome_in_float(Random&) {
  DrawnDefect defect{.words = "the outcome is stored in float", .named_by = "%float"};
  defect.change.outcome = [](Outcome<double>& after) {
    after = map_outcome<double>(after, [](double x) { return static_cast<double>(static_cast<float>(x)); });
  };
  return defect;
}

DrawnDefect reaction_wrong(Random& random) {
  const int kind = static_cast<int>(random.below(3));
  const bool is_a = random.below(2) == 0;
  const char* body = is_a ? "A" : "B";
  constexpr std::array words{"{} gets no impulse", "the impulse on {} has the wrong sign", "{} gets no torque"};
  const std::array names{
      fmt::format("{0} & no reaction | {0} & %none & impulse | {0} & immovable & !each | {0} & no impulse", body),
      fmt::format("impulse & %sign & {0} | reaction & %sign & {0} | {0} & wrong direction & !spin | "
                  "{0} & pushed in the same direction",
                  body),
      fmt::format("{0} & %none & spin | {0} & no torque | {0} & rotate | {0} & turn | {0} & lever arm & %none", body)};
  DrawnDefect defect{.words = fmt::format(fmt::runtime(words[static_cast<std::size_t>(kind)]), body),
                     .named_by = names[static_cast<std::size_t>(kind)]};
  const std::string sentence = defect.words;
  change_data(defect, {is_a, !is_a, "", ""}, in_application, [kind](ContactBody& b, const Body&) {
    if (kind < 2) {
      b.inverse_mass *= kind == 0 ? 0 : -1;
    }
    b.lever_arm *= kind == 1 ? -1 : 0;
  });
  defect.words = sentence;
  return defect;
}

DrawnDefect component_dropped(Random& random) {
  const int kind = static_cast<int>(random.below(3));
  const int axis = static_cast<int>(random.below(3));
  const std::string name(1, static_cast<char>('x' + axis));
  constexpr std::array vectors{"impulse", "lever arm", "spin"};
  const char* vector = vectors[static_cast<std::size_t>(kind)];
  DrawnDefect defect{.words = fmt::format("the {} component of each {} is dropped", name, vector),
                     .named_by = fmt::format("{} & component & {}", vector, name)};
  if (kind == 0) {
    defect.change.impulse_after = [axis](Vector& f, const Problem&) { f[axis] = 0; };
  } else {
    change_data(defect, all_bodies, kind == 1 ? everywhere : in_velocity, [=](ContactBody& body, const Body&) {
      (kind == 1 ? body.lever_arm : body.angular_velocity)[axis] = 0;
    });
  }
  return defect;
}

// Friction.

DrawnDefect other_law(Random& random) {
  const Law law = random.one_of({Law::frictionless, Law::reflection, Law::sticking});
  DrawnDefect defect{.words = fmt::format("it computes the law {}", name_of(law)),
                     .named_by = fmt::format("law were {}", name_of(law))};
  if (law == Law::frictionless) {
    defect.named_by += " | friction & %none";
  }
  if (law == Law::sticking) {
    defect.named_by +=
        " | always stick | friction always stopped | not limited | unlimited | without limit | every slip";
  }
  defect.change.impulse = [law](const Problem& p) {
    Problem other = p;
    other.law = law;
    return impulse_by_matrix(other);
  };
  return defect;
}

/// Friction that stops the slip of V, within μ times the length of the normal impulse.
Vector friction_against(const Problem& p, const Vector& velocity, const Vector& along_normal) {
  const Vector slip = across(p.contact.normal, velocity);
  const double speed = slip.norm();
  if (!(speed > 0)) {
    return Vector::Zero();
  }
  const Vector direction = slip / speed;
  const double stops = speed / direction.dot(p.matrix * direction);
  const double limit =
      p.law == Law::sticking ? std::numeric_limits<double>::infinity() : p.contact.friction * along_normal.norm();
  return -direction * std::min(stops, limit);
}

DrawnDefect friction_in_one_pass(Random& random) {
  const bool is_before = random.below(2) == 0;
  DrawnDefect defect{
      .words = fmt::format("friction is solved once, {} the normal impulse", is_before ? "before" : "after"),
      .named_by = is_before ? "friction & once & before" : "friction & once & after"};
  defect.change.impulse = [is_before](const Problem& p) -> Vector {
    const Vector along_normal = normal_impulse(p, p.velocity);
    if (!is_before) {
      return along_normal + friction_against(p, p.velocity + p.matrix * along_normal, along_normal);
    }
    const Vector friction = friction_against(p, p.velocity, along_normal);
    return normal_impulse(p, p.velocity + p.matrix * friction) + friction;
  };
  return defect;
}

DrawnDefect friction_of_spheres(Random& random) {
  const double share = random.one_of({2.0 / 7, 2.0 / 5, 1.0 / 3, 1.0});
  const char* how = share == 1 ? "friction & cannot turn | friction & mass alone"
                               : (share == 2.0 / 7 ? "friction & solid sphere" : "friction stopped & of the slip");
  DrawnDefect defect{.words = fmt::format("friction takes {:.3g} of the slip over λ for what stops it", share),
                     .named_by = how};
  defect.change.impulse = [share](const Problem& p) -> Vector {
    const Vector along_normal = normal_impulse(p, p.velocity);
    const Vector slip = across(p.contact.normal, p.velocity);
    const Vector stops = -slip * (share / impulse::inverse_mass(p.contact));
    const double limit =
        p.law == Law::sticking ? std::numeric_limits<double>::infinity() : p.contact.friction * along_normal.norm();
    return along_normal + (stops.norm() > limit ? Vector(stops * (limit / stops.norm())) : stops);
  };
  return defect;
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

DrawnDefect friction_in_box(Random&) {
  DrawnDefect defect{.words = "friction is limited along each of two axes",
                     .named_by = "box | pyramid | each axis | by axis"};
  defect.change.impulse_after = [](Vector& f, const Problem& p) {
    constexpr double rounding = 1e-9;  // the sound impulse is more accurate than the iteration
    const Vector in_box = impulse_in_box(p, impulse::stable_tangent_basis(p.contact));
    f = (in_box - f).norm() > rounding * f.norm() ? in_box : f;
  };
  return defect;
}

DrawnDefect static_friction_larger(Random& random) {
  const double ratio = random.between(1.1, 3);
  DrawnDefect defect{.words = fmt::format("it sticks up to {} times the limit", ratio),
                     .named_by = "static | stick & %times | stick & too | sticking & limit"};
  defect.change.impulse_after = [ratio](Vector& f, const Problem& p) {
    Problem without_limit = p;
    without_limit.law = Law::sticking;
    const Vector sticks = impulse_by_matrix(without_limit);
    const Vector& n = p.contact.normal;
    const double normal_part = n.dot(sticks) / n.norm();
    const double tangential = across(n, sticks).norm();
    constexpr double rounding = 1e-9;
    if (tangential > p.contact.friction * normal_part * (1 + rounding) &&
        tangential <= ratio * p.contact.friction * normal_part) {
      f = sticks;
    }
  };
  return defect;
}

DrawnDefect always_slides(Random&) {
  DrawnDefect defect{.words = "friction is μ F_n even if less would stop the slip",
                     .named_by = "always slid | friction & never stick | μ F_n & less | even if less | full friction"};
  defect.change.impulse_after = [](Vector& f, const Problem& p) {
    const Vector n = p.contact.normal.normalized();
    const Vector slip = across(n, p.velocity);
    if (slip.norm() > 0 && p.contact.friction > 0) {
      const Vector along = n - slip * (p.contact.friction / slip.norm());
      const double change = -(1 + p.contact.restitution) * approach_of(p);
      f = along * (change / n.dot(p.matrix * along));
    }
  };
  return defect;
}

DrawnDefect spin_in_slip(Random& random) {
  const double c = random.one_of({0.0, -1.0});
  const Which which = drawn_bodies(random);
  const std::string_view part = which.a && which.b ? "slip" : which.part;
  const char* how = c < 0 ? "%sign" : "%none";
  DrawnDefect defect{.words = fmt::format("the spin of {} is multiplied by {} in the slip", which.words, c),
                     .named_by = fmt::format("spin & {0} & slip & {1} | lever arm & {0} & slip & {1}", how, part)};
  defect.change.problem = [which, c](Problem& p) {
    const auto by_spin = [](const ContactBody& body) -> Vector { return body.angular_velocity.cross(body.lever_arm); };
    const Vector spins = (which.a ? by_spin(p.contact.a) : Vector(Vector::Zero())) -
                         (which.b ? by_spin(p.contact.b) : Vector(Vector::Zero()));
    p.velocity += across(p.contact.normal, spins * (c - 1));
  };
  return defect;
}

constexpr std::array kinds{
    DefectKind{"spin_in_velocity", drawn_laws, spin_in_velocity},
    DefectKind{"body_at_rest", drawn_laws, body_at_rest},
    DefectKind{"slow_body_asleep", drawn_laws, slow_body_asleep},
    DefectKind{"approach_tested_wrongly", drawn_laws, approach_tested_wrongly},
    DefectKind{"restitution_threshold", drawn_laws, restitution_threshold},
    DefectKind{"restitution_of_another_velocity", drawn_laws, restitution_of_another_velocity},
    DefectKind{"matrix_wrong", drawn_laws, matrix_wrong},
    DefectKind{"turning_in_matrix", drawn_laws, turning_in_matrix},
    DefectKind{"impulse_multiplied", drawn_laws, impulse_multiplied},
    DefectKind{"tangential_impulse_multiplied", laws_with_tangents, tangential_impulse_multiplied},
    DefectKind{"normal_impulse_multiplied", laws_with_tangents, normal_impulse_multiplied},
    DefectKind{"normal_not_normalised", drawn_laws, normal_not_normalised},
    DefectKind{"impulse_capped", drawn_laws, impulse_capped},
    DefectKind{"outcome_capped", drawn_laws, outcome_capped},
    DefectKind{"outcome_in_float", drawn_laws, outcome_in_float},
    DefectKind{"reaction_wrong", drawn_laws, reaction_wrong},
    DefectKind{"component_dropped", drawn_laws, component_dropped},
    DefectKind{"other_law", laws_with_friction, other_law},
    DefectKind{"friction_in_one_pass", laws_that_stop_slip, friction_in_one_pass},
    DefectKind{"friction_of_spheres", laws_that_stop_slip, friction_of_spheres},
    DefectKind{"friction_in_box", std::span(laws_with_friction).last(1), friction_in_box},
    DefectKind{"static_friction_larger", std::span(laws_with_friction).last(1), static_friction_larger},
    DefectKind{"always_slides", laws_with_friction, always_slides},
    DefectKind{"spin_in_slip", laws_that_stop_slip, spin_in_slip},
};

}  // namespace

DrawnDefect restitution_threshold_at(double threshold) {
  DrawnDefect defect{.words = fmt::format("ε is 0 if the approach is slower than {} m/s", threshold),
                     .named_by = "ε were 0 | ε & %none | inelastic | restitution & %none",
                     .limit = threshold};
  defect.change.problem = [threshold](Problem& p) {
    p.contact.restitution = -approach_of(p) < threshold ? 0 : p.contact.restitution;
  };
  return defect;
}

std::span<const DefectKind> kinds_of_steps() { return kinds; }

}  // namespace carom::mutants
