// SPDX-License-Identifier: BSL-1.0
#include <set>
#include <string>

#include <gtest/gtest.h>

#include <carom/collision/validate.hpp>
#include <carom/properties/cases/family.hpp>
#include <carom/properties/diagnosis/explanation.hpp>

namespace carom::properties::diagnosis {
namespace {

const Hypothesis& named(const std::string& as_if) {
  for (const Hypothesis& hypothesis : all_hypotheses()) {
    if (hypothesis.as_if == as_if) {
      return hypothesis;
    }
  }
  throw std::invalid_argument("there is no hypothesis " + as_if);
}

/// The visibly wrong answers of a solver for the law `reflection`. `fault` changes the steps of each case.
template <class Fault>
std::vector<KnownCase> answers_of(const Fault& fault) {
  std::vector<KnownCase> wrong;
  for (const Family& family : all_families()) {
    for (std::uint64_t number = 0; number < 12; ++number) {
      const Collision collision = drawn_case(family, 1, number).collision;
      if (!validate(collision).empty()) {
        continue;
      }
      KnownCase one = known_case(collision, unchanged(collision), Law::reflection).value();
      Steps steps = right_steps(one);
      fault(steps, one);
      one.answered = outcome_by(steps, impulses_by(steps, one).value(), one);
      if (is_visibly_off(one, 0x1p-53)) {
        wrong.push_back(one);
      }
    }
  }
  return wrong;
}

std::set<std::string> words_of(const Explanation& explanation) {
  std::set<std::string> words;
  for (const Hypothesis& hypothesis : explanation.found) {
    words.insert(hypothesis.as_if);
  }
  return words;
}

const char* const body_frame = "the orientation of both bodies were the identity";
const char* const without_restitution = "ε were 0";

TEST(Explanation, NamesOneFaultOnce) {
  const std::vector<KnownCase> wrong =
      answers_of([](Steps& steps, const KnownCase& one) { (void)named(body_frame).mistakes[0](steps, one); });
  EXPECT_EQ(words_of(explanation_of(wrong, 0x1p-53)), std::set<std::string>{body_frame});
}

/// One fault concerns nearly all cases, the other those with ε < 1/2. Some cases have both.
TEST(Explanation, NamesARareFaultBesideAFrequentOne) {
  const std::vector<KnownCase> wrong = answers_of([](Steps& steps, const KnownCase& one) {
    (void)named(body_frame).mistakes[0](steps, one);
    if (one.collision.restitution < 0.5) {
      (void)named(without_restitution).mistakes[0](steps, one);
    }
  });
  const Explanation explanation = explanation_of(wrong, 0x1p-53);
  EXPECT_EQ(words_of(explanation), (std::set<std::string>{body_frame, without_restitution}));
  std::size_t with_both = 0;
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    with_both += explanation.by[i].size() == 2 ? 1 : 0;
    EXPECT_TRUE(wrong[i].collision.restitution < 0.5 || explanation.by[i].size() <= 1);
  }
  EXPECT_GT(with_both, 20U);
}

/// Each answer has factors of its own.
TEST(Explanation, DoesNotGuessIfNothingFits) {
  int number = 0;
  const std::vector<KnownCase> wrong = answers_of([&](Steps& steps, const KnownCase&) {
    ++number;
    steps.factors = {1 + 0.01 * number, 1 - 0.02 * number, 1 + 0.03 * number, 1};
  });
  EXPECT_TRUE(explanation_of(wrong, 0x1p-53).found.empty());
}

}  // namespace
}  // namespace carom::properties::diagnosis
