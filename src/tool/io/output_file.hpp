// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <filesystem>
#include <string>

namespace carom::tool {

/// Throws the UsageError that says so of a file, with the reason that the system gives as errno.
[[noreturn]] void fail_to_write(const std::filesystem::path& path, int error);

/// Writes the text as the whole file. Throws UsageError, which names the file, where that cannot be done.
void write_file(const std::filesystem::path& path, const std::string& text);

/// Adds the text to the file's end; with no text it only shows that this can be done. Throws UsageError, which names
/// the option that the file was named by, where it cannot.
void append_to_file(const std::string& option, const std::filesystem::path& path, const std::string& text);

/// Makes the directory that --out names, or one below it, with its parents. Throws UsageError where that cannot be
/// done.
void make_directories(const std::filesystem::path& directory);

}  // namespace carom::tool
