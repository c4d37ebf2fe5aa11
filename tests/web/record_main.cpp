// SPDX-License-Identifier: BSL-1.0
// record_answers FILE CASES: judges the solvers of src/subjects/methods and all mutants, prints a line of JSON for
// each, and writes their answers to FILE. `replay_answers` judges these answers again.
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <carom/subjects/catalogue.hpp>
#include <carom/subjects/protocol/messages.hpp>

#include "mutants/catalogue.hpp"
#include "recorded_answers.hpp"

namespace {

using namespace carom;

/// JavaScript's numbers have binary64, so subjects in extended precision are left out.
std::vector<Subject> judged_subjects() {
  std::vector<Subject> subjects;
  for (const Subject& subject : subjects::built_in_subjects()) {
    if (subject.precision != Precision::extended) {
      subjects.push_back(subject);
    }
  }
  for (const mutants::Mutant& mutant : mutants::all_mutants()) {
    subjects.push_back(subject_of(mutant));
  }
  return subjects;
}

std::string introduction_of(const Subject& subject) {
  subjects::protocol::Introduction introduction{.name = subject.name,
                                                .version = subject.version,
                                                .precision = subject.precision,
                                                .law = subject.law,
                                                .deviates = subject.deviates,
                                                .matrix = subject.shows_collision_matrix};
  introduction.effects = subject.effects;
  return introduction_reply(introduction);
}

}  // namespace

int main(int, char** words) {
  std::ofstream file(words[1], std::ios::binary);
  web_tests::ByteWriter all;
  for (const Subject& subject : judged_subjects()) {
    web_tests::ByteWriter answers;
    fmt::print("{}\n", web_tests::verdicts_on(recording(subject, answers), std::stoull(words[2])).dump());
    all.text(introduction_of(subject));
    all.text(answers.bytes());
  }
  file << all.bytes();
}
