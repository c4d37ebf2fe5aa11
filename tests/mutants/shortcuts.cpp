// SPDX-License-Identifier: BSL-1.0
#include "shortcuts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include <carom/properties/draws/relative_velocity.hpp>
#include <carom/properties/features/geometry.hpp>
#include <carom/properties/gate/gate_report.hpp>
#include <carom/properties/gate/trial.hpp>
#include <carom/subjects/catalogue.hpp>
#include <carom/subjects/session.hpp>

namespace carom::mutants {
namespace {

using properties::relative_velocity;
using properties::features::lever_arm;
using Vector = Vector3<double>;

template <class Read>
void of_each_body(Collision& c, const Read& read) {
  read(c.a);
  read(c.b);
}

template <class Read>
void of_movable(Collision& c, const Read& read) {
  for (Body* body : {&c.a, &c.b}) {
    if (!body->immovable) {
      read(*body);
    }
  }
}

bool are_movable(const Collision& c) { return !c.a.immovable && !c.b.immovable; }

void take_if_near(double& x, double special, double t) { x = std::abs(x - special) <= t ? special : x; }

/// The vector, or its part along the direction if the rest is at most t of it.
Vector along(const Vector& v, const Vector& direction, double t) {
  if (direction.isZero(0) || direction.cross(v).norm() > t * direction.norm() * v.norm()) {
    return v;
  }
  return direction * (direction.dot(v) / direction.squaredNorm());
}

/// The vector, or its part across the direction if the rest is at most t of it.
Vector across(const Vector& v, const Vector& direction, double t) {
  if (direction.isZero(0) || std::abs(direction.dot(v)) > t * direction.norm() * v.norm()) {
    return v;
  }
  return v - direction * (direction.dot(v) / direction.squaredNorm());
}

/// Components of at most t of the vector become zero.
Vector without_small(const Vector& v, double t) {
  const double limit = t * v.norm();
  return v.unaryExpr([limit](double x) { return std::abs(x) <= limit ? 0 : x; });
}

/// The axis that the vector lies along to t, and otherwise the vector.
Vector along_axis(const Vector& v, double t) {
  const Vector on_axis = without_small(v, t);
  return (on_axis.array() != 0).count() == 1 ? on_axis : v;
}

void set_arm(const Collision& c, Body& body, const Vector& r) {
  if (r != lever_arm(c, body)) {
    body.position = c.point - r;
  }
}

void take_for_sphere(Vector& moments, double t) {
  if (moments.maxCoeff() - moments.minCoeff() <= t * moments.maxCoeff()) {
    moments.setConstant(moments.maxCoeff());
  }
}

void take_for_top(Vector& moments, double t) {
  for (int i = 0; i < 3; ++i) {
    double& next = moments[(i + 1) % 3];
    take_if_near(next, moments[i], t * moments[i]);
  }
}

void take_for_flat(Vector& moments, double t) {
  int place = 0;
  const double largest = moments.maxCoeff(&place);
  take_if_near(moments[place], moments.sum() - largest, t * largest);
}

void take_for_quarter_turn(Quaternion<double>& q, double t) {
  int place = 0;
  (void)q.tail<3>().cwiseAbs().maxCoeff(&place);
  Quaternion<double> special = Quaternion<double>::Zero();
  special[0] = q[0];
  special[place + 1] = std::copysign(q[0], q[place + 1]);
  q = (q - special).norm() <= t * q.norm() ? special : q;
}

constexpr std::array shortcuts{
    Shortcut{"orientation_unit", Law::reflection, "q is normalised only if ‖q‖² differs from 1 by more than t",
             [](Collision& c, double t) {
               of_movable(c, [t](Body& b) {
                 const double squared = b.orientation.squaredNorm();
                 // R is ‖q‖² times the rotation, so J⁻¹ = R diag(1/I) Rᵀ is ‖q‖⁴ times as large.
                 b.principal_inertia /= std::abs(squared - 1) <= t ? squared * squared : 1;
               });
             }},
    Shortcut{"orientation_identity", Law::reflection, "rotations below t are dropped",
             [](Collision& c, double t) {
               of_movable(c, [t](Body& b) {
                 if (b.orientation.tail<3>().norm() <= t * std::abs(b.orientation[0])) {
                   b.orientation = {1, 0, 0, 0};
                 }
               });
             }},
    Shortcut{"orientation_half_turn", Law::sticking, "a turn within t of a half turn is a half turn",
             [](Collision& c, double t) {
               of_movable(c, [t](Body& b) { take_if_near(b.orientation[0], 0, t * b.orientation.norm()); });
             }},
    Shortcut{"orientation_quarter_turn", Law::frictionless, "a turn within t of a quarter turn about an axis is that",
             [](Collision& c, double t) { of_movable(c, [t](Body& b) { take_for_quarter_turn(b.orientation, t); }); }},
    Shortcut{"orientation_about_axis", Law::rough, "the axis of a turn within t of a coordinate axis is that axis",
             [](Collision& c, double t) {
               of_movable(c, [t](Body& b) { b.orientation.tail<3>() = along_axis(b.orientation.tail<3>(), t); });
             }},
    Shortcut{"orientations_equal", Law::rough, "orientations that agree to t are equal",
             [](Collision& c, double t) {
               if (are_movable(c) && (c.a.orientation - c.b.orientation).norm() <= t * c.a.orientation.norm()) {
                 c.b.orientation = c.a.orientation;
               }
             }},
    Shortcut{"moments_equal", Law::reflection, "moments that agree to t are those of a sphere",
             [](Collision& c, double t) { of_movable(c, [t](Body& b) { take_for_sphere(b.principal_inertia, t); }); }},
    Shortcut{"moments_two_equal", Law::coulomb, "two moments that agree to t are equal",
             [](Collision& c, double t) { of_movable(c, [t](Body& b) { take_for_top(b.principal_inertia, t); }); }},
    Shortcut{"moments_one", Law::sticking, "moments within t of 1 are 1",
             [](Collision& c, double t) {
               of_movable(c, [t](Body& b) {
                 for (double& moment : b.principal_inertia) {
                   take_if_near(moment, 1, t);
                 }
               });
             }},
    Shortcut{"flat", Law::rough, "a moment within t of the sum of the others is that sum",
             [](Collision& c, double t) { of_movable(c, [t](Body& b) { take_for_flat(b.principal_inertia, t); }); }},
    Shortcut{"mass_one", Law::frictionless, "a mass within t of 1 is 1",
             [](Collision& c, double t) { of_movable(c, [t](Body& b) { take_if_near(b.mass, 1, t); }); }},
    Shortcut{"masses_equal", Law::frictionless, "masses that agree to t are equal",
             [](Collision& c, double t) {
               if (are_movable(c)) {
                 take_if_near(c.b.mass, c.a.mass, t * c.a.mass);
               }
             }},
    Shortcut{"moments_alike", Law::sticking, "moments of both bodies that agree to t are the same",
             [](Collision& c, double t) {
               const Vector difference = c.a.principal_inertia - c.b.principal_inertia;
               if (are_movable(c) && difference.cwiseAbs().maxCoeff() <= t * c.a.principal_inertia.maxCoeff()) {
                 c.b.principal_inertia = c.a.principal_inertia;
               }
             }},
    Shortcut{"immovable", Law::coulomb, "a body is immovable if the other mass is at most t of its mass",
             [](Collision& c, double t) {
               if (are_movable(c)) {
                 Body& heavy = c.a.mass > c.b.mass ? c.a : c.b;
                 heavy.immovable = std::min(c.a.mass, c.b.mass) <= t * heavy.mass;
               }
             }},
    Shortcut{"at_origin", Law::frictionless, "a centre of mass within t lever arms of the origin is the origin",
             [](Collision& c, double t) {
               of_each_body(c, [&](Body& b) {
                 if (b.position.norm() <= t * lever_arm(c, b).norm()) {
                   b.position.setZero();
                 }
               });
             }},
    Shortcut{"lever_arm_zero", Law::reflection, "a lever arm below t radii of gyration is zero",
             [](Collision& c, double t) {
               of_movable(c, [&](Body& b) {
                 if (lever_arm(c, b).norm() <= t * properties::features::radius_of_gyration(b)) {
                   b.position = c.point;
                 }
               });
             }},
    Shortcut{"lever_arm_along_normal", Law::frictionless, "a lever arm within t of the normal lies along it",
             [](Collision& c, double t) {
               of_each_body(c, [&](Body& b) { set_arm(c, b, along(lever_arm(c, b), c.normal, t)); });
             }},
    Shortcut{"lever_arm_across_normal", Law::sticking, "a lever arm within t of the tangent plane lies in it",
             [](Collision& c, double t) {
               of_each_body(c, [&](Body& b) { set_arm(c, b, across(lever_arm(c, b), c.normal, t)); });
             }},
    Shortcut{"lever_arm_along_axis", Law::rough, "a lever arm within t of an axis lies along it",
             [](Collision& c, double t) {
               of_each_body(c, [&](Body& b) { set_arm(c, b, along_axis(lever_arm(c, b), t)); });
             }},
    Shortcut{"lever_arms_opposite", Law::reflection, "lever arms that are opposite to t are opposite",
             [](Collision& c, double t) {
               const Vector r = lever_arm(c, c.a);
               if ((r + lever_arm(c, c.b)).norm() <= t * r.norm()) {
                 set_arm(c, c.b, -r);
               }
             }},
    Shortcut{"velocity_zero", Law::frictionless, "a velocity below t of the approach is zero",
             [](Collision& c, double t) {
               const double limit = t * relative_velocity(c).norm();
               of_each_body(c, [limit](Body& b) { b.velocity *= b.velocity.norm() <= limit ? 0 : 1; });
             }},
    Shortcut{"velocity_along_axis", Law::reflection, "a velocity within t of an axis lies along it",
             [](Collision& c, double t) { of_each_body(c, [t](Body& b) { b.velocity = along_axis(b.velocity, t); }); }},
    Shortcut{
        "velocity_along_normal", Law::coulomb, "a velocity within t of the normal lies along it",
        [](Collision& c, double t) { of_each_body(c, [&](Body& b) { b.velocity = along(b.velocity, c.normal, t); }); }},
    Shortcut{"velocity_across_normal", Law::frictionless, "a velocity within t of the tangent plane lies in it",
             [](Collision& c, double t) {
               of_each_body(c, [&](Body& b) { b.velocity = across(b.velocity, c.normal, t); });
             }},
    Shortcut{"velocities_equal", Law::sticking, "velocities that agree to t are equal",
             [](Collision& c, double t) {
               if ((c.a.velocity - c.b.velocity).norm() <= t * c.a.velocity.norm()) {
                 c.b.velocity = c.a.velocity;
               }
             }},
    Shortcut{"spin_zero", Law::rough, "a spin is zero if the speed ‖w‖ ‖r‖ is below t of the approach",
             [](Collision& c, double t) {
               const double limit = t * relative_velocity(c).norm();
               of_each_body(c, [&](Body& b) {
                 b.angular_velocity *= b.angular_velocity.norm() * lever_arm(c, b).norm() <= limit ? 0 : 1;
               });
             }},
    Shortcut{"spin_along_axis", Law::sticking, "a spin within t of an axis lies along it",
             [](Collision& c, double t) {
               of_each_body(c, [t](Body& b) { b.angular_velocity = along_axis(b.angular_velocity, t); });
             }},
    Shortcut{"spin_along_normal", Law::reflection, "a spin within t of the normal lies along it",
             [](Collision& c, double t) {
               of_each_body(c, [&](Body& b) { b.angular_velocity = along(b.angular_velocity, c.normal, t); });
             }},
    Shortcut{"spin_along_lever_arm", Law::frictionless, "a spin within t of the lever arm does not move the contact",
             [](Collision& c, double t) {
               of_each_body(c, [&](Body& b) { b.angular_velocity = along(b.angular_velocity, lever_arm(c, b), t); });
             }},
    Shortcut{"rolling", Law::coulomb, "a contact point slower than t of its body's velocity is at rest",
             [](Collision& c, double t) {
               of_each_body(c, [&](Body& b) {
                 const Vector rolls = lever_arm(c, b).cross(b.angular_velocity);
                 b.velocity = (b.velocity - rolls).norm() <= t * b.velocity.norm() ? rolls : b.velocity;
               });
             }},
    Shortcut{"normal_along_axis", Law::frictionless, "a normal within t of an axis is that axis",
             [](Collision& c, double t) { c.normal = along_axis(c.normal, t); }},
    Shortcut{"normal_in_plane", Law::reflection, "components of the normal below t are zero",
             [](Collision& c, double t) { c.normal = without_small(c.normal, t); }},
    Shortcut{"normal_unit", Law::reflection, "N is normalised only if ‖N‖² differs from 1 by more than t",
             [](Collision& c, double t) {
               const double squared = c.normal.squaredNorm();
               // K F = −(1 + ε) (N·V⁻) N without the division by N·N: as with another ε.
               const double read = (1 + c.restitution) * squared - 1;
               c.restitution = std::abs(squared - 1) <= t ? std::clamp(read, 0.0, 1.0) : c.restitution;
             }},
    Shortcut{"restitution_zero", Law::coulomb, "ε below t is 0",
             [](Collision& c, double t) { take_if_near(c.restitution, 0, t); }},
    Shortcut{"restitution_one", Law::frictionless, "ε within t of 1 is 1",
             [](Collision& c, double t) { take_if_near(c.restitution, 1, t); }},
    Shortcut{"friction_zero", Law::coulomb, "μ below t is 0",
             [](Collision& c, double t) { take_if_near(c.friction, 0, t); }},
    Shortcut{"tangential_restitution_minus_one", Law::rough, "e_t within t of −1 is −1",
             [](Collision& c, double t) { take_if_near(c.tangential_restitution, -1, t); }},
    Shortcut{"tangential_restitution_zero", Law::rough, "e_t within t of 0 is 0",
             [](Collision& c, double t) { take_if_near(c.tangential_restitution, 0, t); }},
    Shortcut{"tangential_restitution_one", Law::rough, "e_t within t of 1 is 1",
             [](Collision& c, double t) { take_if_near(c.tangential_restitution, 1, t); }},
    Shortcut{"no_slip", Law::coulomb, "slip below t of V⁻ is none",
             [](Collision& c, double t) {
               const Vector v = relative_velocity(c);
               if (const Vector read = along(v, c.normal, t); read != v) {
                 properties::set_relative_velocity(c, read);
               }
             }},
};
static_assert(shortcuts.size() == 40);

Session session_of(Law law) {
  const std::string name = std::string(name_of(law)) + "-double";
  const std::optional<Subject> subject = subjects::subject_named(name);
  if (!subject) {
    throw std::logic_error("there is no subject " + name);
  }
  return subject->open();
}

Outcome<long double> outcome_of(Session& session, const Collision& collision) {
  return std::get<ReportedOutcome>(session(std::span(&collision, 1)).at(0));
}

bool are_same(const Collision& x, const Collision& y) {
  bool same = x.a.immovable == y.a.immovable && x.b.immovable == y.b.immovable;
  for_each_number([&](const FieldPath&, const double& of_x, const double& of_y) { same = same && of_x == of_y; }, x, y);
  return same;
}

/// The outcome as binary64.
Outcome<long double> answer_of(const Shortcut& shortcut, double threshold, Session& session, const Collision& c) {
  Collision read = c;
  shortcut.read(read, threshold);
  Outcome<long double> outcome = outcome_of(session, read);
  Outcome<long double> given = reported(unchanged(c));
  Outcome<long double> of_read = reported(unchanged(read));
  for (const OutcomeVector k : all_outcome_vectors) {
    Vector3<long double>& after = *vectors(outcome)[k];
    after += *vectors(given)[k] - *vectors(of_read)[k];
    after = after.cast<double>().cast<long double>();
  }
  return outcome;
}

bool differ(const Outcome<long double>& x, const Outcome<long double>& y) {
  const auto of_x = vectors(x);
  const auto of_y = vectors(y);
  return std::any_of(all_outcome_vectors.begin(), all_outcome_vectors.end(),
                     [&](OutcomeVector k) { return *of_x[k] != *of_y[k]; });
}

}  // namespace

std::span<const Shortcut> all_shortcuts() { return shortcuts; }

std::vector<double> drawn_thresholds(std::uint64_t seed) {
  constexpr double largest = -3;
  constexpr double least = -12;
  properties::Stream stream = properties::stream_from(seed);
  std::vector<double> thresholds;
  for (std::size_t i = 0; i < shortcuts.size(); ++i) {
    const double share = static_cast<double>(stream.bits() >> 11U) / static_cast<double>(properties::fractions);
    thresholds.push_back(std::pow(10, largest + share * (least - largest)));
  }
  return thresholds;
}

Subject subject_of(const Shortcut& shortcut, double threshold) {
  Subject subject;
  subject.name = shortcut.name;
  subject.law = shortcut.law;
  subject.precision = Precision::binary64;
  subject.open = [shortcut, threshold] {
    return subjects::session_of(
        [shortcut, threshold, session = session_of(shortcut.law)](const Collision& c) mutable -> Answer {
          return reported(answer_of(shortcut, threshold, session, c));
        });
  };
  return subject;
}

std::vector<std::uint64_t> rejecting_cases(std::span<const double> thresholds, std::uint64_t seed, std::uint64_t most,
                                           std::size_t most_missed) {
  struct OfLaw {
    properties::Claim claim;
    Session session;
  };
  std::map<Law, OfLaw> laws;
  for (const Shortcut& shortcut : shortcuts) {
    properties::Claim claim = properties::claim_of(subject_of(shortcut, 0), {});
    std::erase_if(claim.invariants, [](const properties::Invariant* invariant) {
      return !std::holds_alternative<properties::AboutOutcome>(invariant->about);
    });
    laws.try_emplace(shortcut.law, OfLaw{std::move(claim), session_of(shortcut.law)});
  }
  std::vector<std::uint64_t> rejecting(shortcuts.size());
  const auto judge = [&](const properties::Case& one) {
    std::optional<properties::JudgedCase> judged;
    for (std::size_t i = 0; i < shortcuts.size(); ++i) {
      auto& [claim, session] = laws.at(shortcuts[i].law);
      Collision read = one.collision;
      shortcuts[i].read(read, thresholds[i]);
      if (rejecting[i] == most || are_same(read, one.collision)) {
        continue;
      }
      const Outcome<long double> outcome = answer_of(shortcuts[i], thresholds[i], session, one.collision);
      if (!differ(outcome, outcome_of(session, one.collision))) {
        continue;
      }
      if (!judged) {
        judged.emplace(one);
      }
      const properties::Judgement judgement =
          properties::Trial(*judged, claim, properties::lift(Answer(reported(outcome))), properties::no_relations)
              .judge(std::span<const Answer>());
      const auto is_violated = [](const properties::NamedVerdict& named) {
        return named.verdict.status == properties::Status::violated;
      };
      rejecting[i] += std::any_of(judgement.verdicts.begin(), judgement.verdicts.end(), is_violated) ? 1 : 0;
    }
  };
  const auto pose = [&](const properties::Family& family) {
    const std::uint64_t cases = properties::cases_of({}, family);
    const auto missed = [&] {
      return static_cast<std::size_t>(std::ranges::count_if(rejecting, [&](auto x) { return x < most; }));
    };
    for (std::uint64_t i = 0; i < cases && missed() > most_missed; ++i) {
      judge(properties::drawn_case(family, seed, i));
    }
  };
  // The order decides only how soon each shortcut has `most` cases.
  const properties::Family* first = properties::family_named("near_special");
  pose(*first);
  for (const properties::Family& family : properties::all_families()) {
    if (&family != first && family.is_valid) {
      pose(family);
    }
  }
  return rejecting;
}

}  // namespace carom::mutants
