// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <carom/properties/gate/gate_result.hpp>

/// The commands of the program. Each writes to standard output and returns the exit status.
namespace carom::tool {

inline constexpr int exit_all_hold = 0;
inline constexpr int exit_violated = 1;
inline constexpr int exit_usage = 2;  // usage, environment, or input that cannot be read

/// What the user asked for cannot be done; the text says what and why. Ends the program with exit_usage.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct GateArguments {
  std::vector<std::string> subjects;
  std::vector<std::string> families;
  std::uint64_t seed = 1;
  std::uint64_t cases = 1000;
  std::optional<std::chrono::nanoseconds> budget;  // in place of `cases`
  bool fail_fast = false;
  double limit_ulps = 32;
  std::optional<int> digits;
  bool exact = false;       // judged in ℚ alone
  unsigned jobs = 0;        // 0: one for each core
  std::string out;          // a directory; empty for none
  std::string annotations;  // "github", or empty for none
  std::string summary;      // a file to add to; empty for none
  bool engines = false;
  std::uint64_t relations_every = 0;  // 0: as GateOptions says
  double timeout = 5;                 // of each reply of a program [s]
  std::string format = "text";
  std::string baseline;                         // a report.json, or the directory that holds it; empty for none
  std::vector<std::string> deviates;            // "invariant" or "invariant@family"
  std::optional<properties::Shard> shard = {};  // that alone is judged; empty for the whole
};

struct CompareArguments {
  std::string before;  // reports, or the directories that hold them
  std::string now;
  std::string format = "text";
};

struct MergeArguments {
  std::vector<std::string> directories;  // of the shards
  std::string out;                       // a directory
  std::string baseline;                  // as of a gate
  std::string format = "text";
};

struct ReplayArguments {
  std::string file;               // empty where a case of a family is meant
  bool drawn = false;             // of a witness the collision that was drawn
  std::string family;             // whose case is replayed in place of a file
  std::uint64_t case_number = 0;  // in the family
  std::uint64_t seed = 1;
  std::string subject;  // empty: the one that a witness names
  double timeout = 5;   // of each reply of a program [s]
  double limit_ulps = 32;
  std::optional<int> digits;
  bool exact = false;  // judged in ℚ alone
  std::string format = "text";
};

struct ChartArguments {
  std::vector<std::string> methods;  // names; empty for all
  std::string out;                   // a directory
  std::uint64_t seed = 1;
  std::size_t cases = 200;  // of each family, and at each point of a sweep
  int repetitions = 5;      // of each timing
  unsigned jobs = 0;        // threads that judge; 0: one for each core
};

struct SceneArguments {
  std::string file;
  std::vector<std::string> laws;        // names; empty for the scene's own
  std::string out;                      // a directory; empty for none
  std::uint64_t judge_every = 1;        // every so many impulses; 0: none
  bool check = true;                    // that nothing overlaps
  std::optional<std::uint64_t> events;  // that end the run
  unsigned jobs = 0;                    // laws that run at once; 0: one for each core
  std::string format = "text";
};

struct PlanArguments {
  std::string file;
  std::string law;         // the name of a model, not `any`; empty: a scene's own, else rough
  double limit_ulps = 32;  // of binary64
  std::optional<int> digits;
  bool exact_law = false;
  int repetitions = 5;  // of each timing; 0: nothing is timed
  unsigned jobs = 0;    // threads that judge; 0: one for each core
  std::string format = "text";
};

[[nodiscard]] int gate(const GateArguments& arguments);
/// Runs a scene, judges its impulses, checks that nothing overlaps, and books its energy.
[[nodiscard]] int run_scene_file(const SceneArguments& arguments);
/// Measures time and exactness of the methods, draws them against each other, and prints the tables.
[[nodiscard]] int chart_methods(const ChartArguments& arguments);
[[nodiscard]] int replay(const ReplayArguments& arguments);
/// Prints the least that serves the contacts of a file, and what the lint finds in them: exit_violated where nothing
/// serves.
[[nodiscard]] int plan_contacts(const PlanArguments& arguments);
/// Prints what differs between two reports: exit_violated where something is new in the second.
[[nodiscard]] int compare_files(const CompareArguments& arguments);
/// Makes the report of the whole of those of its shards: the exit status is that of the whole.
[[nodiscard]] int merge_shards(const MergeArguments& arguments);
/// Prints the subjects of a report.json as a Markdown table.
[[nodiscard]] int table(const std::string& file);
/// Writes the verdict of a report.json as JSON for a badge; to standard output if `out` is empty.
[[nodiscard]] int badge(const std::string& file, const std::string& out);
[[nodiscard]] int list_subjects(const std::string& format);
[[nodiscard]] int list_invariants(const std::string& format);
[[nodiscard]] int list_families(const std::string& format, std::uint64_t seed);
[[nodiscard]] int list_features(const std::string& format);

}  // namespace carom::tool
