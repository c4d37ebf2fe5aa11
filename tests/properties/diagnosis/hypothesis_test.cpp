// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include <carom/collision/validate.hpp>
#include <carom/properties/cases/family.hpp>
#include <carom/properties/diagnosis/fits.hpp>

namespace carom::properties::diagnosis {
namespace {

std::vector<KnownCase> right_answers(Law law) {
  std::vector<KnownCase> cases;
  for (const Family& family : all_families()) {
    for (std::uint64_t number = 0; number < 6; ++number) {
      const Collision collision = drawn_case(family, 1, number).collision;
      auto known = validate(collision).empty() ? known_case(collision, unchanged(collision), law) : std::nullopt;
      if (known) {
        known->answered = known->truth;
        cases.push_back(*known);
      }
    }
  }
  return cases;
}

const Fit& fit_named(const std::string& as_if) {
  const auto found = std::ranges::find(all_fits(), as_if, &Fit::as_if);
  EXPECT_NE(found, all_fits().end()) << as_if;
  return *found;
}

TEST(Hypotheses, HaveWordsOfTheirOwn) {
  std::set<std::string> words;
  for (const Hypothesis& hypothesis : all_hypotheses()) {
    EXPECT_TRUE(words.insert(hypothesis.as_if).second) << hypothesis.as_if;
    EXPECT_FALSE(hypothesis.look_at.empty()) << hypothesis.as_if;
  }
}

/// A hypothesis, such as "as if ε were 0", predicts a wrong answer. In some case this answer is visibly wrong, and the
/// hypothesis explains it.
TEST(Hypotheses, ExplainWhatTheyAnswerThemselves) {
  std::set<std::string> seen;
  for (const Law law : all_laws) {
    for (KnownCase one : right_answers(law)) {
      for (const Hypothesis& hypothesis : all_hypotheses()) {
        const auto answer = answer_of(hypothesis, one);
        if (!answer) {
          continue;
        }
        KnownCase wrong = one;
        wrong.answered = *answer;
        if (is_visibly_off(wrong, 0x1p-53)) {
          seen.insert(hypothesis.as_if);
          EXPECT_TRUE(explains(hypothesis, wrong)) << hypothesis.as_if;
        }
      }
    }
  }
  for (const Hypothesis& hypothesis : all_hypotheses()) {
    EXPECT_TRUE(seen.contains(hypothesis.as_if)) << hypothesis.as_if << " is never wrong";
  }
}

/// A solver with two faults makes both mistakes in one collision.
TEST(Hypotheses, ExplainAnAnswerWithTwoMistakesOnlyTogether) {
  const auto named = [](const std::string& as_if) {
    const auto found = std::ranges::find(all_hypotheses(), as_if, &Hypothesis::as_if);
    EXPECT_NE(found, all_hypotheses().end()) << as_if;
    return &*found;
  };
  const Hypothesis* const inelastic = named("ε were 0");
  const Hypothesis* const reversed = named("B's spin were changed in the wrong direction");
  int explained = 0;
  for (KnownCase one : right_answers(Law::reflection)) {
    Steps steps = right_steps(one);
    ASSERT_TRUE(inelastic->mistakes[0](steps, one) && reversed->mistakes[0](steps, one));
    const Outcome<double> with_both = outcome_by(steps, impulses_by(steps, one).value(), one);
    one.answered = with_both;
    if (is_visibly_off(one, 0x1p-53) && !explains(*inelastic, one) && !explains(*reversed, one)) {
      EXPECT_TRUE(explains(std::array{inelastic, reversed}, one));
      ++explained;
    }
  }
  EXPECT_GT(explained, 50);
}

/// The law has no answer for ε > 1, but the answers for ε = 0 and ε = 1 determine it.
TEST(Hypotheses, FitTheNumberThatIsAddedToTheRestitution) {
  int fitted_cases = 0;
  for (KnownCase one : right_answers(Law::sticking)) {
    const auto with_restitution = [&](double restitution) {
      Steps steps = right_steps(one);
      steps.computed_from.restitution = restitution;
      steps.has_right_impulse = false;
      return impulses_by(steps, one).value().on_a;
    };
    const Vector3<double> at_0 = with_restitution(0);
    const Vector3<double> impulse = at_0 + (one.collision.restitution + 0.25) * (with_restitution(1) - at_0);
    one.answered = outcome_by(right_steps(one), {impulse, -impulse}, one);
    if (is_visibly_off(one, 0x1p-53)) {
      const std::vector<double> added = fitted(fit_named("{} were added to ε"), right_steps(one), one);
      ASSERT_EQ(added.size(), 1U);
      EXPECT_NEAR(added[0], 0.25, 0x1p-10);
      ++fitted_cases;
    }
  }
  EXPECT_GT(fitted_cases, 50);
}

/// Friction on spheres stops 2/7 of the slip over λ. A solver with 2/5 stops 7/5 of the slip.
void expect_share_of_slip(FrictionLimit limit, const std::string& as_if) {
  constexpr double share = 1.4;
  int fitted_cases = 0;
  for (KnownCase one : right_answers(Law::coulomb)) {
    Steps steps = right_steps(one);
    steps.friction.stopped = share;
    steps.friction.limit = limit;
    steps.has_right_impulse = false;
    const std::optional<Impulses> impulses = impulses_by(steps, one);
    steps.friction.stopped = 0;
    const std::optional<Impulses> without = impulses_by(steps, one);
    if (one.approach != oracles::ContactState::colliding || !impulses || !without || one.collision.friction == 0) {
      continue;
    }
    // A contact whose slip is rounding shows no share of it.
    if ((impulses->on_a - without->on_a).norm() < 0x1p-10 * impulses->on_a.norm()) {
      continue;
    }
    one.answered = outcome_by(right_steps(one), *impulses, one);
    if (is_visibly_off(one, 0x1p-53)) {
      const std::vector<double> stopped = fitted(fit_named(as_if), right_steps(one), one);
      if (stopped.empty() && limit == FrictionLimit::cone) {
        continue;  // the limit hides the share
      }
      ASSERT_EQ(stopped.size(), 1U);
      EXPECT_NEAR(stopped[0], share, 0x1p-10);
      ++fitted_cases;
    }
  }
  EXPECT_GT(fitted_cases, 20);
}

TEST(Hypotheses, FitTheShareOfTheSlipThatFrictionStops) {
  expect_share_of_slip(FrictionLimit::cone, "friction stopped {} of the slip that it should");
  expect_share_of_slip(FrictionLimit::none, "friction stopped {} of the slip, whatever its limit");
}

/// The search for a factor ends at any number that leaves only rounding of its part.
TEST(Hypotheses, FitAFactorOfZeroAsZero) {
  int fitted_cases = 0;
  const Fit& factor = fit_named("the tangential part of the impulse were multiplied by {}");
  for (KnownCase one : right_answers(Law::sticking)) {
    Steps steps = right_steps(one);
    steps.effort = Effort::without_rationals;
    const std::optional<Outcome<double>> without = factor.change(steps, one, 0) ? outcome_of(steps, one) : std::nullopt;
    one.answered = without.value_or(one.truth);
    if (is_visibly_off(one, 0x1p-53)) {
      for (const double number : fitted(factor, right_steps(one), one)) {
        EXPECT_EQ(number, 0);
        ++fitted_cases;
      }
    }
  }
  EXPECT_GT(fitted_cases, 20);
}

/// A solver that diverges has such steps. The exact numbers know no infinity.
TEST(Hypotheses, HaveNoAnswerIfTheFirstOfTwoImpulsesOverflows) {
  int without_answer = 0;
  for (const KnownCase& one : right_answers(Law::frictionless)) {
    Steps steps = right_steps(one);
    steps.is_solved_twice = true;
    steps.has_right_impulse = false;
    steps.computed_from.restitution = 1e308;
    steps.computed_from.a.velocity *= 1e10;
    without_answer += impulses_by(steps, one) ? 0 : 1;
  }
  EXPECT_GT(without_answer, 5);
}

TEST(Hypotheses, FitNoNumberThatChangesNothing) {
  for (const Law law : all_laws) {
    for (const KnownCase& one : right_answers(law)) {
      for (const Fit& fit : all_fits()) {
        if (fit.shown == nullptr && std::isfinite(fit.nothing)) {
          for (const double number : fitted(fit, right_steps(one), one)) {
            EXPECT_GT(std::abs(number - fit.nothing), 0x1p-40) << fit.as_if;
          }
        }
      }
    }
  }
}

TEST(Hypotheses, NothingIsVisiblyOffInARightAnswer) {
  for (const Law law : all_laws) {
    for (const KnownCase& one : right_answers(law)) {
      EXPECT_FALSE(is_visibly_off(one, 0x1p-53));
    }
  }
}

}  // namespace
}  // namespace carom::properties::diagnosis
