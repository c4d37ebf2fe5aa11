// SPDX-License-Identifier: BSL-1.0
#include "drawn_solver.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <carom/collision/validate.hpp>
#include <carom/impulse/coulomb.hpp>
#include <carom/impulse/laws.hpp>

namespace carom::mutants {
namespace {

using Vector = Vector3<double>;
using Matrix = Matrix3<double>;
using ContactBody = impulse::ContactBody<double>;
using Contact = impulse::Contact<double>;

bool same(const ContactBody& x, const ContactBody& y) {
  return x.inverse_mass == y.inverse_mass && x.inertia.axes == y.inertia.axes &&
         x.inertia.inverse_moments == y.inertia.inverse_moments && x.lever_arm == y.lever_arm;
}
bool same(const Contact& x, const Contact& y) { return same(x.a, y.a) && same(x.b, y.b); }

/// N·V of the contact as the built-in solvers compute it, and V with this N·V.
Vector velocity_of(const Contact& contact) { return impulse::relative_velocity_along_normal(contact); }

/// The contact with V⁻ as the only motion, so that each built-in law sees this V⁻.
Contact moving_with(Contact contact, const Vector& velocity) {
  contact.a.velocity = velocity;
  contact.b.velocity.setZero();
  contact.a.angular_velocity.setZero();
  contact.b.angular_velocity.setZero();
  return contact;
}

impulse::ContactImpulse<double> built_in(Law law, const Contact& contact) {
  if (law == Law::coulomb) {
    return contact.friction > 0 ? impulse::coulomb_impulse(contact) : impulse::frictionless_impulse(contact);
  }
  impulse::ContactImpulse<double> result{};
  impulse::with_law(law, [&](const auto& solve) { result = acting_impulse(solve(contact)); });
  return result;
}

class Solver {
 public:
  Solver(Law law, std::vector<Change> changes) : law_(law), changes_(std::move(changes)) {}

  [[nodiscard]] Answer answer(const Collision& collision) const {
    const std::vector<InputError> refusal = validate(collision);
    if (!refusal.empty()) {
      return Refused{describe(refusal)};
    }
    return reported(solved(collision));
  }

 private:
  [[nodiscard]] Contact data_in(Use use, const Contact& given, const Collision& read) const {
    Contact used = given;
    for (const Change& change : changes_) {
      if ((change.uses & use) != 0) {
        change.data(used, read);
      }
    }
    return used;
  }

  [[nodiscard]] bool is_solved(const Problem& problem, bool approaches) const {
    const auto change = std::ranges::find_if(changes_, [](const Change& one) { return bool(one.test); });
    return impulse::inverse_mass(problem.contact) > 0 &&
           (change == changes_.end() ? approaches : change->test(problem));
  }

  /// The impulse of the problem. A built-in solver computes it if it can.
  [[nodiscard]] impulse::ContactImpulse<double> impulse_of(const Problem& problem, const Contact& moving,
                                                           const Matrix& given) const {
    const auto change = std::ranges::find_if(changes_, [](const Change& one) { return bool(one.impulse); });
    const auto of_vector = [&](const Vector& on_a) { return contact_impulse(problem.contact, true, on_a); };
    if (change != changes_.end()) {
      return of_vector(change->impulse(problem));
    }
    if (problem.matrix != given || !impulse::is_made_of_valid(problem.contact) ||
        problem.contact.normal.dot(problem.velocity) >= 0) {
      return of_vector(impulse_by_matrix(problem));
    }
    const bool is_as_given = problem.velocity == velocity_of(moving) && same(problem.contact, moving);
    Contact contact = is_as_given ? moving : moving_with(problem.contact, problem.velocity);
    contact.restitution = problem.contact.restitution;
    contact.friction = problem.contact.friction;
    contact.tangential_restitution = problem.contact.tangential_restitution;
    return built_in(law_, contact);
  }

