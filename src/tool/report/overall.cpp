// SPDX-License-Identifier: BSL-1.0
#include "report/overall.hpp"

#include <fmt/format.h>

namespace carom::tool {
namespace {

void add_subject(Overall& overall, const std::string& status, std::size_t violated) {
  ++overall.subjects;
  overall.sound += status == "sound" ? 1 : 0;
  overall.not_judged += status == "error" || status == "not judged" ? 1 : 0;
  overall.violated += violated;
}

}  // namespace

Overall overall_of(const GateRun& run) {
  Overall overall;
  overall.interrupted = run.report.interrupted;
  for (std::size_t s = 0; s < run.report.results.size(); ++s) {
    if (run.counts[s]) {
      const properties::SubjectResult& result = run.report.results[s];
      add_subject(overall, status_of(result), result.violated_invariants().size());
    }
  }
  return overall;
}

Overall overall_of(const nlohmann::json& report) {
  Overall overall;
  overall.interrupted = report.at("interrupted").get<bool>();
  for (const nlohmann::json& subject : report.at("subjects")) {
    if (subject.at("counts").get<bool>()) {
      add_subject(overall, subject.at("status").get<std::string>(), subject.at("violations").size());
    }
  }
  return overall;
}

std::string in_words(const Overall& overall) {
  if (overall.violated > 0) {
    return fmt::format("{} violated", overall.violated);
  }
  const bool all_sound = overall.subjects > 0 && overall.sound == overall.subjects && !overall.interrupted;
  return all_sound ? "sound" : "not judged";
}

}  // namespace carom::tool
