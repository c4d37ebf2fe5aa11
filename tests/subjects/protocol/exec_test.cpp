// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/collision/doubles.hpp>
#include <carom/collision/json/text.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/subjects/catalogue.hpp>
#include <carom/subjects/protocol/command_line.hpp>
#include <carom/subjects/protocol/exec.hpp>
#include <carom/subjects/protocol/spelling.hpp>

#include "io/threads.hpp"
#include "support/expect_in.hpp"

namespace carom::subjects::protocol {
namespace {

properties::GateReport gate_of(const std::vector<Subject>& subjects, unsigned jobs) {
  properties::GateOptions options;
  options.cases = 60;
  options.workers = tool::threads(jobs);
  options.relations_every = 1;
  for (const properties::Family& family : properties::all_families()) {
    options.families.push_back(&family);
  }
  return properties::run_gate(subjects, options);
}

/// Each subject with the form of its numbers. Two subjects are wrong.
TEST(Exec, ChangesNoVerdictAndNoWitness) {
  for (const auto& [name, numbers] : std::vector<std::array<const char*, 2>>{{"frictionless-double", ""},
                                                                             {"frictionless-double", " hex"},
                                                                             {"reflection-float", ""},
                                                                             {"reflection-llt-long-double", ""},
                                                                             {"sticking-world-double", ""},
                                                                             {"sticking-world-double", " hex"},
                                                                             {"reflection-adjugate-float", ""},
                                                                             {"reflection-adjugate-float", " hex"}}) {
    const Subject here = *subject_named(name);
    const Subject there = exec_subject(std::string("exec:") + CAROM_WELL_BEHAVED + ' ' + name + numbers, {});
    EXPECT_EQ(there.spellings, *numbers == 0 ? spelling_count : 1);
    EXPECT_EQ(there.name, here.name);
    EXPECT_EQ(there.law, here.law);
    EXPECT_EQ(there.precision, here.precision);
    EXPECT_EQ(there.shows_collision_matrix, here.shows_collision_matrix);
    const properties::GateReport report = gate_of({here, there}, 2);
    ASSERT_EQ(report.results[1].error, "");
    for (std::size_t f = 0; f < report.options.families.size(); ++f) {
      const properties::FamilyResult& in_process = report.results[0].families[f];
      const properties::FamilyResult& over_the_line = report.results[1].families[f];
      EXPECT_EQ(in_process.cases, over_the_line.cases);
      EXPECT_EQ(in_process.worst_backward_error, over_the_line.worst_backward_error);
      ASSERT_EQ(in_process.counts.size(), over_the_line.counts.size());
      for (const auto& [invariant, count] : in_process.counts) {
        const properties::Count& other = over_the_line.counts.at(invariant);
        EXPECT_EQ(count.holds, other.holds) << name << ' ' << invariant;
        EXPECT_EQ(count.violated, other.violated) << name << ' ' << invariant;
        EXPECT_EQ(count.skipped, other.skipped) << name << ' ' << invariant;
      }
    }
    ASSERT_EQ(report.results[0].witnesses.size(), report.results[1].witnesses.size());
    EXPECT_EQ(report.results[0].witnesses.empty(), report.results[0].is_sound()) << name;
    for (std::size_t w = 0; w < report.results[0].witnesses.size(); ++w) {
      const properties::Witness& in_process = report.results[0].witnesses[w];
      const properties::Witness& over_the_line = report.results[1].witnesses[w];
      EXPECT_EQ(in_process.invariant, over_the_line.invariant) << name;
      EXPECT_EQ(doubles_of(in_process.shrunk.collision), doubles_of(over_the_line.shrunk.collision)) << name;
    }
  }
}

/// For programs, each relation is judged on every fourth case.
TEST(Exec, IsAskedAboutRelatedCollisionsOnEveryFourthCase) {
  const Subject subject = exec_subject(std::string("exec:") + CAROM_WELL_BEHAVED, {});
  properties::GateOptions options;
  options.cases = 80;
  options.families = {properties::family_named("generic")};
  const properties::GateReport report = properties::run_gate({subject, *subject_named("frictionless-double")}, options);
  EXPECT_EQ(report.results[0].count(*properties::invariant_named("swap")).holds, 20U);
  EXPECT_EQ(report.results[0].count(*properties::invariant_named("rotation")).holds, 20U);
  EXPECT_EQ(report.results[0].count(*properties::invariant_named("backward_error")).holds, 80U);
  EXPECT_EQ(report.results[1].count(*properties::invariant_named("swap")).holds, 80U);
}

TEST(Exec, AnswersManyAtOnceAndNone) {
  for (const char* numbers : {"", " hex"}) {
    const Subject subject =
        exec_subject(std::string("exec:") + CAROM_WELL_BEHAVED + " frictionless-double" + numbers, {});
    Session session = subject.open();
    EXPECT_TRUE(session({}).empty());
    // 5000 collisions exceed the buffers of the pipes.
    const std::vector<Collision> many(5000);
    EXPECT_EQ(session(many).size(), many.size());
    EXPECT_EQ(session(std::span(many).first(1)).size(), 1U);
    session.close();
  }
}

/// An extended number does not fit into 16 digits.
TEST(Exec, RefusesHexadecimalNumbersOfExtendedPrecision) {
  const Subject subject = exec_subject(std::string("exec:") + CAROM_WELL_BEHAVED + " frictionless-long-double hex", {});
  try {
    (void)subject.open();
    ADD_FAILURE() << "it was opened";
  } catch (const std::exception& error) {
    unit::expect_in(std::string(error.what()), {"/numbers: hex has the bits of binary64"});
  }
}

using Words = std::vector<std::string>;

TEST(Words, AreSplitAndUnquotedAsAShellDoes) {
  EXPECT_EQ(split_words(""), Words{});
  EXPECT_EQ(split_words("  \t\n "), Words{});
  EXPECT_EQ(split_words("python3 solver.py"), (Words{"python3", "solver.py"}));
  EXPECT_EQ(split_words(" a  b\tc "), (Words{"a", "b", "c"}));
  EXPECT_EQ(split_words("'a b' \"c d\""), (Words{"a b", "c d"}));
  EXPECT_EQ(split_words("a'b'\"c\"d"), (Words{"abcd"}));
  EXPECT_EQ(split_words("'' \"\""), (Words{"", ""}));
  EXPECT_EQ(split_words(R"(a\ b \'c \\)"), (Words{"a b", "'c", R"(\)"}));
  EXPECT_EQ(split_words(R"("\"\\\$\`\n")"), (Words{R"("\$`\n)"}));
  EXPECT_EQ(split_words(R"('\n')"), (Words{R"(\n)"}));
  EXPECT_EQ(split_words("a\\\nb"), (Words{"ab"}));
}

TEST(Words, KeepWhatOnlyAShellWouldCarryOut) {
  EXPECT_EQ(split_words("a; rm -r $HOME | b > c & `d` $(e) *?[f] #g ~"),
            (Words{"a;", "rm", "-r", "$HOME", "|", "b", ">", "c", "&", "`d`", "$(e)", "*?[f]", "#g", "~"}));
}

TEST(Words, RefuseAQuotationThatIsNotClosed) {
  for (const char* text : {"'a", "\"a", "a\\", "\"a\\\""}) {
    EXPECT_THROW((void)split_words(text), std::invalid_argument) << text;
  }
}

TEST(Words, AreReadBackAsTheyWereQuoted) {
  for (const char* word : {"", "plain", "two words", "it's", "'", "\\", "\"$HOME\"", "a\nb", "ü"}) {
    EXPECT_EQ(split_words(quoted(word)), Words{word});
  }
}

}  // namespace
}  // namespace carom::subjects::protocol
