// SPDX-License-Identifier: BSL-1.0
#include <string>

#include <fmt/format.h>

#include <carom/report/pages/pages.hpp>

namespace carom::report {
namespace {

std::string colour_of(const std::string& verdict, const Overall& overall) {
  if (verdict == "sound") {
    return "brightgreen";
  }
  return overall.violated > 0 ? "red" : "lightgrey";
}

}  // namespace

nlohmann::json badge_record(const Run& run) {
  const Overall overall = overall_of(run);
  const std::string verdict = in_words(overall);
  const std::string message = verdict == "sound" ? fmt::format("{} sound", overall.sound) : verdict;
  return {{"schemaVersion", 1}, {"label", "carom"}, {"message", message}, {"color", colour_of(verdict, overall)}};
}

}  // namespace carom::report