  [[nodiscard]] Outcome<double> solved(const Collision& collision) const {
    Collision read = collision;
    for (const Change& change : changes_) {
      if (change.read) {
        change.read(read);
      }
    }
    const Contact given = impulse::make_contact<double>(read);
    const Contact moving = data_in(in_velocity, given, read);
    const Contact struck = data_in(in_application, given, read);
    Problem problem{law_, data_in(in_matrix, given, read), velocity_of(moving), Matrix::Zero()};
    problem.matrix = impulse::collision_matrix(problem.contact);
    Outcome<double> after = unchanged(collision);
    if (is_solved(problem, impulse::normal_velocity(moving) < 0)) {
      const Matrix matrix = problem.matrix;
      for (const Change& change : changes_) {
        if (change.problem) {
          change.problem(problem);
        }
      }
      impulse::ContactImpulse<double> impulse = impulse_of(problem, moving, matrix);
      const Vector computed = impulse.on_a;
      for (const Change& change : changes_) {
        if (change.impulse_after) {
          change.impulse_after(impulse.on_a, problem);
        }
      }
      const bool is_as_computed = impulse.on_a == computed && same(problem.contact, struck) && impulse.colliding;
      after = is_as_computed ? apply_impulse(struck, impulse) : apply_impulse(struck, impulse.on_a);
    }
    for (const Change& change : changes_) {
      if (change.outcome) {
        change.outcome(after);
      }
    }
    return after;
  }

  Law law_;
  std::vector<Change> changes_;
};

Vector rough_by_matrix(const Problem& p, const Vector& normal_impulse) {
  const Vector& n = p.contact.normal;
  const Vector stop = n * (-n.dot(p.velocity) / n.dot(p.matrix * n));
  const Vector d = -impulse::Ldlt::solve<double>(p.matrix, p.velocity) - stop;
  const double whole = 1 + p.contact.tangential_restitution;
  const double limit = p.contact.friction * n.dot(normal_impulse);
  const double divisor = n.cross(d).norm() - p.contact.friction * n.dot(d);
  return normal_impulse + d * (whole * divisor <= limit ? whole : limit / divisor);
}

Vector coulomb_by_matrix(const Problem& p) {
  const Matrix basis = impulse::stable_tangent_basis(p.contact);
  Vector change = -(basis.transpose() * p.velocity);
  change[0] *= 1 + p.contact.restitution;
  const impulse::detail::SlipResistance<double> law(impulse::in_basis<double>(p.matrix, basis), change,
                                                    impulse::inverse_mass(p.contact), p.contact.friction);
  const Vector sticking = law.impulse(0);
  return basis * (law.is_in_cone(sticking) ? sticking : law.impulse_on_cone());
}

}  // namespace

Vector3<double> impulse_by_matrix(const Problem& p) {
  const Vector& n = p.contact.normal;
  const double approach = n.dot(p.velocity);
  const double change = -(1 + p.contact.restitution) * approach;
  const Vector normal_impulse = n * (change / n.dot(p.matrix * n));
  switch (p.law) {
    case Law::reflection:
      return impulse::Ldlt::solve<double>(p.matrix, n * (change / n.squaredNorm()));
    case Law::sticking:
      return impulse::Ldlt::solve<double>(p.matrix,
                                          -(p.velocity + n * (p.contact.restitution * approach / n.squaredNorm())));
    case Law::rough:
      return approach < 0 && change > 0 ? rough_by_matrix(p, normal_impulse) : normal_impulse;
    case Law::coulomb:
      return approach < 0 && change > 0 && p.contact.friction > 0 ? coulomb_by_matrix(p) : normal_impulse;
    case Law::frictionless:
    case Law::any:
      break;
  }
  return normal_impulse;
}

Subject changed_solver(std::string name, Law law, std::vector<Change> changes) {
  Subject subject;
  subject.name = std::move(name);
  subject.law = law;
  subject.precision = Precision::binary64;
  subject.open = [solver = Solver(law, std::move(changes))]() -> Session {
    return [solver](std::span<const Collision> collisions) {
      std::vector<Answer> answers;
      for (const Collision& collision : collisions) {
        answers.push_back(solver.answer(collision));
      }
      return answers;
    };
  };
  return subject;
}

}  // namespace carom::mutants
