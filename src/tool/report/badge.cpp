// SPDX-License-Identifier: BSL-1.0
#include "report/badge.hpp"

#include <string>

#include <fmt/format.h>

namespace carom::tool {
namespace {

std::string colour_of(const std::string& verdict, const Overall& overall) {
  if (verdict == "sound") {
    return "brightgreen";
  }
  return overall.violated > 0 ? "red" : "lightgrey";
}

}  // namespace

nlohmann::json badge_record(const Overall& overall) {
  const std::string verdict = in_words(overall);
  const std::string message = verdict == "sound" ? fmt::format("{} sound", overall.sound) : verdict;
  return {{"schemaVersion", 1}, {"label", "carom"}, {"message", message}, {"color", colour_of(verdict, overall)}};
}

}  // namespace carom::tool
