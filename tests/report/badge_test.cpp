// SPDX-License-Identifier: BSL-1.0
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <carom/report/pages/pages.hpp>

namespace carom::report {
namespace {

using Subjects = std::vector<JudgedSubject>;

JudgedSubject subject(const std::string& status, std::size_t violated, bool counts = true) {
  JudgedSubject subject;
  subject.status = status;
  subject.counts = counts;
  subject.violations.resize(violated);
  return subject;
}

nlohmann::json badge(const Subjects& subjects, bool interrupted = false) {
  Run run;
  run.subjects = subjects;
  run.interrupted = interrupted;
  return badge_record(run);
}

nlohmann::json expected(const std::string& message, const std::string& colour) {
  return {{"schemaVersion", 1}, {"label", "carom"}, {"message", message}, {"color", colour}};
}

TEST(Badge, SaysTheVerdictOnWhatCounts) {
  EXPECT_EQ(badge({subject("sound", 0), subject("violated", 5, false)}), expected("1 sound", "brightgreen"));
  EXPECT_EQ(badge({subject("sound", 0), subject("sound", 0)}), expected("2 sound", "brightgreen"));
  EXPECT_EQ(badge({subject("violated", 2), subject("sound", 0), subject("violated", 1)}),
            expected("3 violated", "red"));
  EXPECT_EQ(badge({subject("error", 1)}), expected("1 violated", "red")) << "a violation comes first";
  const nlohmann::json not_judged = expected("not judged", "lightgrey");
  EXPECT_EQ(badge({subject("sound", 0), subject("error", 0)}), not_judged);
  EXPECT_EQ(badge({subject("sound", 0), subject("not judged", 0)}), not_judged);
  EXPECT_EQ(badge(Subjects{subject("sound", 0)}, true), not_judged) << "the run was interrupted";
  EXPECT_EQ(badge(Subjects{subject("sound", 0, false)}), not_judged) << "no subject counts";
}

}  // namespace
}  // namespace carom::report
