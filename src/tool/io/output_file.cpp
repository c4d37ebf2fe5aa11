// SPDX-License-Identifier: BSL-1.0
#include "io/output_file.hpp"

#include <cerrno>
#include <fstream>
#include <system_error>

#include <fmt/format.h>

#include <carom/subjects/protocol/shortage.hpp>

#include "io/usage_error.hpp"

namespace carom::tool {

void fail_to_write(const std::filesystem::path& path, int error) {
  throw UsageError(fmt::format("--out: {} cannot be written: {}", path.string(),
                               subjects::protocol::message_of({error, std::generic_category()})));
}

void write_file(const std::filesystem::path& path, const std::string& text) {
  errno = 0;
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) {
    fail_to_write(path, errno);
  }
}

void append_to_file(const std::string& option, const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary | std::ios::app);
  file << text;
  file.close();
  if (!file) {
    throw UsageError(
        fmt::format("{}: the file {} cannot be written; check the path and its permissions", option, path.string()));
  }
}

void require_writable(const std::string& option, const std::filesystem::path& path) {
  const bool existed = std::filesystem::exists(std::filesystem::symlink_status(path));
  append_to_file(option, path, "");
  if (!existed) {
    std::filesystem::remove(path);
  }
}

void make_directories(const std::filesystem::path& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) {
    std::error_code gone;
    (void)std::filesystem::current_path(gone);
    if (gone && directory.is_relative()) {
      throw UsageError(
          fmt::format("--out: the directory {} cannot be created: the working directory does not exist any more",
                      directory.string()));
    }
    throw UsageError(fmt::format("--out: the directory {} cannot be created: {}; choose another directory",
                                 directory.string(), subjects::protocol::message_of(error)));
  }
}

}  // namespace carom::tool
