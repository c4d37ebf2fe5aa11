// SPDX-License-Identifier: BSL-1.0
#include <set>
#include <string>

#include <gtest/gtest.h>

#include <carom/collision/validate.hpp>
#include <carom/properties/diagnosis/hypothesis.hpp>
#include <carom/properties/families/family.hpp>

namespace carom::properties::diagnosis {
namespace {

std::vector<KnownCase> right_answers(Law law) {
  std::vector<KnownCase> cases;
  for (const Family& family : all_families()) {
    for (std::uint64_t number = 0; number < 6; ++number) {
      const Case one = drawn_case(family, 1, number);
      if (validate(one.collision).empty()) {
        const LawAnswer answer = law_answer(one.collision, law);
        const auto wide =
            map_outcome<long double>(answer.outcome, [](double x) { return static_cast<long double>(x); });
        if (const auto known = known_case({number, one, wide}, law)) {
          cases.push_back(*known);
        }
      }
    }
  }
  return cases;
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
  for (const Law law : laws_with_truth) {
    for (KnownCase one : right_answers(law)) {
      for (const Hypothesis& hypothesis : all_hypotheses()) {
        const auto answer = hypothesis.answer(one);
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

TEST(Hypotheses, NothingIsVisiblyOffInARightAnswer) {
  for (const Law law : laws_with_truth) {
    for (const KnownCase& one : right_answers(law)) {
      EXPECT_FALSE(is_visibly_off(one, 0x1p-53));
    }
  }
}

}  // namespace
}  // namespace carom::properties::diagnosis
