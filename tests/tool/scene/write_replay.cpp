// SPDX-License-Identifier: BSL-1.0
// write_replay JSON HTML: writes the page of a replay, for browser_test.mjs. The exit status is 77 in a build without
// replays.
#include <exception>
#include <fstream>
#include <iostream>

#include <nlohmann/json.hpp>

#include "scene/replay_html.hpp"

int main(int count, char** arguments) try {
  if (count != 3) {
    return 2;
  }
  if (!carom::tool::has_replay()) {
    return 77;
  }
  std::ifstream input(arguments[1]);
  std::ofstream(arguments[2]) << carom::tool::replay_html("A fixture", nlohmann::json::parse(input));
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
