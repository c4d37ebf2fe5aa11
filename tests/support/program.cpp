// SPDX-License-Identifier: BSL-1.0
#include "program.hpp"

#include <atomic>
#include <fstream>
#include <sstream>

#include <boost/process/args.hpp>
#include <boost/process/child.hpp>
#include <boost/process/exe.hpp>
#include <boost/process/io.hpp>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "expect_in.hpp"

namespace carom::tests {

std::string carom_program() { return CAROM_PROGRAM; }

RunResult run_carom(std::vector<std::string> arguments, const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_program(CAROM_PROGRAM, arguments);
}

RunResult run_program(const std::string& program, const std::vector<std::string>& arguments) {
  namespace bp = boost::process;
  const TemporaryDirectory scratch;
  const std::filesystem::path output = scratch.path() / "output";
  const std::filesystem::path errors = scratch.path() / "errors";
  bp::child child(bp::exe = program, bp::args = arguments, bp::std_in<bp::null, bp::std_out> output.string(),
                  bp::std_err > errors.string());
  child.wait();
  return {child.exit_code(), content_of(output), content_of(errors)};
}

void expect_error(const RunResult& run, const std::vector<std::string>& parts) {
  EXPECT_EQ(run.exit_status, 2) << run.output;
  unit::expect_in(run.errors, parts);
}

std::vector<std::string> accepted_by(const std::string& schema, std::vector<std::string> files) {
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

pid_t start_carom(const std::vector<std::string>& arguments) {
  namespace bp = boost::process;
  bp::child child(bp::exe = CAROM_PROGRAM, bp::args = arguments, bp::std_in<bp::null, bp::std_out> bp::null,
                  bp::std_err > bp::null);
  const pid_t process = child.id();
  child.detach();
  return process;
}

int wait_for(pid_t process) {
  int status = 0;
  waitpid(process, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TemporaryDirectory::TemporaryDirectory() {
  static std::atomic<int> count = 0;
  path_ = std::filesystem::temp_directory_path() /
          ("carom-test-" + std::to_string(getpid()) + '-' + std::to_string(count++));
  std::filesystem::create_directories(path_);
}

TemporaryDirectory::~TemporaryDirectory() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string TemporaryDirectory::write(const std::string& name, const std::string& text) const {
  const std::filesystem::path file = path_ / name;
  std::ofstream(file, std::ios::binary) << text;
  return file.string();
}

std::string content_of(const std::filesystem::path& file) {
  const std::ifstream stream(file, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  return content.str();
}

}  // namespace carom::tests
