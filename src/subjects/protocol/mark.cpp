// SPDX-License-Identifier: BSL-1.0
#include <cstdint>
#include <fstream>
#include <random>

#include <fmt/format.h>

#include <carom/subjects/protocol/mark.hpp>

namespace carom::subjects::protocol {

const std::string& mark_of_children() {
  // The mark is an environment variable. Its name is random, so if a subject runs Carom, that Carom sets another
  // variable.
  static const std::string mark = [] {
    std::random_device source;
    std::string name = "CAROM_CHILD";
    for (int i = 0; i < 4; ++i) {
      name += fmt::format("_{:08x}", static_cast<std::uint32_t>(source()));
    }
    return name;
  }();
  return mark;
}

bool bears_mark_of_children(pid_t process) {
  std::ifstream environment(fmt::format("/proc/{}/environ", process), std::ios::binary);
  for (std::string entry; std::getline(environment, entry, '\0');) {
    if (entry.starts_with(mark_of_children() + '=')) {
      return true;
    }
  }
  return false;
}

}  // namespace carom::subjects::protocol
