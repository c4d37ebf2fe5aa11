// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <filesystem>
#include <string>

namespace carom::tool {

/// Throws the UsageError for a file that cannot be written. `error` is an errno.
[[noreturn]] void fail_to_write(const std::filesystem::path& path, int error);

/// Writes the text as the whole file. Throws UsageError that names the file if the file cannot be written.
void write_file(const std::filesystem::path& path, const std::string& text);

/// Appends the text to the file. An empty text only checks that appending is possible. Throws UsageError that names the
/// file's option if appending is not possible.
void append_to_file(const std::string& option, const std::filesystem::path& path, const std::string& text);

/// Leaves the path as it is. Throws UsageError, which names the option, if the file cannot be written.
void require_writable(const std::string& option, const std::filesystem::path& path);

/// Makes a directory that is --out or below it, with its parents. Throws UsageError if it cannot be made.
void make_directories(const std::filesystem::path& directory);

}  // namespace carom::tool
