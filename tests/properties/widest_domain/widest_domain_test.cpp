// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/properties/cases/draw_within.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/properties/widest_domain/widest_domain.hpp>
#include <carom/subjects/catalogue.hpp>

#include "io/threads.hpp"
#include "support/cases.hpp"
#include "support/changed_subject.hpp"

namespace carom::properties {
namespace {

/// A limit of a subject: it refuses collisions in which the quantity lies beyond `end`.
struct Planted {
  LimitedQuantity quantity;
  bool is_upper;
  double end;
};

bool is_beyond(const Planted& planted, const Collision& collision) {
  const std::vector<double> values = values_of(collision, planted.quantity);
  return std::any_of(values.begin(), values.end(),
                     [&](double x) { return planted.is_upper ? x > planted.end : x < planted.end; });
}

Subject limited(const std::vector<Planted>& limits) {
  return unit::with_answers(unit::subject_of("frictionless-double"), [limits](std::span<const Collision> collisions,
                                                                              std::vector<Answer>& answers) {
    for (std::size_t i = 0; i < collisions.size(); ++i) {
      if (std::ranges::any_of(limits, [&](const Planted& one) { return is_beyond(one, collisions[i]); })) {
        answers[i] = Refused{"beyond a limit"};
      }
    }
  });
}

/// A tenth of the default numbers of cases.
WidestDomainOptions options() {
  WidestDomainOptions options;
  options.core = default_core();
  options.cases_of_slab = 1;
  options.cases_of_box = 20;
  return options;
}

const Face& face_of(const WidestDomain& widest, const Planted& planted) {
  return *std::find_if(widest.ends.faces.begin(), widest.ends.faces.end(), [&](const Face& face) {
    return face.quantity == planted.quantity && face.is_upper == planted.is_upper;
  });
}

/// An end that is off by at most a tenth, or by 0.03 for a coefficient.
void expect_near(const Face& face, const Planted& planted) {
  const bool is_coefficient =
      planted.quantity == LimitedQuantity::restitution || planted.quantity == LimitedQuantity::tangential_restitution;
  EXPECT_NEAR(face.end, planted.end, is_coefficient ? 0.03 : planted.end / 10)
      << name_of(planted.quantity) << ' ' << planted.is_upper;
}

const std::vector<Planted>& planted_limits() {
  static const std::vector<Planted> all{{LimitedQuantity::size, true, 30},
                                        {LimitedQuantity::size, false, 0.02},
                                        {LimitedQuantity::mass, true, 5e3},
                                        {LimitedQuantity::mass, false, 3e-5},
                                        {LimitedQuantity::mass_ratio, true, 40},
                                        {LimitedQuantity::moment_ratio, true, 300},
                                        {LimitedQuantity::size_ratio, true, 7},
                                        {LimitedQuantity::speed, true, 500},
                                        {LimitedQuantity::speed, false, 0.3},
                                        {LimitedQuantity::approach, false, 0.5},
                                        {LimitedQuantity::approach, true, 90},
                                        {LimitedQuantity::spin, true, 50},
                                        {LimitedQuantity::distance, true, 1e3},
                                        {LimitedQuantity::restitution, true, 0.9},
                                        {LimitedQuantity::restitution, false, 0.1},
                                        {LimitedQuantity::friction, true, 3},
                                        {LimitedQuantity::tangential_restitution, true, 0.8}};
  return all;
}

/// The gate poses neither a case nor a related collision outside of the domain.
TEST(WidestDomain, IsSoundInTheDomainIfASubjectRefusesAllElse) {
  for (const Planted& planted : planted_limits()) {
    GateOptions gate;
    gate.cases = 20;
    gate.within = default_core();
    gate.is_part = true;  // no case within this domain judges `unit_scaling`
    Range& range = gate.within.ranges[planted.quantity];
    (planted.is_upper ? range.most : range.least) = planted.end;
    for (const Family& family : all_families()) {
      if (has_cases_within(gate.within, family, gate.seed)) {
        gate.families.push_back(&family);
      }
    }
    const SubjectResult result = run_gate({limited({planted})}, gate).results.at(0);
    EXPECT_TRUE(result.is_sound()) << name_of(planted.quantity) << ' ' << result.error << ' ' << result.not_judged
                                   << ' ' << (result.witnesses.empty() ? "" : result.witnesses[0].invariant->name);
  }
}

TEST(WidestDomain, FindsPlantedLimitsToATenth) {
  const auto tried = static_cast<std::size_t>(unit::effort(static_cast<int>(planted_limits().size())));
  for (std::size_t i = 0; i < tried; ++i) {
    const Planted& planted = planted_limits()[i * planted_limits().size() / tried];
    const WidestDomain widest = measured_widest_domain(limited({planted}), options());
    ASSERT_FALSE(widest.ends.in_core) << name_of(planted.quantity);
    const Face& face = face_of(widest, planted);
    expect_near(face, planted);
    ASSERT_TRUE(face.beyond) << name_of(planted.quantity);
    // A related collision may be beyond the limit, and the witness itself just within.
    const Planted nearly{planted.quantity, planted.is_upper, planted.end * (planted.is_upper ? 0.9 : 1.1)};
    EXPECT_TRUE(is_beyond(nearly, face.beyond->shrunk.collision)) << name_of(planted.quantity);
    EXPECT_GE(widest.cases, 1'000U);
    EXPECT_LE(widest.domain.ranges[planted.quantity].least, widest.domain.ranges[planted.quantity].most);
  }
}

TEST(WidestDomain, FindsTwoLimitsAtOnce) {
  const Planted speed{LimitedQuantity::speed, true, 500};
  const Planted mass_ratio{LimitedQuantity::mass_ratio, true, 40};
  const WidestDomain widest = measured_widest_domain(limited({speed, mass_ratio}), options());
  expect_near(face_of(widest, speed), speed);
  expect_near(face_of(widest, mass_ratio), mass_ratio);
}

TEST(WidestDomain, EndsWhereTheSearchEndsForASoundSubject) {
  const WidestDomain widest = measured_widest_domain(unit::subject_of("frictionless-double"), options());
  for (const Face& face : widest.ends.faces) {
    EXPECT_FALSE(face.beyond) << name_of(face.quantity);
  }
  EXPECT_EQ(widest.share, 1);
  EXPECT_GE(widest.cases, 1'000U);
}

/// A subject that skips every collision shows nothing, so no domain is measured.
TEST(WidestDomain, IsUnknownIfNothingIsJudged) {
  const Subject skipping = unit::with_answers(limited({}), [](const auto&, std::vector<Answer>& answers) {
    std::ranges::fill(answers, Answer(Skipped{"always"}));
  });
  const WidestDomain widest = measured_widest_domain(skipping, options());
  EXPECT_FALSE(widest.ends.error.empty());
  EXPECT_TRUE(widest.ends.faces.empty());
}

TEST(WidestDomain, StartsFromACoreOfZerosAndFromOneBeyondTheSearch) {
  WidestDomainOptions of_zeros = options();
  of_zeros.core.ranges[LimitedQuantity::friction] = {0, 0};
  of_zeros.core.ranges[LimitedQuantity::spin] = {0, 0};
  const WidestDomain from_zero = measured_widest_domain(unit::subject_of("frictionless-double"), of_zeros);
  EXPECT_EQ(from_zero.domain.ranges[LimitedQuantity::friction], (Range{0, 1e9}));
  WidestDomainOptions beyond = options();
  beyond.core.ranges[LimitedQuantity::speed] = {1e10, 1e11};
  beyond.core.ranges[LimitedQuantity::approach] = {1e9, 1e12};
  const WidestDomain from_beyond = measured_widest_domain(unit::subject_of("frictionless-double"), beyond);
  EXPECT_EQ(from_beyond.domain.ranges[LimitedQuantity::speed].most, 1e11);
  EXPECT_EQ(from_beyond.domain.ranges[LimitedQuantity::approach].most, 1e12);
}

/// J⁻¹ in world axes loses digits of slender bodies before it loses all but three.
TEST(WidestDomain, SearchesTheEndsWithAStricterYardstickToo) {
  WidestDomainOptions both = options();
  both.stricter = both.limits;
  both.limits.digits = 3;
  const Subject subject = unit::subject_of("reflection-world-float");
  const WidestDomain widest = measured_widest_domain(subject, both);
  const WidestDomain strict = measured_widest_domain(subject, options());
  ASSERT_TRUE(widest.stricter);
  const auto moments = [&](const Ends& ends) { return range_of(ends, both.core, LimitedQuantity::moment_ratio).most; };
  EXPECT_EQ(moments(*widest.stricter), moments(strict.ends));
  EXPECT_LT(moments(*widest.stricter), moments(widest.ends));
  EXPECT_FALSE(strict.stricter);
}

TEST(WidestDomain, StopsIfAskedTo) {
  std::stop_source source;
  source.request_stop();
  WidestDomainOptions stopped = options();
  stopped.stop = source.get_token();
  EXPECT_EQ(measured_widest_domain(unit::subject_of("frictionless-double"), stopped).ends.error, "interrupted");
}

TEST(WidestDomain, ShowsAViolationInTheCore) {
  const WidestDomain widest = measured_widest_domain(limited({{LimitedQuantity::mass, true, 1}}), options());
  ASSERT_TRUE(widest.ends.in_core);
  EXPECT_TRUE(contains(options().core, widest.ends.in_core->shrunk.collision));
  EXPECT_TRUE(widest.ends.faces.empty());
}

TEST(WidestDomain, DependsOnTheSeedAlone) {
  const Subject subject = limited({{LimitedQuantity::speed, true, 500}});
  const WidestDomain first = measured_widest_domain(subject, options());
  WidestDomainOptions parallel = options();
  parallel.workers = tool::threads(3);
  const WidestDomain again = measured_widest_domain(subject, parallel);
  EXPECT_EQ(to_text(first.domain), to_text(again.domain));
  for (std::size_t i = 0; i < first.ends.faces.size(); ++i) {
    EXPECT_EQ(first.ends.faces[i].end, again.ends.faces[i].end);
  }
}

/// A program that takes long to start is started a few times: in the core, in the domain, and when it fails. The steps
/// of the search use two sessions in turn.
TEST(WidestDomain, KeepsTheSessionsOfAProgram) {
  const Subject built_in = limited({{LimitedQuantity::mass, true, 5e3}});
  Subject program = built_in;
  program.specification = "exec:a-program";
  std::size_t starts = 0;
  program.open = [&starts, open = program.open] {
    ++starts;
    return open();
  };
  const WidestDomain of_program = measured_widest_domain(program, options());
  EXPECT_EQ(to_text(of_program.domain), to_text(measured_widest_domain(built_in, options()).domain));
  EXPECT_LE(starts, 12U);
}

TEST(KeptSessions, TakeTurnsAndLeaveOutFailedOnes) {
  Subject subject = unit::subject_of("frictionless-double");
  int opened = 0;
  subject.open = [&opened] {
    const int number = opened++;
    return Session([number](std::span<const Collision> collisions) -> std::vector<Answer> {
      if (collisions.empty()) {
        throw SessionFailure("it ended", {}, {"it ended"});
      }
      return {Skipped{std::to_string(number)}};
    });
  };
  const KeptSessions kept(subject);
  const Collision collision;
  const auto answered_by = [&](Session& session) {
    return std::get<Skipped>(session(std::span(&collision, 1)).front()).why;
  };
  for (const char* number : {"0", "1", "0", "1"}) {
    Session session = kept.subject().open();
    EXPECT_EQ(answered_by(session), number);
    session.close();
  }
  Session fails = kept.subject().open();
  EXPECT_THROW((void)fails({}), SessionFailure);
  fails.close();
  Session next = kept.subject().open();
  EXPECT_EQ(answered_by(next), "2");
}

}  // namespace
}  // namespace carom::properties
