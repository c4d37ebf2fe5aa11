// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

#include <carom/properties/gate/answers.hpp>
#include <carom/properties/plan/plan.hpp>
#include <carom/subjects/catalogue.hpp>

#include "io/threads.hpp"
#include "support/cases.hpp"
#include "support/changed_subject.hpp"

namespace carom::properties::plan {
namespace {

Candidate candidate(const std::string& name, int scalar_rank, int solve_rank = 0, bool is_batch = false) {
  Candidate result;
  result.subject = *subjects::subject_named(name);
  result.scalar = std::to_string(scalar_rank);
  result.scalar_rank = scalar_rank;
  result.solve = std::to_string(solve_rank);
  result.solve_rank = solve_rank;
  result.is_batch = is_batch;
  return result;
}

std::vector<Candidate> some_candidates() {
  return {candidate("reflection-llt-double", 1, 1),
          candidate("reflection-double", 1),
          candidate("reflection-long-double", 2),
          candidate("reflection-float", 0),
          candidate("frictionless-long-double", 2),
          candidate("frictionless-double", 1),
          candidate("frictionless-float", 0),
          candidate("frictionless-batch-double", 1, 0, true),
          candidate("reflection-batch-double", 1, 0, true),
          candidate("rough-double", 1)};
}

std::vector<ClassedCollision> contacts_of(std::string_view family, std::size_t count) {
  std::vector<ClassedCollision> contacts;
  for (std::size_t i = 0; i < count; ++i) {
    contacts.push_back({"", unit::case_of(family, i).collision, std::string(family) + ':' + std::to_string(i + 1)});
  }
  return contacts;
}

PlanOptions options_for(Law law, std::optional<int> digits = std::nullopt) {
  PlanOptions options;
  options.demand.law = law;
  options.demand.digits = digits;
  options.workers = tool::threads(2);
  return options;
}

std::string chosen(const Plan& plan, const Part& part, const std::optional<std::size_t>& choice) {
  return choice ? plan.candidates[part.candidates[*choice].candidate].subject.name : "nothing";
}
std::string chosen(const Plan& plan) { return chosen(plan, plan.whole, plan.whole.one_at_a_time); }

const JudgedCandidate& judged(const Plan& plan, const Part& part, const std::string& name) {
  return *std::ranges::find_if(
      part.candidates, [&](const JudgedCandidate& one) { return plan.candidates[one.candidate].subject.name == name; });
}

TEST(Plan, TakesTheScalarSolverForReflectedSpheres) {
  const Plan plan = make_plan(contacts_of("collinear_spheres", 100), some_candidates(), options_for(Law::reflection));
  EXPECT_EQ(chosen(plan), "frictionless-double");
  EXPECT_EQ(chosen(plan, plan.whole, plan.whole.in_batches), "frictionless-batch-double");
  EXPECT_EQ(plan.whole.count_of(Law::frictionless).exactly(), 100U);
  EXPECT_EQ(plan.whole.count_of(Law::frictionless).served, 100U);
  EXPECT_EQ(plan.candidates.size(), 9U) << "what is no lesser law is not judged";
  EXPECT_TRUE(plan.serves());
}

TEST(Plan, TakesTheLawItselfForGeneralBodies) {
  const Plan plan = make_plan(contacts_of("generic", 40), some_candidates(), options_for(Law::reflection));
  EXPECT_EQ(chosen(plan), "reflection-double");
  EXPECT_FALSE(judged(plan, plan.whole, "frictionless-double").serves);
  EXPECT_EQ(judged(plan, plan.whole, "reflection-float").certificate.failures, 40U) << "32 ulps are of binary64";
}

TEST(Plan, NamesClassesByGeometryUnlessTheyHaveAName) {
  std::vector<ClassedCollision> contacts = contacts_of("generic", 10);
  for (ClassedCollision& contact : contacts) {
    contact.contact_class = "crates";
  }
  std::ranges::move(contacts_of("collinear_spheres", 10), std::back_inserter(contacts));
  const Plan plan = make_plan(contacts, some_candidates(), options_for(Law::reflection));
  ASSERT_GE(plan.classes.size(), 2U);
  EXPECT_EQ(plan.classes[0].name, "crates");
  EXPECT_EQ(plan.classes[0].contacts.size(), 10U);
  EXPECT_EQ(chosen(plan, plan.classes[0], plan.classes[0].one_at_a_time), "reflection-double");
  EXPECT_EQ(plan.classes[1].name.substr(0, 8), "central,");
  EXPECT_EQ(chosen(plan, plan.classes[1], plan.classes[1].one_at_a_time), "frictionless-double");
  EXPECT_EQ(chosen(plan), "reflection-double");
  EXPECT_EQ(plan.whole.contacts.size(), 20U);
}

/// A plan rejects a candidate with a relative error of 10⁻¹⁰ on one of a hundred contacts, unless the plan demands only
/// nine digits.
TEST(Plan, RejectsACandidateThatIsWrongOnOneContact) {
  std::vector<Candidate> candidates = some_candidates();
  Candidate wrong = candidate("frictionless-float", 0);
  wrong.subject.name = "planted";
  const Subject right = *subjects::subject_named("frictionless-double");
  const std::vector<ClassedCollision> contacts = contacts_of("collinear_spheres", 100);
  const double mass = contacts[70].collision.a.mass;
  const Vector3<double> place = contacts[70].collision.a.position;
  wrong.subject.open = unit::with_outcomes(right, [mass, place](const Collision& collision, ReportedOutcome& outcome) {
                         const bool is_planted = collision.a.mass == mass && collision.a.position == place;
                         outcome.a.velocity *= is_planted ? 1 + 1e-10L : 1;
                       }).open;
  candidates.push_back(wrong);
  const Plan plan = make_plan(contacts, candidates, options_for(Law::reflection));
  const JudgedCandidate& planted = judged(plan, plan.whole, "planted");
  EXPECT_FALSE(planted.serves);
  EXPECT_EQ(planted.certificate.failures, 1U);
  ASSERT_TRUE(planted.certificate.worst.has_value());
  EXPECT_EQ(plan.places[planted.certificate.worst->contact], "collinear_spheres:71");
  EXPECT_EQ(planted.certificate.worst->result.failure, "backward error");
  EXPECT_GT(*planted.certificate.worst_backward_error, 1e4);
  EXPECT_EQ(chosen(plan), "frictionless-double");
  const Plan of_nine = make_plan(contacts, candidates, options_for(Law::reflection, 9));
  EXPECT_EQ(judged(of_nine, of_nine.whole, "planted").certificate.failures, 0U);
}

TEST(Plan, RejectsACandidateThatRefuses) {
  std::vector<Candidate> candidates = some_candidates();
  Candidate mute = candidate("frictionless-float", 0);
  mute.subject.name = "mute";
  mute.subject = unit::with_answers(mute.subject, [](const auto&, std::vector<Answer>& answers) {
    std::ranges::fill(answers, Answer(Refused{"no"}));
  });
  candidates.push_back(mute);
  const Plan plan = make_plan(contacts_of("collinear_spheres", 5), candidates, options_for(Law::reflection));
  EXPECT_EQ(judged(plan, plan.whole, "mute").certificate.failures, 5U);
}

ClassedCollision crate_at(double x) {
  Collision c;
  c.a.principal_inertia = {0.25, 0.25, 0.1875};
  c.a.position = {x + 0.3, 0.5, 0.4};
  c.point = {x, 0, 0};
  c.a.velocity = {0.7, -1.3, 0.2};
  c.b.immovable = true;
  c.restitution = 0.5;
  return {"crates", c, "crate at " + std::to_string(x)};
}

TEST(Plan, RefusesFloatForOneContactFarFromTheOrigin) {
  std::vector<ClassedCollision> contacts;
  for (int i = 0; i < 20; ++i) {
    contacts.push_back(crate_at(i / 8.0));
  }
  EXPECT_EQ(chosen(make_plan(contacts, some_candidates(), options_for(Law::reflection, 5))), "reflection-float");
  contacts.push_back(crate_at(1e6));
  const Plan plan = make_plan(contacts, some_candidates(), options_for(Law::reflection, 5));
  EXPECT_EQ(chosen(plan), "reflection-double");
  const Certificate& certificate = judged(plan, plan.whole, "reflection-float").certificate;
  EXPECT_EQ(certificate.failures, 1U);
  EXPECT_EQ(plan.places[certificate.worst->contact], contacts.back().place);
  EXPECT_LT(*certificate.least_digits, 5);
}

/// If a contact does not collide, the velocities must stay unchanged to the demanded digits.
TEST(Plan, AsksForNoDigitsOfAChangeIfNothingCollides) {
  ClassedCollision parting = crate_at(0.25);
  parting.collision.a.velocity = {0.7, 1.3, 0.2};
  const Plan plan = make_plan(std::vector{parting}, some_candidates(), options_for(Law::reflection, 6));
  EXPECT_EQ(chosen(plan), "frictionless-float");
  EXPECT_EQ(plan.whole.colliding, 0U);
  EXPECT_FALSE(judged(plan, plan.whole, "frictionless-float").certificate.least_digits.has_value());
}

TEST(Plan, ServesNothingIfNoCandidateHasTheDigits) {
  const std::vector<ClassedCollision> contacts{crate_at(0.1)};
  const Plan plan = make_plan(contacts, some_candidates(), options_for(Law::reflection, 18));
  EXPECT_EQ(chosen(plan), "reflection-long-double");
  std::vector<Candidate> lesser = some_candidates();
  std::erase_if(lesser, [](const Candidate& one) { return one.scalar_rank > 1; });
  const Plan of_less = make_plan(contacts, lesser, options_for(Law::reflection, 18));
  EXPECT_EQ(chosen(of_less), "nothing");
  EXPECT_FALSE(of_less.serves());
}

/// Recorded positions are rounded, so r × N is not exactly zero. So the answers of `frictionless` and `reflection`
/// differ, by less than the demanded accuracy.
TEST(Plan, WithExactLawTakesALesserLawOnlyIfItIsExactlyTheSame) {
  Collision ball = unit::ball_on_a_plane(0.4, 0);
  ball.normal = {1.0 / 3, 2.0 / 3, 2.0 / 3};
  ball.point = {0.1, -7.3, 0.9};
  ball.a.position = ball.point + 0.7 * ball.normal;
  const std::vector<ClassedCollision> contacts{{"", ball, "ball"}};
  PlanOptions options = options_for(Law::reflection);
  const Plan within = make_plan(contacts, some_candidates(), options);
  EXPECT_EQ(chosen(within), "frictionless-double");
  EXPECT_EQ(within.whole.count_of(Law::frictionless).exactly(), 0U);
  options.demand.exact_law = true;
  EXPECT_EQ(chosen(make_plan(contacts, some_candidates(), options)), "reflection-double");
  EXPECT_EQ(chosen(make_plan(contacts_of("collinear_spheres", 5), some_candidates(), options)), "frictionless-double");
}

TEST(Plan, ForTheLawCoulombJudgesByItsEquations) {
  std::vector<Candidate> candidates{candidate("coulomb-double", 1), candidate("sticking-double", 1),
                                    candidate("rough-double", 1), candidate("frictionless-double", 1)};
  std::vector<ClassedCollision> contacts;
  for (const double friction : {0.1, 5.0}) {  // slides, sticks
    contacts.push_back({friction < 1 ? "slides" : "sticks", unit::ball_on_a_plane(0.5, friction), "ball"});
  }
  for (const std::optional<int> digits : {std::optional<int>(), std::optional<int>(12)}) {
    const Plan plan = make_plan(contacts, candidates, options_for(Law::coulomb, digits));
    EXPECT_EQ(chosen(plan, plan.classes[0], plan.classes[0].one_at_a_time), "rough-double");
    EXPECT_EQ(chosen(plan, plan.classes[1], plan.classes[1].one_at_a_time), "sticking-double");
    EXPECT_EQ(chosen(plan), "rough-double");
    EXPECT_FALSE(judged(plan, plan.whole, "frictionless-double").serves);
  }
}

/// The plan chooses the faster candidate. If the times hardly differ, `is_less` decides.
TEST(Plan, ChoosesTheFasterCandidateUnlessTheTimesHardlyDiffer) {
  PlanOptions options = options_for(Law::reflection);
  const auto with_times = [&](double of_reflection, double of_llt) {
    options.clock = [=](std::span<const Timing> timings) {
      std::vector<double> times;
      for (const Timing& timing : timings) {
        EXPECT_LE(timing.collisions.size(), contacts_timed);
        times.push_back(timing.candidate->subject.name == "reflection-double"       ? of_reflection
                        : timing.candidate->subject.name == "reflection-llt-double" ? of_llt
                                                                                    : 1000);
      }
      return times;
    };
    return make_plan(contacts_of("generic", 70), some_candidates(), options);
  };
  const Plan slower = with_times(200, 100);
  EXPECT_EQ(chosen(slower), "reflection-llt-double");
  EXPECT_DOUBLE_EQ(slower.whole.saving_of(slower.whole.candidates[*slower.whole.one_at_a_time]), 2);
  EXPECT_EQ(slower.whole.timed_contacts, contacts_timed);
  EXPECT_DOUBLE_EQ(*slower.saving_by_class(false), 2);
  EXPECT_EQ(chosen(with_times(105, 100)), "reflection-double");
  EXPECT_FALSE(judged(slower, slower.whole, "reflection-long-double").nanoseconds) << "less serves as well";
}

TEST(Plan, IsTheSameWithAnyNumberOfThreads) {
  PlanOptions options = options_for(Law::reflection, 6);
  const auto contacts = contacts_of("generic", 150);
  const Plan by_two = make_plan(contacts, some_candidates(), options);
  options.workers = {};
  const Plan by_one = make_plan(contacts, some_candidates(), options);
  for (std::size_t c = 0; c < by_one.candidates.size(); ++c) {
    const Certificate& x = by_one.whole.candidates[c].certificate;
    const Certificate& y = by_two.whole.candidates[c].certificate;
    EXPECT_EQ(x.failures, y.failures);
    EXPECT_EQ(x.worst_backward_error, y.worst_backward_error);
    EXPECT_EQ(x.worst ? x.worst->contact : 0, y.worst ? y.worst->contact : 0);
  }
}

TEST(Plan, OfContactsOfEveryFamilyHasConsistentCertificates) {
  std::vector<ClassedCollision> contacts;
  for (const auto& [family, one] : unit::valid_cases(3)) {
    contacts.push_back({std::string(family), one.collision, std::string(family)});
  }
  std::vector<Candidate> candidates;
  for (const Law law : all_laws) {
    if (law != Law::any) {
      candidates.push_back(candidate(std::string(name_of(law)) + "-float", 0));
      candidates.push_back(candidate(std::string(name_of(law)) + "-double", 1));
    }
  }
  for (const Law law : all_laws) {
    if (law == Law::any) {
      continue;
    }
    for (const std::optional<int> digits : {std::optional<int>(), std::optional<int>(3)}) {
      const Plan plan = make_plan(contacts, candidates, options_for(law, digits));
      for (const JudgedCandidate& one : plan.whole.candidates) {
        EXPECT_EQ(one.certificate.contacts, contacts.size());
        EXPECT_EQ(one.certificate.worst.has_value(), one.certificate.failures > 0);
        EXPECT_GE(plan.whole.count_of(plan.candidates[one.candidate].subject.law).served,
                  contacts.size() - one.certificate.failures);
      }
      const JudgedCandidate& own = judged(plan, plan.whole, std::string(name_of(law)) + "-double");
      EXPECT_LT(4 * own.certificate.failures, contacts.size()) << name_of(law);
    }
  }
}

TEST(Plan, LeavesOutContactsWhoseCoefficientsAreOutOfRange) {
  std::vector<ClassedCollision> contacts{crate_at(0), crate_at(1)};
  contacts[1].collision.restitution = 2;
  const Plan plan = make_plan(contacts, some_candidates(), options_for(Law::reflection));
  EXPECT_EQ(plan.left_out, 1U);
  EXPECT_EQ(plan.whole.contacts.size(), 1U);
  EXPECT_TRUE(std::ranges::any_of(plan.findings, [&](const LintFinding& finding) {
    return finding.lint == Lint::coefficient && finding.place == contacts[1].place;
  }));
  contacts.erase(contacts.begin());
  EXPECT_FALSE(make_plan(contacts, some_candidates(), options_for(Law::reflection)).serves());
}

TEST(Plan, RefusesNoContactTheLawAnyAMissingBaselineAndAnInvalidCollision) {
  const auto make = [](const std::vector<ClassedCollision>& contacts, Law law, std::vector<Candidate> candidates) {
    return make_plan(contacts, candidates, options_for(law));
  };
  EXPECT_THROW((void)make({}, Law::reflection, some_candidates()), std::invalid_argument);
  EXPECT_THROW((void)make({crate_at(0)}, Law::any, some_candidates()), std::invalid_argument);
  EXPECT_THROW((void)make({crate_at(0)}, Law::sticking, some_candidates()), std::invalid_argument);
  ClassedCollision massless = crate_at(0);
  massless.collision.a.mass = 0;
  EXPECT_THROW((void)make({massless}, Law::reflection, some_candidates()), std::invalid_argument);
}

}  // namespace
}  // namespace carom::properties::plan
