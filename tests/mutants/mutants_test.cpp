// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <carom/properties/invariants/invariant.hpp>

#include "catalogue.hpp"
#include "rejection.hpp"
#include "support/selected.hpp"

namespace carom::mutants {
namespace {

constexpr std::uint64_t fixed_seed = 1;
constexpr std::uint64_t cases_of_each_family = 150;

std::string joined(const Rejecting& names) {
  std::string text;
  for (const std::string_view name : names) {
    text.append(text.empty() ? "" : " ").append(name);
  }
  return text;
}

/// One pass over the families judges all subjects of a test suite.
class OnePass {
 public:
  explicit OnePass(const std::map<std::string, Subject>& subject_of_parameter) {
    std::vector<Subject> subjects;
    for (const auto& [name, subject] : subject_of_parameter) {
      if (unit::is_selected(name)) {
        names_.push_back(name);
        subjects.push_back(subject);
      }
    }
    rejecting_ = rejecting_invariants(subjects, properties::all_families(), fixed_seed, cases_of_each_family);
  }

  [[nodiscard]] const Rejecting& rejecting(std::string_view name) const {
    return rejecting_.at(static_cast<std::size_t>(std::find(names_.begin(), names_.end(), name) - names_.begin()));
  }

 private:
  std::vector<std::string> names_;
  std::vector<Rejecting> rejecting_;
};

class Mutants : public testing::TestWithParam<Mutant> {
 protected:
  static void SetUpTestSuite() {
    std::map<std::string, Subject> subjects;
    for (const Mutant& mutant : all_mutants()) {
      subjects.emplace(mutant.name, subject_of(mutant));
    }
    pass.emplace(subjects);
  }

  static inline std::optional<OnePass> pass;
};

TEST_P(Mutants, AreRejectedByTheInvariantsThatSpeakOfTheirDefect) {
  const Mutant& mutant = GetParam();
  const Rejecting& rejecting = pass->rejecting(mutant.name);
  RecordProperty("rejected_by", joined(rejecting));
  for (const std::string_view expected : mutant.rejected_by) {
    EXPECT_TRUE(rejecting.contains(expected))
        << expected << " does not reject this defect: " << mutant.sentence << "; rejected by: " << joined(rejecting);
  }
}

INSTANTIATE_TEST_SUITE_P(Each, Mutants, testing::ValuesIn(all_mutants().begin(), all_mutants().end()),
                         [](const auto& test) { return std::string(test.param.name); });

/// All mutants are defects of one solver, so repaired mutants differ only by their law.
class Repaired : public testing::TestWithParam<Law> {
 protected:
  static void SetUpTestSuite() {
    std::map<std::string, Subject> subjects;
    for (const Mutant& mutant : all_mutants()) {
      subjects.try_emplace(std::string(name_of(mutant.law)), repaired(mutant));
    }
    pass.emplace(subjects);
  }

  static inline std::optional<OnePass> pass;
};

TEST_P(Repaired, MutantIsSound) { EXPECT_EQ(joined(pass->rejecting(name_of(GetParam()))), ""); }

INSTANTIATE_TEST_SUITE_P(Laws, Repaired,
                         testing::Values(Law::frictionless, Law::reflection, Law::sticking, Law::rough, Law::coulomb),
                         [](const auto& test) { return std::string(name_of(test.param)); });

/// A law that determines no outcome has no truth to compare with.
TEST(MutantCatalogue, PushesOfBodiesAtRestAreRejectedUnderAny) {
  for (const Mutant& mutant : all_mutants()) {
    if (mutant.defect == Defect::resting_pushed_apart || mutant.defect == Defect::resting_pushed_aside) {
      std::vector<Subject> subject{subject_of(mutant)};
      subject[0].law = Law::any;
      const Rejecting rejecting =
          rejecting_invariants(subject, properties::all_families(), fixed_seed, cases_of_each_family).at(0);
      EXPECT_TRUE(rejecting.contains("impulse_bound")) << mutant.name << ": " << joined(rejecting);
    }
  }
}

TEST(MutantCatalogue, NamesEachDefectOfALawOnce) {
  std::set<std::string_view> names;
  std::set<std::pair<Law, Defect>> defects;
  for (const Mutant& mutant : all_mutants()) {
    EXPECT_TRUE(names.insert(mutant.name).second) << mutant.name;
    EXPECT_TRUE(defects.insert({mutant.law, mutant.defect}).second) << mutant.name;
    EXPECT_NE(mutant.defect, Defect::none) << mutant.name;
  }
}

TEST(MutantCatalogue, NamesInvariantsThatTheSubjectClaims) {
  for (const Mutant& mutant : all_mutants()) {
    EXPECT_FALSE(mutant.rejected_by.empty()) << mutant.name;
    for (const std::string_view name : mutant.rejected_by) {
      const properties::Invariant* invariant = properties::invariant_named(name);
      ASSERT_NE(invariant, nullptr) << mutant.name << ": " << name;
      EXPECT_TRUE(invariant->claimed_for(mutant.law)) << mutant.name << ": " << name;
    }
  }
}

/// An invariant other than `backward_error` rejects each mutant, with two exceptions: mutants that lose digits, and
/// mutants of `rough` whose friction has a wrong size.
TEST(MutantCatalogue, NeedsTheTruthOnlyForLostDigitsAndSizesOfFriction) {
  for (const Mutant& mutant : all_mutants()) {
    const bool loses_digits =
        mutant.defect == Defect::outcome_to_ten_digits || mutant.defect == Defect::outcome_in_float;
    const bool by_a_law = std::any_of(mutant.rejected_by.begin(), mutant.rejected_by.end(),
                                      [](std::string_view name) { return name != "backward_error"; });
    const bool is_of_a_share = mutant.defect == Defect::friction_before_restitution ||
                               mutant.defect == Defect::tangential_restitution_ignored ||
                               mutant.defect == Defect::tangential_restitution_reversed;
    EXPECT_TRUE(by_a_law || loses_digits || is_of_a_share) << mutant.name;
  }
}

/// Together with Mutants.AreRejected…, this test shows that no invariant is vacuous.
TEST(MutantCatalogue, HasAMutantForEveryInvariant) {
  std::set<std::string_view> rejecting;
  for (const Mutant& mutant : all_mutants()) {
    rejecting.insert(mutant.rejected_by.begin(), mutant.rejected_by.end());
  }
  for (const properties::Invariant& invariant : properties::all_invariants()) {
    EXPECT_TRUE(rejecting.contains(invariant.name)) << invariant.name << " rejects no mutant";
  }
}

}  // namespace
}  // namespace carom::mutants
