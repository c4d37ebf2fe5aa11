// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include <carom/collision/doubles.hpp>
#include <carom/properties/diagnosis/diagnosis.hpp>
#include <carom/properties/draws/relative_velocity.hpp>
#include <carom/properties/features/geometry.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/properties/gate/trial.hpp>
#include <carom/subjects/catalogue.hpp>
#include <carom/subjects/session.hpp>

namespace carom::mutants {
namespace {

using properties::relative_velocity;
using properties::features::lever_arm;
using Vector = Vector3<double>;
using enum Law;

/// A right solver that takes nearly special values for special ones. The threshold is a relative distance.
struct Shortcut {
  std::string_view name;  // of the near feature, without "near_"
  Law law;
  std::string_view sentence;  // what the solver does; t is the threshold
  /// Changes a body as the solver reads it, or else the collision.
  void (*read_body)(Body&, const Collision& given, double threshold);
  void (*read_collision)(Collision&, double threshold) = nullptr;
};

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

constexpr Shortcut shortcuts[]{
    {"orientation_unit", reflection, "q is normalised only if ‖q‖² differs from 1 by more than t",
     [](Body& b, const Collision&, double t) {
       const double squared = b.orientation.squaredNorm();
       // R is ‖q‖² times the rotation, so J⁻¹ = R diag(1/I) Rᵀ is ‖q‖⁴ times as large.
       b.principal_inertia /= std::abs(squared - 1) <= t ? squared * squared : 1;
     }},
    {"orientation_identity", reflection, "rotations below t are dropped",
     [](Body& b, const Collision&, double t) {
       if (b.orientation.tail<3>().norm() <= t * std::abs(b.orientation[0])) {
         b.orientation = {1, 0, 0, 0};
       }
     }},
    {"orientation_half_turn", sticking, "a turn within t of a half turn is a half turn",
     [](Body& b, const Collision&, double t) { take_if_near(b.orientation[0], 0, t * b.orientation.norm()); }},
    {"orientation_quarter_turn", frictionless, "a turn within t of a quarter turn about an axis is that",
     [](Body& b, const Collision&, double t) { take_for_quarter_turn(b.orientation, t); }},
    {"orientation_about_axis", rough, "the axis of a turn within t of a coordinate axis is that axis",
     [](Body& b, const Collision&, double t) { b.orientation.tail<3>() = along_axis(b.orientation.tail<3>(), t); }},
    {"orientations_equal", rough, "orientations that agree to t are equal", nullptr,
     [](Collision& c, double t) {
       if (are_movable(c) && (c.a.orientation - c.b.orientation).norm() <= t * c.a.orientation.norm()) {
         c.b.orientation = c.a.orientation;
       }
     }},
    {"moments_equal", reflection, "moments that agree to t are those of a sphere",
     [](Body& b, const Collision&, double t) { take_for_sphere(b.principal_inertia, t); }},
    {"moments_two_equal", coulomb, "two moments that agree to t are equal",
     [](Body& b, const Collision&, double t) { take_for_top(b.principal_inertia, t); }},
    {"moments_one", sticking, "moments within t of 1 are 1",
     [](Body& b, const Collision&, double t) {
       for (double& moment : b.principal_inertia) {
         take_if_near(moment, 1, t);
       }
     }},
    {"flat", rough, "a moment within t of the sum of the others is that sum",
     [](Body& b, const Collision&, double t) { take_for_flat(b.principal_inertia, t); }},
    {"mass_one", frictionless, "a mass within t of 1 is 1",
     [](Body& b, const Collision&, double t) { take_if_near(b.mass, 1, t); }},
    {"masses_equal", frictionless, "masses that agree to t are equal", nullptr,
     [](Collision& c, double t) {
       if (are_movable(c)) {
         take_if_near(c.b.mass, c.a.mass, t * c.a.mass);
       }
     }},
    {"moments_alike", sticking, "moments of both bodies that agree to t are the same", nullptr,
     [](Collision& c, double t) {
       const Vector difference = c.a.principal_inertia - c.b.principal_inertia;
       if (are_movable(c) && difference.cwiseAbs().maxCoeff() <= t * c.a.principal_inertia.maxCoeff()) {
         c.b.principal_inertia = c.a.principal_inertia;
       }
     }},
    {"immovable", coulomb, "a body is immovable if the other mass is at most t of its mass", nullptr,
     [](Collision& c, double t) {
       if (are_movable(c)) {
         Body& heavy = c.a.mass > c.b.mass ? c.a : c.b;
         heavy.immovable = std::min(c.a.mass, c.b.mass) <= t * heavy.mass;
       }
     }},
    {"at_origin", frictionless, "a centre of mass within t lever arms of the origin is the origin",
     [](Body& b, const Collision& c, double t) {
       if (b.position.norm() <= t * lever_arm(c, b).norm()) {
         b.position.setZero();
       }
     }},
    {"lever_arm_zero", reflection, "a lever arm below t radii of gyration is zero",
     [](Body& b, const Collision& c, double t) {
       if (!b.immovable && lever_arm(c, b).norm() <= t * properties::features::radius_of_gyration(b)) {
         b.position = c.point;
       }
     }},
    {"lever_arm_along_normal", frictionless, "a lever arm within t of the normal lies along it",
     [](Body& b, const Collision& c, double t) { set_arm(c, b, along(lever_arm(c, b), c.normal, t)); }},
    {"lever_arm_across_normal", sticking, "a lever arm within t of the tangent plane lies in it",
     [](Body& b, const Collision& c, double t) { set_arm(c, b, across(lever_arm(c, b), c.normal, t)); }},
    {"lever_arm_along_axis", rough, "a lever arm within t of an axis lies along it",
     [](Body& b, const Collision& c, double t) { set_arm(c, b, along_axis(lever_arm(c, b), t)); }},
    {"lever_arms_opposite", reflection, "lever arms that are opposite to t are opposite", nullptr,
     [](Collision& c, double t) {
       const Vector r = lever_arm(c, c.a);
       if ((r + lever_arm(c, c.b)).norm() <= t * r.norm()) {
         set_arm(c, c.b, -r);
       }
     }},
    {"velocity_zero", frictionless, "a velocity below t of the approach is zero",
     [](Body& b, const Collision& c, double t) {
       const double limit = t * relative_velocity(c).norm();
       b.velocity *= b.velocity.norm() <= limit ? 0 : 1;
     }},
    {"velocity_along_axis", reflection, "a velocity within t of an axis lies along it",
     [](Body& b, const Collision&, double t) { b.velocity = along_axis(b.velocity, t); }},
    {"velocity_along_normal", coulomb, "a velocity within t of the normal lies along it",
     [](Body& b, const Collision& c, double t) { b.velocity = along(b.velocity, c.normal, t); }},
    {"velocity_across_normal", frictionless, "a velocity within t of the tangent plane lies in it",
     [](Body& b, const Collision& c, double t) { b.velocity = across(b.velocity, c.normal, t); }},
    {"velocities_equal", sticking, "velocities that agree to t are equal", nullptr,
     [](Collision& c, double t) {
       if ((c.a.velocity - c.b.velocity).norm() <= t * c.a.velocity.norm()) {
         c.b.velocity = c.a.velocity;
       }
     }},
    {"spin_zero", rough, "a spin is zero if the speed ‖w‖ ‖r‖ is below t of the approach",
     [](Body& b, const Collision& c, double t) {
       const double limit = t * relative_velocity(c).norm();
       b.angular_velocity *= b.angular_velocity.norm() * lever_arm(c, b).norm() <= limit ? 0 : 1;
     }},
    {"spin_along_axis", sticking, "a spin within t of an axis lies along it",
     [](Body& b, const Collision&, double t) { b.angular_velocity = along_axis(b.angular_velocity, t); }},
    {"spin_along_normal", reflection, "a spin within t of the normal lies along it",
     [](Body& b, const Collision& c, double t) { b.angular_velocity = along(b.angular_velocity, c.normal, t); }},
    {"spin_along_lever_arm", frictionless, "a spin within t of the lever arm does not move the contact",
     [](Body& b, const Collision& c, double t) { b.angular_velocity = along(b.angular_velocity, lever_arm(c, b), t); }},
    {"rolling", coulomb, "a contact point slower than t of its body's velocity is at rest",
     [](Body& b, const Collision& c, double t) {
       const Vector rolls = lever_arm(c, b).cross(b.angular_velocity);
       b.velocity = (b.velocity - rolls).norm() <= t * b.velocity.norm() ? rolls : b.velocity;
     }},
    {"normal_along_axis", frictionless, "a normal within t of an axis is that axis", nullptr,
     [](Collision& c, double t) { c.normal = along_axis(c.normal, t); }},
    {"normal_in_plane", reflection, "components of the normal below t are zero", nullptr,
     [](Collision& c, double t) { c.normal = without_small(c.normal, t); }},
    {"normal_unit", reflection, "N is normalised only if ‖N‖² differs from 1 by more than t", nullptr,
     [](Collision& c, double t) {
       const double squared = c.normal.squaredNorm();
       // K F = −(1 + ε) (N·V⁻) N without the division by N·N: as with another ε.
       const double read = (1 + c.restitution) * squared - 1;
       c.restitution = std::abs(squared - 1) <= t ? std::clamp(read, 0.0, 1.0) : c.restitution;
     }},
    {"restitution_zero", coulomb, "ε below t is 0", nullptr,
     [](Collision& c, double t) { take_if_near(c.restitution, 0, t); }},
    {"restitution_one", frictionless, "ε within t of 1 is 1", nullptr,
     [](Collision& c, double t) { take_if_near(c.restitution, 1, t); }},
    {"friction_zero", coulomb, "μ below t is 0", nullptr,
     [](Collision& c, double t) { take_if_near(c.friction, 0, t); }},
    {"tangential_restitution_minus_one", rough, "e_t within t of −1 is −1", nullptr,
     [](Collision& c, double t) { take_if_near(c.tangential_restitution, -1, t); }},
    {"tangential_restitution_zero", rough, "e_t within t of 0 is 0", nullptr,
     [](Collision& c, double t) { take_if_near(c.tangential_restitution, 0, t); }},
    {"tangential_restitution_one", rough, "e_t within t of 1 is 1", nullptr,
     [](Collision& c, double t) { take_if_near(c.tangential_restitution, 1, t); }},
    {"no_slip", coulomb, "slip below t of V⁻ is none", nullptr,
     [](Collision& c, double t) {
       const Vector v = relative_velocity(c);
       if (const Vector read = along(v, c.normal, t); read != v) {
         properties::set_relative_velocity(c, read);
       }
     }},
};
static_assert(std::size(shortcuts) == 40);

Collision as_read(const Shortcut& shortcut, double threshold, const Collision& given) {
  Collision read = given;
  if (shortcut.read_body == nullptr) {
    shortcut.read_collision(read, threshold);
  } else {
    shortcut.read_body(read.a, given, threshold);
    shortcut.read_body(read.b, given, threshold);
  }
  return read;
}

Session session_of(Law law) { return subjects::subject_named(std::string(name_of(law)) + "-double").value().open(); }

Outcome<long double> outcome_of(Session& session, const Collision& collision) {
  return std::get<ReportedOutcome>(session(std::span(&collision, 1)).at(0));
}

/// The change of the velocities is that of the collision as read. The outcome is rounded to binary64.
Outcome<long double> answer_of(const Collision& read, Session& session, const Collision& given) {
  Outcome<long double> outcome = outcome_of(session, read);
  const Outcome<double> before = unchanged(given);
  const Outcome<double> before_as_read = unchanged(read);
  for (const OutcomeVector k : all_outcome_vectors) {
    Vector3<long double>& after = *vectors(outcome)[k];
    after += vectors(before)[k]->cast<long double>() - vectors(before_as_read)[k]->cast<long double>();
    after = after.cast<double>().cast<long double>();
  }
  return outcome;
}

/// The built-in solver of the law, which gets the collision as read.
Subject subject_of(const Shortcut& shortcut, double threshold) {
  Subject subject;
  subject.name = shortcut.name;
  subject.law = shortcut.law;
  subject.precision = Precision::binary64;
  subject.open = [shortcut, threshold] {
    return subjects::session_of([=, session = session_of(shortcut.law)](const Collision& c) mutable -> Answer {
      return reported(answer_of(as_read(shortcut, threshold, c), session, c));
    });
  };
  return subject;
}

/// A threshold for each shortcut, from 10⁻³ to 10⁻¹². Their logarithms are uniform.
std::vector<double> drawn_thresholds() {
  constexpr double largest = -3;
  constexpr double least = -12;
  properties::Stream stream = properties::stream_from(1);
  std::vector<double> thresholds;
  for (std::size_t i = 0; i < std::size(shortcuts); ++i) {
    const double share = static_cast<double>(stream.bits() >> 11U) / static_cast<double>(properties::fractions);
    thresholds.push_back(std::pow(10, largest + share * (least - largest)));
  }
  return thresholds;
}

struct Solver {
  properties::Claim claim;
  Session session;
};

/// Whether the shortcut's answer differs from that of the built-in solver, and violates an invariant of one outcome. A
/// gate, which judges relations too, rejects at least these cases.
bool is_rejected(const Shortcut& shortcut, double threshold, Solver& solver, const properties::Case& one,
                 std::optional<properties::JudgedCase>& judged) {
  const Collision read = as_read(shortcut, threshold, one.collision);
  if (doubles_of(read) == doubles_of(one.collision)) {
    return false;
  }
  const Outcome<long double> outcome = answer_of(read, solver.session, one.collision);
  if (doubles_of(outcome) == doubles_of(outcome_of(solver.session, one.collision))) {
    return false;
  }
  if (!judged) {
    judged.emplace(one);
  }
  const auto judgement = judge_answer(*judged, solver.claim, properties::lift(Answer(reported(outcome))));
  return std::ranges::any_of(judgement.verdicts, [](const properties::NamedVerdict& named) {
    return named.verdict.status == properties::Status::violated;
  });
}

/// The cases of a default run with this seed that reject each shortcut, of which at most `most` are counted. The run
/// ends once all but `most_missed` shortcuts have `most` cases.
std::vector<std::uint64_t> rejecting_cases(std::span<const double> thresholds, std::uint64_t seed, std::uint64_t most,
                                           std::size_t most_missed) {
  std::map<Law, Solver> solvers;
  for (const Shortcut& shortcut : shortcuts) {
    solvers.try_emplace(shortcut.law,
                        Solver{properties::claim_of(subject_of(shortcut, 0), {}), session_of(shortcut.law)});
  }
  // The order decides only how soon each shortcut has `most` cases.
  std::vector<const properties::Family*> families{properties::family_named("near_special")};
  for (const properties::Family& family : properties::all_families()) {
    if (&family != families[0] && family.is_valid) {
      families.push_back(&family);
    }
  }
  std::vector<std::uint64_t> rejecting(std::size(shortcuts));
  for (const properties::Family* family : families) {
    for (std::uint64_t k = 0; k < properties::cases_of({}, *family); ++k) {
      if (static_cast<std::size_t>(std::ranges::count(rejecting, most)) + most_missed >= rejecting.size()) {
        return rejecting;
      }
      const properties::Case one = properties::drawn_case(*family, seed, k);
      std::optional<properties::JudgedCase> judged;
      for (std::size_t i = 0; i < rejecting.size(); ++i) {
        if (rejecting[i] < most &&
            is_rejected(shortcuts[i], thresholds[i], solvers.at(shortcuts[i].law), one, judged)) {
          ++rejecting[i];
        }
      }
    }
  }
  return rejecting;
}

/// Two of the forty shortcuts may be missed, because a threshold below about 10⁻¹² is within the permitted rounding.
class Shortcuts : public testing::TestWithParam<std::uint64_t> {};

TEST_P(Shortcuts, AreRejectedInTenCasesEach) {
  constexpr std::uint64_t wanted = 10;
  constexpr std::size_t most_missed = 2;
  const std::vector<double> thresholds = drawn_thresholds();
  const std::vector<std::uint64_t> rejecting = rejecting_cases(thresholds, GetParam(), wanted, most_missed);
  std::string missed;
  for (std::size_t i = 0; i < rejecting.size(); ++i) {
    if (rejecting[i] < wanted) {
      missed += std::string(shortcuts[i].name) + " (" + std::string(shortcuts[i].sentence) + ") at " +
                std::to_string(thresholds[i]) + ": " + std::to_string(rejecting[i]) + " cases\n";
    }
  }
  EXPECT_LE(std::ranges::count(missed, '\n'), most_missed) << missed;
}

INSTANTIATE_TEST_SUITE_P(Seeds, Shortcuts, testing::Values(1, 2, 3));

TEST(Shortcut, IsSoundWithoutAThreshold) {
  const std::vector<double> none(std::size(shortcuts), 0);
  EXPECT_EQ(rejecting_cases(none, 1, 1, 0), std::vector<std::uint64_t>(std::size(shortcuts)));
}

/// The diagnosis names the special value, and a distance near the threshold.
TEST(Shortcut, IsDiagnosedWithItsDistance) {
  constexpr double threshold = 1e-6;
  struct Expected {
    std::string_view shortcut;
    std::string_view special;
  };
  const std::array expected{Expected{"moments_equal", "the three moments are equal"},
                            Expected{"masses_equal", "both masses are equal"},
                            Expected{"lever_arm_along_normal", "the lever arm lies along the normal"}};
  properties::GateOptions options;
  options.shrinks = false;
  options.families = {properties::family_named("near_special"), properties::family_named("generic")};
  std::vector<Subject> subjects;
  for (const Expected& one : expected) {
    subjects.push_back(subject_of(*std::ranges::find(shortcuts, one.shortcut, &Shortcut::name), threshold));
  }
  const std::vector<properties::diagnosis::Diagnosis> found =
      properties::diagnosis::diagnose_all(properties::run_gate(subjects, options));
  for (std::size_t i = 0; i < expected.size(); ++i) {
    ASSERT_FALSE(found[i].faults.empty()) << expected[i].shortcut;
    const std::string& where = found[i].faults[0].where;
    const std::string said = "it nearly holds, within ";
    const std::size_t place = where.find(said);
    ASSERT_NE(place, std::string::npos) << expected[i].shortcut << ": " << where;
    EXPECT_NE(where.find(", that " + std::string(expected[i].special), place), std::string::npos) << where;
    const double distance = std::stod(where.substr(place + said.size()));
    EXPECT_LE(distance, 1.01 * threshold) << where;
    EXPECT_GE(distance, threshold / 10) << where;
  }
  EXPECT_EQ(found[0].faults[0].look_at.find("a tolerance within which"), 0U) << found[0].faults[0].look_at;
}

}  // namespace
}  // namespace carom::mutants
