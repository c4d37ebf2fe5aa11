// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

/// The rules of the source tree: the includes of each folder, the names at the top level, and the licence tags.
namespace carom::layout {

/// The offences of one source file, for example "src/impulse/x.hpp: includes <CGAL/Gmpq.h>". The path is relative to
/// the top of the source tree, with slashes. Files in folders without a rule have no offences.
[[nodiscard]] std::vector<std::string> include_offences(const std::string& path, const std::string& text);

/// One offence if the first comment of a source file does not name BSL-1.0.
[[nodiscard]] std::vector<std::string> licence_offences(const std::string& path, const std::string& text);

/// Missing and unexpected names at the top level. Dot-files and names that begin with "build" are ignored.
[[nodiscard]] std::vector<std::string> top_level_offences(const std::vector<std::string>& names);

struct SourceFile {
  std::string path;  // relative to the top of the source tree, with slashes
  std::string text;
};

/// Every *.hpp, *.cpp, *.sh, *.cmake and CMakeLists.txt, sorted, without dot-folders, build directories and
/// node_modules.
[[nodiscard]] std::vector<SourceFile> source_files(const std::filesystem::path& top);

}  // namespace carom::layout
