// SPDX-License-Identifier: BSL-1.0
#include "drawn_solver.hpp"

#include <optional>
#include <utility>

#include <carom/impulse/coulomb.hpp>
#include <carom/impulse/laws.hpp>
#include <carom/subjects/session.hpp>

namespace carom::mutants {
namespace {

using Vector = Vector3<double>;
using Matrix = Matrix3<double>;
using ContactBody = impulse::ContactBody<double>;
using Contact = impulse::Contact<double>;
using ContactImpulse = impulse::ContactImpulse<double>;

/// Whether the bodies have the same data, but for their motion.
bool same_bodies(const Contact& x, const Contact& y) {
  const auto same = [](const ContactBody& one, const ContactBody& other) {
    return one.inverse_mass == other.inverse_mass && one.inertia.axes == other.inertia.axes &&
           one.inertia.inverse_moments == other.inertia.inverse_moments && one.lever_arm == other.lever_arm;
  };
  return same(x.a, y.a) && same(x.b, y.b);
}

ContactImpulse built_in(Law law, const Contact& contact) {
  if (law == Law::coulomb) {
    return contact.friction > 0 ? impulse::coulomb_impulse(contact) : impulse::frictionless_impulse(contact);
  }
  ContactImpulse result{};
  impulse::with_law(law, [&](const auto& solve) { result = acting_impulse(solve(contact)); });
  return result;
}

class Solver {
 public:
  Solver(Law law, std::vector<DrawnChange> changes) : law_(law), changes_(std::move(changes)) {}

  [[nodiscard]] Outcome<double> solved(const Collision& collision) const {
    Collision read = collision;
    change_data(everywhere, read);
    Contact moving = impulse::make_contact<double>(read);
    Contact of_matrix = moving;
    Contact struck = moving;
    change_data(in_velocity, moving, read);
    change_data(in_matrix, of_matrix, read);
    change_data(in_application, struck, read);
    const Problem problem{law_, of_matrix, impulse::relative_velocity_along_normal(moving),
                          impulse::collision_matrix(of_matrix), read.normal.stableNorm()};
    const bool approaches = replaced<bool>(problem).value_or(impulse::normal_velocity(moving) < 0);
    Outcome<double> after = unchanged(collision);
    if (approaches && impulse::inverse_mass(of_matrix) > 0) {
      after = pushed(problem, moving, struck);
    }
    change(after);
    return after;
  }

 private:
  template <class... Args>
  static void make(const DrawnChange& one, Args&... args) {
    if (const auto* change = std::get_if<void (*)(Args & ..., const Drawn&)>(&one.change)) {
      (*change)(args..., one.drawn);
    }
  }

  template <class... Args>
  void change(Args&... args) const {
    for (const DrawnChange& one : changes_) {
      make(one, args...);
    }
  }

  /// Changes the collision or contact, or its bodies at the place, if the use is that of the place.
  template <class Data, class... Read>
  void change_data(Use use, Data& data, const Read&... read) const {
    for (const DrawnChange& one : changes_) {
      const auto [a, b, used] = one.drawn.at;
      if ((used & use) == 0) {
        continue;
      }
      make(one, data, read...);
      if (a) {
        make(one, data.a, read.a...);
      }
      if (b) {
        make(one, data.b, read.b...);
      }
    }
  }

  /// The result of the change that replaces the step with this result.
  template <class Result>
  [[nodiscard]] std::optional<Result> replaced(const Problem& problem) const {
    for (const auto& [change, drawn] : changes_) {
      if (const auto* step = std::get_if<Result (*)(const Problem&, const Drawn&)>(&change)) {
        return (*step)(problem, drawn);
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] Outcome<double> pushed(Problem problem, const Contact& moving, const Contact& struck) const {
    const Matrix given = problem.matrix;
    change(problem);
    ContactImpulse impulse = impulse_of(problem, moving, given);
    const Vector computed = impulse.on_a;
    change(impulse.on_a, std::as_const(problem));
    const bool is_as_computed = impulse.on_a == computed && same_bodies(problem.contact, struck) && impulse.colliding;
    return is_as_computed ? apply_impulse(struck, impulse) : apply_impulse(struck, impulse.on_a);
  }

  /// The impulse of the problem. A built-in solver computes it if it can. `given` is the matrix without changes.
  [[nodiscard]] ContactImpulse impulse_of(const Problem& problem, const Contact& moving, const Matrix& given) const {
    if (const std::optional<Vector> wrong = replaced<Vector>(problem)) {
      return contact_impulse(problem.contact, true, *wrong);
    }
    if (problem.matrix != given || !impulse::is_made_of_valid(problem.contact) ||
        problem.contact.normal.dot(problem.velocity) >= 0) {
      return contact_impulse(problem.contact, true, impulse_by_matrix(problem));
    }
    Contact contact = problem.contact;
    if (problem.velocity == impulse::relative_velocity_along_normal(moving) && same_bodies(contact, moving)) {
      contact = moving;
    } else {  // V⁻ as the only motion, so that each built-in law sees this V⁻
      contact.a.velocity = problem.velocity;
      contact.b.velocity.setZero();
      contact.a.angular_velocity.setZero();
      contact.b.angular_velocity.setZero();
    }
    contact.restitution = problem.contact.restitution;
    contact.friction = problem.contact.friction;
    contact.tangential_restitution = problem.contact.tangential_restitution;
    return built_in(law_, contact);
  }

  Law law_;
  std::vector<DrawnChange> changes_;
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

Subject changed_solver(std::string name, Law law, std::vector<DrawnChange> changes) {
  Subject subject;
  subject.name = std::move(name);
  subject.law = law;
  subject.open = [solver = Solver(law, std::move(changes))] {
    return subjects::session_of([solver](const Collision& collision) { return reported(solver.solved(collision)); });
  };
  return subject;
}

}  // namespace carom::mutants
