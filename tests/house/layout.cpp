// SPDX-License-Identifier: BSL-1.0
#include "layout.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string_view>

namespace carom::layout {
namespace {

/// A rule for the includes of a folder's files. If `only` is set, a file may include the standard library, and paths
/// that begin with one of `names`. Otherwise it may include everything except these paths. The first rule that fits a
/// file applies.
struct Rule {
  std::string folder;
  std::string name_begins;  // beginning of the file name; empty matches any file
  bool only;
  std::vector<std::string> names;
};

/// The rule for a file of oracles/exact that includes these packages.
Rule of_exact(const std::string& file, const std::vector<std::string>& packages) {
  Rule rule{"oracles/exact/", file, true, {"carom/collision/", "carom/oracles/laws/", "carom/oracles/exact/"}};
  rule.names.insert(rule.names.end(), packages.begin(), packages.end());
  return rule;
}

const std::vector<Rule>& rules() {
  static const std::vector<Rule> all{
      {"src/collision/json/", "", true, {"carom/collision/", "Eigen/", "nlohmann/"}},
      {"src/collision/", "", true, {"carom/collision/", "Eigen/"}},
      {"src/impulse/", "", true, {"carom/collision/", "carom/impulse/", "Eigen/", "experimental/simd"}},
      {"src/scene/", "exact_time.cpp", true, {"carom/collision/", "carom/scene/", "CGAL/"}},
      {"src/scene/json/", "", true, {"carom/collision/", "carom/scene/", "Eigen/", "nlohmann/"}},
      {"src/scene/polyhedra/",
       "",
       true,
       {"carom/collision/", "carom/impulse/", "carom/scene/", "Eigen/", "fcl/", "gmpxx.h"}},
      {"src/scene/", "", true, {"carom/collision/", "carom/impulse/", "carom/scene/", "Eigen/"}},
      {"src/subjects/", "", false, {"carom/oracles/", "carom/properties/", "carom/report/", "carom/tool/", "CGAL/"}},
      // A report starts no process or thread and touches no file, so it includes no system header.
      {"src/report/document/", "", true, {"carom/collision/", "carom/report/document/", "pugixml"}},
      {"src/report/drawing/",
       "",
       true,
       {"carom/collision/", "carom/oracles/", "carom/report/document/", "carom/report/drawing/", "fmt/", "pugixml",
        "Eigen/"}},
      {"src/report/model/",
       "",
       true,
       {"carom/collision/", "carom/oracles/", "carom/properties/", "carom/report/model/", "fmt/", "nlohmann/"}},
      {"src/report/pages/",
       "",
       true,
       {"carom/collision/", "carom/oracles/", "carom/properties/", "carom/report/document/", "carom/report/drawing/",
        "carom/report/model/", "carom/report/pages/", "fmt/", "nlohmann/", "pugixml"}},
      {"src/report/chart/",
       "",
       true,
       {"carom/collision/", "carom/oracles/", "carom/report/document/", "carom/report/drawing/", "carom/report/model/",
        "carom/report/chart/", "fmt/", "nlohmann/"}},
      {"src/report/", "", true, {}},  // every file belongs to one of the folders above
      {"src/tool/",
       "",
       true,
       {"carom/", "CLI/", "fmt/", "nlohmann/", "pugixml", "benchmark/", "boost/", "Eigen/", "nlopt", "unistd.h", "sys/",
        "signal.h", "fcntl.h", "poll.h"}},
      // Trusted code includes no code that is not trusted.
      {"oracles/laws/", "", true, {"carom/collision/", "carom/oracles/laws/", "Eigen/"}},
      of_exact("gmpq.hpp", {"CGAL/Gmpq.h"}),
      of_exact("elimination.cpp", {"CGAL/Linear_algebraCd.h", "Eigen/"}),
      of_exact("radical.cpp", {"CGAL/Sqrt_extension.h"}),
      of_exact("roots.cpp", {"CGAL/Algebraic_kernel_d_1.h", "CGAL/Gmpz.h", "CGAL/Polynomial.h"}),
      of_exact("", {"Eigen/"}),
      {"oracles/numbers/",
       "",
       true,
       {"carom/collision/", "carom/oracles/laws/", "carom/oracles/exact/", "carom/oracles/numbers/", "Eigen/"}},
      {"oracles/models/",
       "",
       true,
       {"carom/collision/", "carom/oracles/laws/", "carom/oracles/exact/", "carom/oracles/numbers/",
        "carom/oracles/models/", "Eigen/"}},
      {"oracles/filters/",
       "",
       true,
       {"carom/collision/", "carom/oracles/laws/", "carom/oracles/exact/", "carom/oracles/numbers/",
        "carom/oracles/models/", "carom/oracles/filters/", "Eigen/"}},
      {"oracles/judge/", "", true, {"carom/collision/", "carom/oracles/", "Eigen/"}},
      {"oracles/", "", true, {}},  // every file belongs to one of the folders above
      {"properties/draws/", "", true, {"carom/collision/", "carom/properties/draws/", "Eigen/"}},
      // A family uses exact numbers and rotations of bodies, and no oracle.
      {"properties/families/",
       "",
       true,
       {"carom/collision/", "carom/oracles/exact/rational.hpp", "carom/oracles/laws/kinematics.hpp",
        "carom/properties/draws/", "carom/properties/families/", "carom/properties/features/compose.hpp", "fmt/",
        "Eigen/"}},
      {"properties/features/",
       "",
       true,
       {"carom/collision/", "carom/oracles/laws/kinematics.hpp", "carom/properties/draws/",
        "carom/properties/features/", "fmt/", "Eigen/"}},
      {"properties/conformance/",
       "",
       true,
       {"carom/collision/", "carom/rapidcheck.hpp", "carom/impulse/contact.hpp", "carom/oracles/", "carom/properties/",
        "fmt/", "Eigen/", "gtest/", "rapidcheck"}},
      {"properties/scenes/",
       "",
       true,
       {"carom/collision/", "carom/scene/", "carom/oracles/", "carom/properties/", "fmt/", "Eigen/", "boost/numeric/"}},
      {"properties/",
       "",
       true,
       {"carom/collision/", "carom/oracles/", "carom/properties/conformance/", "carom/properties/diagnosis/",
        "carom/properties/domains/", "carom/properties/draws/", "carom/properties/families/",
        "carom/properties/features/", "carom/properties/gate/", "carom/properties/invariants/",
        "carom/properties/plan/", "carom/properties/reach/", "carom/properties/search/",
        "carom/properties/three_properties.hpp", "carom/properties/trial/", "fmt/", "Eigen/"}},
      {"", "", false, {"carom/tool/", "CGAL/"}},
  };
  return all;
}

struct Room {
  std::string folder;
  std::vector<std::string> neighbours;
};

const std::vector<Room>& rooms() {
  static const std::vector<Room> all{{"src/tool/io/", {"io/"}},
                                     {"src/tool/chart/", {"io/", "chart/"}},
                                     {"src/tool/scene/", {"io/", "scene/"}},
                                     {"src/tool/plan/", {"io/", "chart/", "scene/", "plan/"}},
                                     {"src/tool/commands/", {"io/", "chart/", "scene/", "plan/", "commands/"}},
                                     {"src/tool/", {"io/", "commands/"}}};
  return all;
}

bool begins_with(std::string_view text, std::string_view beginning) {
  return text.substr(0, beginning.size()) == beginning;
}

const Rule& rule_for(const std::string& path) {
  const std::string file = path.substr(path.find_last_of('/') + 1);
  return *std::find_if(rules().begin(), rules().end(), [&](const Rule& rule) {
    return begins_with(path, rule.folder) && begins_with(file, rule.name_begins);
  });
}

bool is_standard(const std::string& name) {
  return std::all_of(name.begin(), name.end(),
                     [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; });
}

const std::set<std::string> outside{"csignal", "filesystem", "fstream", "future", "thread"};

/// Whether the file's component must start no process or thread and touch no file.
bool stays_inside(const std::string& path) {
  static const std::vector<std::string> folders{"oracles/", "properties/", "src/collision/", "src/impulse/",
                                                "src/report/"};
  return std::any_of(folders.begin(), folders.end(),
                     [&](const std::string& folder) { return begins_with(path, folder); });
}

bool is_allowed(const Rule& rule, const std::string& name) {
  if (name == "carom/oracles/exact/gmpq.hpp") {
    return rule.folder == "oracles/exact/";  // it includes CGAL, and is not installed
  }
  const bool named = std::any_of(rule.names.begin(), rule.names.end(),
                                 [&](const std::string& beginning) { return begins_with(name, beginning); });
  return rule.only ? named || is_standard(name) : !named;
}

/// Whether the file at `path` may include `name` in quotes, because `name` is in the same folder or a permitted
/// neighbour.
bool is_neighbour(const std::string& path, const std::string& name) {
  const auto room =
      std::find_if(rooms().begin(), rooms().end(), [&](const Room& one) { return begins_with(path, one.folder); });
  return room == rooms().end() || std::any_of(room->neighbours.begin(), room->neighbours.end(),
                                              [&](const std::string& folder) { return begins_with(name, folder); });
}

bool ends_with(std::string_view text, std::string_view ending) {
  return text.size() >= ending.size() && text.substr(text.size() - ending.size()) == ending;
}

bool is_source(const std::string& path) {
  const std::string file = path.substr(path.find_last_of('/') + 1);
  return ends_with(file, ".hpp") || ends_with(file, ".cpp") || ends_with(file, ".sh") || ends_with(file, ".cmake") ||
         file == "CMakeLists.txt";
}

}  // namespace

std::vector<std::string> include_offences(const std::string& path, const std::string& text) {
  static const std::regex include(R"re(^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"])re");
  const Rule& rule = rule_for(path);
  std::vector<std::string> offences;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (!std::regex_search(line, match, include)) {
      continue;
    }
    // A name in quotes could refer to any file. So only programs that install no header (the tool and the tests) may
    // use quotes, and only for a neighbouring file.
    const bool quoted = match[1] == "\"";
    const bool may_quote = begins_with(path, "src/tool/") || begins_with(path, "tests/");
    const std::string name = match[2];
    const bool leaves_folder = name.find("..") != std::string::npos;
    const bool reaches_out = stays_inside(path) && outside.contains(name);
    const bool not_beside = !may_quote || leaves_folder || !is_neighbour(path, name);
    if (reaches_out || (quoted ? not_beside : !is_allowed(rule, name) || leaves_folder)) {
      offences.push_back(path + ": includes " + (quoted ? '"' + name + '"' : '<' + name + '>'));
    }
  }
  return offences;
}

