// SPDX-License-Identifier: BSL-1.0
#include "io/journal.hpp"

#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <carom/report/model/run_json.hpp>
#include <carom/report/model/words.hpp>

#include "io/output_file.hpp"
#include "io/report_file.hpp"
#include "io/staged_output.hpp"
#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

namespace fs = std::filesystem;

constexpr const char* remedy = "remove the folder, or choose another --out";

std::string name_of_part(const properties::Shard& part) {
  return fmt::format("part-{}-of-{}.json", part.number, part.of);
}

std::vector<fs::path> parts_in(const fs::path& folder) {
  std::vector<fs::path> parts;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("part-") && name.ends_with(".json")) {
      parts.push_back(entry.path());
    }
  }
  return parts;
}

}  // namespace

Journal::Journal(fs::path folder, report::RunFacts facts, std::uint64_t shards)
    : folder_(std::move(folder)), facts_(std::move(facts)) {
  StagedOutput(folder_).remove_abandoned_stages();
  for (const fs::path& file : parts_in(folder_)) {
    if (!file.string().ends_with(fmt::format("-of-{}.json", shards))) {
      throw UsageError(fmt::format("--journal: {} belongs to another run: it is not one of {} parts; {}",
                                   report::shown(file.string()), shards, remedy));
    }
  }
}

std::optional<properties::GateReport> Journal::finished(const properties::Shard& part) const {
  const fs::path file = folder_ / name_of_part(part);
  if (!fs::exists(file)) {
    return std::nullopt;
  }
  report::ReadShard read = read_shard_report(file.string());
  if (const auto difference = report::first_difference(report::run_facts(read.run), facts_)) {
    throw UsageError(fmt::format("--journal: {} belongs to another run: {}: {}, but here {}; {}",
                                 report::shown(file.string()), difference->field, report::shown(difference->first),
                                 report::shown(difference->second), remedy));
  }
  if (read.run.options.shard.number != part.number) {
    throw UsageError(fmt::format("--journal: {}: /shard/number: expected {}, found {}; {}",
                                 report::shown(file.string()), part.number, read.run.options.shard.number, remedy));
  }
  return std::move(read.run);
}

void Journal::keep(const report::Run& run) const {
  const std::string name = name_of_part(run.options.shard);
  StagedOutput staged(folder_);
  write_file(staged.stage() / name,
             report::report_record(run).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n');
  staged.put_in_place(name);
}

void Journal::remove() const {
  std::error_code ignored;
  for (const fs::path& file : parts_in(folder_)) {
    fs::remove(file, ignored);
  }
  fs::remove(folder_, ignored);
}

}  // namespace carom::tool
