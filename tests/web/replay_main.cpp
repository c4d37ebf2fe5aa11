// SPDX-License-Identifier: BSL-1.0
// replay_answers FILE CASES: judges the answers that `record_answers` wrote to FILE, and prints the same lines.
#include <fstream>
#include <sstream>
#include <string>

#include <fmt/format.h>

#include <carom/subjects/protocol/messages.hpp>

#include "recorded_answers.hpp"

int main(int, char** words) {
  std::ostringstream content;
  content << std::ifstream(words[1], std::ios::binary).rdbuf();
  const std::string bytes = content.str();
  carom::web_tests::ByteReader all(bytes);
  while (!all.is_at_end()) {
    carom::Subject subject;
    carom::subjects::protocol::introduce(subject, carom::subjects::protocol::introduction_from(all.text()));
    const std::string recorded = all.text();
    carom::web_tests::ByteReader answers(recorded);
    nlohmann::json verdicts = carom::web_tests::verdicts_on(replaying(subject, answers), std::stoull(words[2]));
    if (!answers.is_at_end()) {
      verdicts["error"] = "the judge asks fewer questions than were recorded";
    }
    fmt::print("{}\n", verdicts.dump());
  }
}
