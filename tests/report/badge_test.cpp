// SPDX-License-Identifier: BSL-1.0
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <carom/report/pages/pages.hpp>

namespace carom::report {
namespace {

using Subjects = std::vector<RecordedSubject>;
using Status = SubjectStatus;

RecordedSubject subject(SubjectStatus status, std::size_t count, bool counts = true) {
  RecordedSubject subject;
  subject.summary.status = status;
  subject.counts = counts;
  subject.summary.violated.resize(count);
  return subject;
}

nlohmann::json badge(const Subjects& subjects, bool interrupted = false) {
  RecordedRun run;
  run.subjects = subjects;
  run.interrupted = interrupted;
  return badge_record(run);
}

nlohmann::json expected(const std::string& message, const std::string& colour) {
  return {{"schemaVersion", 1}, {"label", "carom"}, {"message", message}, {"color", colour}};
}

TEST(Badge, SaysTheVerdictOnWhatCounts) {
  EXPECT_EQ(badge({subject(Status::sound, 0), subject(Status::violated, 5, false)}),
            expected("1 sound", "brightgreen"));
  EXPECT_EQ(badge({subject(Status::sound, 0), subject(Status::sound, 0)}), expected("2 sound", "brightgreen"));
  EXPECT_EQ(badge({subject(Status::violated, 2), subject(Status::sound, 0), subject(Status::violated, 1)}),
            expected("3 violated", "red"));
  EXPECT_EQ(badge({subject(Status::error, 1)}), expected("1 violated", "red")) << "a violation comes first";
  const nlohmann::json grey = expected("not judged", "lightgrey");
  EXPECT_EQ(badge({subject(Status::sound, 0), subject(Status::error, 0)}), grey);
  EXPECT_EQ(badge({subject(Status::sound, 0), subject(Status::not_judged, 0)}), grey);
  EXPECT_EQ(badge(Subjects{subject(Status::sound, 0)}, true), grey) << "the run was interrupted";
  EXPECT_EQ(badge(Subjects{subject(Status::sound, 0, false)}), grey) << "no subject counts";
}

}  // namespace
}  // namespace carom::report
