// SPDX-License-Identifier: BSL-1.0
#include <optional>
#include <string>

#include <carom/impulse/collision_matrix.hpp>
#include <carom/impulse/frictionless.hpp>
#include <carom/impulse/reflection.hpp>
#include <carom/subjects/session.hpp>

#include "catalogue.hpp"

namespace carom::mutants {
namespace {

using Vector = Vector3<double>;
using Matrix = Matrix3<double>;
using Contact = impulse::Contact<double>;
using ContactBody = impulse::ContactBody<double>;
using Solved = SolvedOutcome<double>;

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

/// Reflects, and reports the collision matrix after `damage(matrix, impulse)`.
template <class Damage>
Solved reflected(const Contact& contact, const Damage& damage) {
  std::optional<Matrix> shown;
  const auto impulse = impulse::reflection_impulse(contact, impulse::normal_velocity(contact),
                                                   [&](const Matrix& matrix) { shown = matrix; });
  if (shown) {
    damage(*shown, impulse.on_a);
  }
  return {impulse::apply_impulse(contact, impulse), shown};
}

Solved solve_reflection(const Contact& contact) {
  return reflected(contact, [](Matrix&, const Vector&) {});
}

/// Reports (K F)(K F)ᵀ / (F·K F). This matrix maps the impulse F to K F, as K does.
Solved guessed_from_one_impulse(const Contact& contact) {
  return reflected(contact, [](Matrix& matrix, const Vector& impulse) {
    const Vector change = matrix * impulse;
    const double size = change.stableNorm();
    const Vector along = change / size;
    matrix = along * along.transpose() * (size / along.dot(impulse));
  });
}

/// Reports a matrix with the wrong sign in one direction orthogonal to the impulse.
Solved reversed_across_impulse(const Contact& contact) {
  return reflected(contact, [](Matrix& matrix, const Vector& impulse) {
    const Vector f = impulse.stableNormalized();
    int least = 0;
    f.cwiseAbs().minCoeff(&least);
    const Vector across = f.cross(Vector::Unit(least)).stableNormalized();
    matrix -= across * across.transpose() * (2 * across.dot(matrix * across));
  });
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
  return reflected(
      contact, [&](Matrix& matrix, const Vector&) { matrix = Matrix::Identity() * impulse::inverse_mass(contact); });
}

/// Reports K + [f]× with f parallel to F. The impulse does not show the error, because f × F = 0.
Solved not_symmetric(const Contact& contact) {
  return reflected(contact, [](Matrix& matrix, const Vector& impulse) {
    const Vector f = impulse.stableNormalized() * matrix.trace();
    Matrix skew;
    skew << 0, -f[2], f[1], f[2], 0, -f[0], -f[1], f[0], 0;
    matrix += skew;
  });
}

constexpr BrokenProperty defects[]{
    {"stopped_short", "non_penetrating_post_velocity", "non_penetration", stopped_short},
    {"ground_taken_as_at_rest", "non_penetrating_post_velocity", "non_penetration parting_speed impulse_bound",
     ground_taken_as_at_rest},
    {"guessed_from_one_impulse", "positive_definiteness", "definite matrix_used", guessed_from_one_impulse},
    {"reversed_across_impulse", "positive_definiteness", "definite matrix_used", reversed_across_impulse},
    {"halved_across_normal", "positive_definiteness", "definite matrix_used", halved_across_normal},
    {"matrix_of_masses_alone", "positive_definiteness", "matrix_used", matrix_of_masses_alone},
    {"not_symmetric", "positive_definiteness", "matrix_used", not_symmetric},
    {"heavier_gets_less", "momentum_conservation", "linear_momentum angular_momentum impulse_bound", heavier_gets_less},
    {"spin_about_normal_halved", "momentum_conservation", "angular_momentum", spin_about_normal_halved},
};

Subject claiming_any(std::string_view name, Solved (*solve)(const Contact&)) {
  Subject subject;
  subject.name = name;
  subject.law = Law::any;
  subject.precision = Precision::binary64;
  subject.open = [solve] {
    return subjects::session_of([solve](const Collision& collision) -> Answer {
      return reported(solve(impulse::make_contact<double>(collision)));
    });
  };
  return subject;
}

}  // namespace

std::span<const BrokenProperty> broken_properties() { return defects; }

Subject subject_of(const BrokenProperty& broken) {
  Subject subject = claiming_any(broken.name, broken.solve);
  subject.shows_collision_matrix = broken.property == "positive_definiteness";
  if (broken.property == "non_penetrating_post_velocity") {
    subject.deviates.emplace_back("restitution");
  }
  return subject;
}

std::vector<Subject> unbroken_subjects() {
  std::vector<Subject> subjects{claiming_any("frictionless", solve_frictionless),
                                claiming_any("reflection", solve_reflection)};
  subjects[1].shows_collision_matrix = true;
  return subjects;
}

}  // namespace carom::mutants
