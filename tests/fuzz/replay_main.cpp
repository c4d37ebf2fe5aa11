// SPDX-License-Identifier: BSL-1.0
//  fuzz_replay TARGET FILE…
// Runs a target on files and on the files of directories. A missing directory counts as empty.
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "target.hpp"

// Each target's function has its own name here, replay_TARGET. CMake lists the targets.
#define TARGET(name) extern "C" int replay_##name(const std::uint8_t* data, std::size_t size);
CAROM_FUZZ_TARGETS
#undef TARGET

namespace {

using Target = int (*)(const std::uint8_t*, std::size_t);

const std::map<std::string, Target> targets{
#define TARGET(name) {#name, &replay_##name},
    CAROM_FUZZ_TARGETS
#undef TARGET
};

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

int replay(Target target, const std::vector<std::string>& arguments) {
  const std::vector<fs::path> files = files_of(arguments);
  for (const fs::path& file : files) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
      std::cerr << file << ": cannot be read\n";
      return 2;
    }
    // If the process ends in the target, this is the last line.
    std::cerr << file.string() << std::endl;
    const std::vector<char> bytes(std::istreambuf_iterator<char>(stream), {});
    (void)target(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  }
  std::cerr << files.size() << " inputs replayed\n";
  return files.empty() ? 2 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  const auto target = targets.find(argc > 1 ? argv[1] : "");
  if (target == targets.end()) {
    std::cerr << "fuzz_replay TARGET FILE…\n";
    return 2;
  }
  return replay(target->second, std::vector<std::string>(argv + 2, argv + argc));
}
