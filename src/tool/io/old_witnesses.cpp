// SPDX-License-Identifier: BSL-1.0
#include "io/old_witnesses.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <carom/collision/json/json.hpp>
#include <carom/properties/invariants/invariant.hpp>

#include "io/json_file.hpp"
#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* report_name = "report.json";

fs::file_type type_of(const fs::path& path) {
  std::error_code ignored;
  return fs::symlink_status(path, ignored).type();
}

/// The witnesses that the report lists; none if the file is not a report of this program.
std::vector<fs::path> listed_witnesses(const fs::path& report_file) {
  if (type_of(report_file) != fs::file_type::regular) {
    return {};
  }
  std::vector<fs::path> listed;
  try {
    const json report = parse_json(content_of_file(report_file.string()));
    (void)report.at("carom");
    for (const json& subject : report.at("subjects")) {
      for (const json& violation : subject.value("violations", json::array())) {
        listed.emplace_back(violation.at("witness").get<std::string>());
      }
    }
  } catch (const UsageError&) {
    return {};
  } catch (const FormatError&) {
    return {};
  } catch (const json::exception&) {
    return {};
  }
  return listed;
}

/// Whether the path is "witnesses/SUBJECT.INVARIANT.json". Another path could lead to any file.
bool is_witness_path(const fs::path& path) {
  const std::string invariant = path.stem().extension().string();
  return path == fs::path("witnesses") / path.filename() && path.extension() == ".json" && !invariant.empty() &&
         properties::invariant_named(invariant.substr(1)) != nullptr;
}

}  // namespace

std::vector<fs::path> old_witnesses(const fs::path& directory, const StagedOutput& staged) {
  std::vector<fs::path> old = listed_witnesses(directory / report_name);
  for (const fs::path& stage : staged.abandoned_stages()) {
    const std::vector<fs::path> listed = listed_witnesses(stage / report_name);
    old.insert(old.end(), listed.begin(), listed.end());
  }
  return old;
}

void remove_old_witnesses(const fs::path& directory, const std::vector<fs::path>& old) {
  if (old.empty() || type_of(directory / "witnesses") != fs::file_type::directory) {
    return;
  }
  const std::vector<fs::path> current = listed_witnesses(directory / report_name);
  for (const fs::path& listed : old) {
    const fs::path file = directory / listed;
    const bool is_current = std::find(current.begin(), current.end(), listed) != current.end();
    if (is_current || !is_witness_path(listed) || type_of(file) != fs::file_type::regular) {
      continue;
    }
    std::error_code error;
    fs::remove(file, error);
    if (error) {
      throw UsageError(fmt::format("--out: {} cannot be removed: {}", file.string(), error.message()));
    }
  }
}

}  // namespace carom::tool
