// SPDX-License-Identifier: BSL-1.0
#include <string>

#include <fmt/format.h>

#include <carom/report/pages/pages.hpp>

namespace carom::report {
namespace {

std::string colour_of(bool is_sound, const Overall& overall) {
  if (is_sound) {
    return "brightgreen";
  }
  return overall.violated > 0 ? "red" : "lightgrey";
}

}  // namespace

nlohmann::json badge_record(const RecordedRun& run) {
  const Overall overall = overall_of(run);
  const std::string verdict = in_words(overall);
  const bool is_sound = is_sound_throughout(overall);
  const std::string message = is_sound ? fmt::format("{} {}", overall.sound, verdict) : verdict;
  return {{"schemaVersion", 1}, {"label", "carom"}, {"message", message}, {"color", colour_of(is_sound, overall)}};
}

}  // namespace carom::report
