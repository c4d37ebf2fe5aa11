// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

/// A report.json as it is read: what a comparison needs of it. Texts are lines that are safe to print.
namespace carom::tool::compare {

/// Of one invariant on the cases of one family.
struct ReadCount {
  std::uint64_t holds = 0;
  std::uint64_t violated = 0;

  [[nodiscard]] std::uint64_t judged() const { return holds + violated; }
};

struct ReadFamily {
  std::string name;
  std::map<std::string, ReadCount> invariants;
};

/// A subject in one line.
struct SubjectSummary {
  std::string status;   // "sound", "violated", "error", "not judged" or "absent"
  std::string error;    // why it was not judged to the end
  std::string version;  // empty where it says none
  std::string model;
  std::string precision;
  std::uint64_t cases = 0;
  std::uint64_t violated_cases = 0;            // that violated any invariant
  std::vector<std::string> violated;           // invariants
  std::optional<double> worst_backward_error;  // ulps; none where the law determines no outcome
  std::string worst_family;                    // empty where there is none
  std::optional<double> digits_p50;            // none where no case has digits
  std::optional<double> digits_p99;
  std::optional<double> digits_worst;
  std::vector<std::string> deviates;  // "invariant" or "invariant@family"
  /// Invariants of the collision matrix, where the subject shows none; none where the report is of before they were
  /// listed.
  std::optional<std::vector<std::string>> not_claimed;
};

struct ReadSubject {
  std::string name;
  std::string specification;  // empty where it is built in
  bool counts = false;        // towards the exit status
  SubjectSummary summary;
  std::vector<ReadFamily> families;
};

struct ReadReport {
  std::string file;
  std::string carom;  // its version
  std::string date;
  std::uint64_t seed = 0;
  std::optional<std::uint64_t> cases;  // of each family; none where a budget decided
  std::optional<double> budget;        // seconds
  std::string yardstick;               // in words
  std::optional<std::uint64_t> relations_every;
  bool fail_fast = false;
  bool interrupted = false;
  std::string shard;  // "2/3"; empty for a whole run
  std::vector<std::string> families;
  std::vector<ReadSubject> subjects;
};

/// `file` is what it is to be called. Fields that are not asked for may be there or not. Throws FormatError, which
/// names the place, where one is missing, of another type, or a subject or a family stands there twice.
[[nodiscard]] ReadReport report_from_json(const nlohmann::json& record, const std::string& file);

/// Of a file, or of the directory that holds it as report.json. Throws UsageError, which names the file.
[[nodiscard]] ReadReport read_report(const std::string& file_or_directory);

/// The parsed text of that file, and its name. Throws UsageError.
struct ParsedFile {
  std::string file;
  nlohmann::json record;
};
[[nodiscard]] ParsedFile parsed_report(const std::string& file_or_directory);

/// The file's name, or what went wrong in it, as a line that is safe to print.
[[nodiscard]] std::string shown(const std::string& text);

}  // namespace carom::tool::compare
