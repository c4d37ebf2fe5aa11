// SPDX-License-Identifier: BSL-1.0
// Runs a target on files, and on the files of directories, in place of a fuzzing engine. Directories that are not there
// hold nothing.
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include "target.hpp"

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_of(const std::vector<std::string>& arguments) {
  std::vector<fs::path> files;
  for (const std::string& argument : arguments) {
    if (!fs::is_directory(argument)) {
      files.emplace_back(argument);
      continue;
    }
    std::vector<fs::path> inside(fs::directory_iterator(argument), fs::directory_iterator{});
    std::sort(inside.begin(), inside.end());
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

/// The exit status.
int replay(const std::vector<std::string>& arguments) {
  const std::vector<fs::path> files = files_of(arguments);
  for (const fs::path& file : files) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
      std::cerr << file << ": cannot be read\n";
      return 2;
    }
    // Before it is run: where that ends the process, it is the last line.
    std::cerr << file.string() << std::endl;
    const std::vector<char> bytes(std::istreambuf_iterator<char>(stream), {});
    (void)LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  }
  std::cerr << files.size() << " inputs replayed\n";
  return files.empty() ? 2 : 0;
}

}  // namespace

int main(int argc, char** argv) { return replay(std::vector<std::string>(argv + 1, argv + argc)); }