std::vector<std::string> licence_offences(const std::string& path, const std::string& text) {
  if (!is_source(path)) {
    return {};
  }
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  if (begins_with(line, "#!")) {
    std::getline(lines, line);
  }
  const std::string comment = ends_with(path, "pp") ? "//" : "#";
  const std::string tag = "SPDX-License-Identifier: BSL-1.0";
  return line == comment + ' ' + tag ? std::vector<std::string>{} : std::vector{path + ": does not begin with " + tag};
}

std::vector<std::string> top_level_offences(const std::vector<std::string>& names) {
  const std::set<std::string> house{"CMakeLists.txt", "CMakePresets.json", "README.md", "docs",
                                    "oracles",        "properties",        "src",       "tests"};
  std::vector<std::string> offences;
  for (const std::string& name : house) {
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      offences.push_back(name + " is missing");
    }
  }
  for (const std::string& name : names) {
    if (!house.contains(name) && !begins_with(name, ".") && !begins_with(name, "build")) {
      offences.push_back(name + " should not be there");
    }
  }
  return offences;
}

std::vector<SourceFile> source_files(const std::filesystem::path& top) {
  std::vector<SourceFile> files;
  auto walk = std::filesystem::recursive_directory_iterator(top);
  for (auto entry = std::filesystem::begin(walk); entry != std::filesystem::end(walk); ++entry) {
    const std::string name = entry->path().filename().string();
    if (entry->is_directory()) {
      if (begins_with(name, ".") || name == "node_modules" || (entry.depth() == 0 && begins_with(name, "build"))) {
        entry.disable_recursion_pending();
      }
      continue;
    }
    const std::string path = std::filesystem::relative(entry->path(), top).generic_string();
    if (is_source(path)) {
      std::ifstream stream(entry->path(), std::ios::binary);
      files.push_back({path, std::string(std::istreambuf_iterator<char>(stream), {})});
    }
  }
  std::sort(files.begin(), files.end(),
            [](const SourceFile& left, const SourceFile& right) { return left.path < right.path; });
  return files;
}

}  // namespace carom::layout
