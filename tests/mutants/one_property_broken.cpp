// SPDX-License-Identifier: BSL-1.0
#include "one_property_broken.hpp"

#include <array>
#include <optional>
#include <string>
#include <utility>

#include <carom/impulse/collision_matrix.hpp>
#include <carom/impulse/frictionless.hpp>
#include <carom/impulse/reflection.hpp>
#include <carom/subjects/session.hpp>

namespace carom::mutants {
namespace {

using Vector = Vector3<double>;
using Matrix = Matrix3<double>;
using Contact = impulse::Contact<double>;
using ContactBody = impulse::ContactBody<double>;
using Solved = SolvedOutcome<double>;

Subject claiming_any(std::string name, bool shows_matrix, Solved (*solve)(const Contact&)) {
  Subject subject;
  subject.name = std::move(name);
  subject.law = Law::any;
  subject.precision = Precision::binary64;
  subject.shows_collision_matrix = shows_matrix;
  subject.open = [solve] {
    return subjects::session_of([solve](const Collision& collision) -> Answer {
      return reported(solve(impulse::make_contact<double>(collision)));
    });
  };
  return subject;
}

Subject without_restitution(Subject subject) {
  subject.deviates.emplace_back("restitution");
  return subject;
}

Solved solve_frictionless(const Contact& contact) { return impulse::frictionless(contact); }

// Non-penetration.

Contact without_rebound(Contact contact) {
  contact.restitution = 0;
  return contact;
}

/// Applies nine tenths of the impulse that stops the approach.
Solved stopped_short(const Contact& contact) {
  constexpr double share = 0.9;
  const auto impulse = impulse::frictionless_impulse(without_rebound(contact));
  if (!impulse.colliding) {
    return unchanged(contact);
  }
  return impulse::apply_impulse<double>(contact, Vector(impulse.on_a * share));
}

/// Applies the impulse that would stop the approach if driven walls were at rest.
Solved ground_taken_as_at_rest(const Contact& contact) {
  if (!impulse::is_colliding(contact, impulse::normal_velocity(contact))) {
    return unchanged(contact);
  }
  Contact resting = without_rebound(contact);
  for (ContactBody* body : {&resting.a, &resting.b}) {
    if (body->inverse_mass == 0) {
      body->velocity.setZero();
      body->angular_velocity.setZero();
    }
  }
  const auto impulse = impulse::frictionless_impulse(resting);
  return impulse.colliding ? impulse::apply_impulse<double>(contact, impulse.on_a) : unchanged(contact);
}

// Momentum.

/// The heavier body gets nine tenths of the impulse on the lighter body. Both impulses are scaled so that N·V⁺ = −ε
/// N·V⁻.
Solved heavier_gets_less(const Contact& contact) {
  constexpr double share = 0.9;
  const double approach = impulse::normal_velocity(contact);
  if (!impulse::is_colliding(contact, approach)) {
    return unchanged(contact);
  }
  const auto share_of = [&](const ContactBody& body, const ContactBody& other) {
    const bool is_heavier = body.inverse_mass > 0 && body.inverse_mass < other.inverse_mass;
    return is_heavier ? share : 1.0;
  };
  const double of_a = share_of(contact.a, contact.b);
  const double of_b = share_of(contact.b, contact.a);
  const Vector& n = contact.normal;
  const bool slender = impulse::has_slender(contact);
  const auto response = [&](const ContactBody& body) {
    return body.inverse_mass * n.dot(n) + impulse::turning(body.inertia, body.lever_arm, n, slender).along_impulse;
  };
  const Vector impulse =
      n * (-(1 + contact.restitution) * approach / (of_a * response(contact.a) + of_b * response(contact.b)));
  return Outcome<double>{impulse::apply_impulse<double>(contact.a, Vector(impulse * of_a), slender),
                         impulse::apply_impulse<double>(contact.b, Vector(-impulse * of_b), slender)};
}

/// Halves each body's spin about the normal, without a reaction on the other body.
Solved spin_about_normal_halved(const Contact& contact) {
  if (!impulse::is_colliding(contact, impulse::normal_velocity(contact))) {
    return unchanged(contact);
  }
  Outcome<double> outcome = impulse::frictionless(contact);
  const Vector n = contact.normal.stableNormalized();
  const auto halve = [&](const ContactBody& body, BodyVelocity<double>& after) {
    if (body.inverse_mass > 0) {
      after.angular_velocity -= n * (n.dot(after.angular_velocity) / 2);
    }
  };
  halve(contact.a, outcome.a);
  halve(contact.b, outcome.b);
  return outcome;
}

// The matrix.

struct Reflected {
  Outcome<double> outcome;
  Vector impulse = Vector::Zero();
  std::optional<Matrix> matrix;
};

Reflected reflected(const Contact& contact) {
  Reflected result;
  const auto impulse = impulse::reflection_impulse(contact, impulse::normal_velocity(contact),
                                                   [&](const Matrix& matrix) { result.matrix = matrix; });
  result.outcome = impulse::apply_impulse(contact, impulse);
  result.impulse = impulse.on_a;
  return result;
}

Solved solve_reflection(const Contact& contact) {
  const Reflected answer = reflected(contact);
  return {answer.outcome, answer.matrix};
}

/// Reports (K F)(K F)ᵀ / (F·K F). This matrix maps the impulse F to K F, as K does.
Solved guessed_from_one_impulse(const Contact& contact) {
  Reflected answer = reflected(contact);
  if (answer.matrix) {
    const Vector change = *answer.matrix * answer.impulse;
    const double size = change.stableNorm();
    const Vector along = change / size;
    answer.matrix = along * along.transpose() * (size / along.dot(answer.impulse));
  }
  return {answer.outcome, answer.matrix};
}

/// Reports a matrix with the wrong sign in one direction orthogonal to the impulse.
Solved reversed_across_impulse(const Contact& contact) {
  Reflected answer = reflected(contact);
  if (answer.matrix) {
    const Vector f = answer.impulse.stableNormalized();
    int least = 0;
    f.cwiseAbs().minCoeff(&least);
    const Vector across = f.cross(Vector::Unit(least)).stableNormalized();
    *answer.matrix -= across * across.transpose() * (2 * across.dot(*answer.matrix * across));
  }
  return {answer.outcome, answer.matrix};
}

/// Solves without friction, so that F is parallel to N. Reports K without half of its Schur complement across N. The
/// impulse does not show the error, because K N does not change.
Solved halved_across_normal(const Contact& contact) {
  Solved answer = impulse::frictionless(contact);
  if (impulse::is_colliding(contact, impulse::normal_velocity(contact))) {
    const Matrix k = impulse::collision_matrix(contact);
    const Vector n = contact.normal.stableNormalized();
    const Vector along = k * n;
    answer.collision_matrix = (k + along * along.transpose() / n.dot(along)) / 2;
  }
  return answer;
}

/// Reports λI with λ = 1/m_A + 1/m_B, as if no impulse turned a body.
Solved matrix_of_masses_alone(const Contact& contact) {
  Reflected answer = reflected(contact);
  if (answer.matrix) {
    answer.matrix = Matrix::Identity() * impulse::inverse_mass(contact);
  }
  return {answer.outcome, answer.matrix};
}

/// Reports K + [f]× with f parallel to F. The impulse does not show the error, because f × F = 0.
Solved not_symmetric(const Contact& contact) {
  Reflected answer = reflected(contact);
  if (answer.matrix) {
    const Vector f = answer.impulse.stableNormalized() * answer.matrix->trace();
    Matrix skew;
    skew << 0, -f[2], f[1], f[2], 0, -f[0], -f[1], f[0], 0;
    *answer.matrix += skew;
  }
  return {answer.outcome, answer.matrix};
}

const std::array defects{
    BrokenProperty{"stopped_short",
                   "non_penetrating_post_velocity",
                   "the impulse is nine tenths of what stops the approach",
                   {"non_penetration"},
                   [] { return without_restitution(claiming_any("stopped_short", false, stopped_short)); }},
    BrokenProperty{
        "ground_taken_as_at_rest",
        "non_penetrating_post_velocity",
        "a moving immovable body is taken to be at rest",
        {"non_penetration", "parting_speed", "impulse_bound"},
        [] { return without_restitution(claiming_any("ground_taken_as_at_rest", false, ground_taken_as_at_rest)); }},
    BrokenProperty{"guessed_from_one_impulse",
                   "positive_definiteness",
                   "C is guessed from the one impulse, and has rank one",
                   {"definite", "matrix_used"},
                   [] { return claiming_any("guessed_from_one_impulse", true, guessed_from_one_impulse); }},
    BrokenProperty{"reversed_across_impulse",
                   "positive_definiteness",
                   "C has the wrong sign in a direction across the impulse",
                   {"definite", "matrix_used"},
                   [] { return claiming_any("reversed_across_impulse", true, reversed_across_impulse); }},
    BrokenProperty{"halved_across_normal",
                   "positive_definiteness",
                   "C lacks half of its Schur complement across the normal",
                   {"definite", "matrix_used"},
                   [] { return claiming_any("halved_across_normal", true, halved_across_normal); }},
    BrokenProperty{"matrix_of_masses_alone",
                   "positive_definiteness",
                   "C is shown as if no body turned",
                   {"matrix_used"},
                   [] { return claiming_any("matrix_of_masses_alone", true, matrix_of_masses_alone); }},
    BrokenProperty{"not_symmetric",
                   "positive_definiteness",
                   "C has a skew part about the impulse",
                   {"matrix_used"},
                   [] { return claiming_any("not_symmetric", true, not_symmetric); }},
    BrokenProperty{"heavier_gets_less",
                   "momentum_conservation",
                   "the heavier body gets nine tenths of the impulse on the lighter one",
                   {"linear_momentum", "angular_momentum", "impulse_bound"},
                   [] { return claiming_any("heavier_gets_less", false, heavier_gets_less); }},
    BrokenProperty{"spin_about_normal_halved",
                   "momentum_conservation",
                   "each body's spin about the normal is halved, and nothing takes it up",
                   {"angular_momentum"},
                   [] { return claiming_any("spin_about_normal_halved", false, spin_about_normal_halved); }},
};

}  // namespace

std::span<const BrokenProperty> broken_properties() { return defects; }

std::vector<Subject> unbroken_subjects() {
  return {claiming_any("frictionless", false, solve_frictionless), claiming_any("reflection", true, solve_reflection)};
}

}  // namespace carom::mutants
