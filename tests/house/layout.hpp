// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// What the house of the design permits: which folder may include what, what stands at the top, which licence a file
/// has.
namespace carom::layout {

/// The offences of one source file, "src/impulse/x.hpp: includes <CGAL/Gmpq.h>". The path is relative to the top, with
/// slashes. Files in folders without a rule have none.
[[nodiscard]] std::vector<std::string> include_offences(const std::string& path, const std::string& text);

/// Whether the file must name a licence and does not name the right one at its beginning.
[[nodiscard]] std::vector<std::string> licence_offences(const std::string& path, const std::string& text);

/// What is missing at the top, and what should not be there. Dot-files and names that begin with "build" are nobody's
/// business.
[[nodiscard]] std::vector<std::string> top_level_offences(const std::vector<std::string>& names);

struct SourceFile {
  std::string path;  // relative to the top, with slashes
  std::string text;
};

/// Every *.hpp, *.cpp, *.sh, *.cmake and CMakeLists.txt of the tree, sorted, without dot-folders, build directories and
/// node_modules.
[[nodiscard]] std::vector<SourceFile> source_files(const std::filesystem::path& top);

}  // namespace carom::layout
