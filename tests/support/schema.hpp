// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/program.hpp"

namespace carom::tests {

/// The files that the JSON schema accepts, in order. One process of python3-jsonschema reads all files, because its
/// start takes a second.
[[nodiscard]] inline std::vector<std::string> accepted_by(const std::string& schema, std::vector<std::string> files) {
  std::vector<std::string> arguments{"-W", "ignore", "-m", "jsonschema", "--output", "pretty"};
  for (const std::string& file : files) {
    arguments.insert(arguments.end(), {"-i", file});
  }
  arguments.push_back(schema);
  const RunResult result = run_program("/usr/bin/python3", arguments);
  std::erase_if(files, [&](const std::string& file) {
    const bool is_rejected = result.errors.find("===[ValidationError]===(" + file + ")===") != std::string::npos;
    const bool is_accepted = result.output.find("===[SUCCESS]===(" + file + ")===") != std::string::npos;
    EXPECT_NE(is_rejected, is_accepted) << file << ": " << result.errors;
    return is_rejected;
  });
  return files;
}

}  // namespace carom::tests
