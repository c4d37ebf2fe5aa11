// SPDX-License-Identifier: BSL-1.0
#include "io/output.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <random>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <carom/subjects/protocol/shortage.hpp>

#include "io/usage_error.hpp"

namespace carom::tool {

void fail_to_write(const std::filesystem::path& path, int error, const std::string& option) {
  throw UsageError(fmt::format("{}: {} cannot be written: {}", option, path.string(),
                               subjects::protocol::message_of({error, std::generic_category()})));
}

namespace {

[[noreturn]] void fail_to_print(int error) {
  const std::error_code code(error, std::generic_category());
  if (code == std::errc::broken_pipe) {
    throw std::system_error(code);
  }
  throw UsageError(fmt::format("standard output cannot be written: {}", code.message()));
}

}  // namespace

void write_file(const std::filesystem::path& path, const std::string& text, const std::string& option) {
  errno = 0;
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) {
    fail_to_write(path, errno, option);
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

void make_directories(const std::filesystem::path& directory, const std::string& option) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) {
    std::error_code gone;
    (void)std::filesystem::current_path(gone);
    if (gone && directory.is_relative()) {
      throw UsageError(
          fmt::format("{}: the directory {} cannot be created: the working directory does not exist any more", option,
                      directory.string()));
    }
    throw UsageError(fmt::format("{}: the directory {} cannot be created: {}; choose another directory", option,
                                 directory.string(), subjects::protocol::message_of(error)));
  }
}

namespace {

namespace fs = std::filesystem;

constexpr std::string_view stage_prefix = ".carom-stage-";
constexpr std::size_t stage_digits = 16;
constexpr const char* lock_name = ".carom-lock";
constexpr const char* npm_lock_name = ".carom-lock-npm";

std::string new_stage_name() {
  std::random_device random;
  return fmt::format("{}{:08x}{:08x}", stage_prefix, random(), random());
}

bool is_stage_name(const std::string& name) {
  return name.size() == stage_prefix.size() + stage_digits && name.starts_with(stage_prefix) &&
         name.find_first_not_of("0123456789abcdef", stage_prefix.size()) == std::string::npos;
}

bool is_own_directory(const fs::path& path) {
  struct stat facts {};
  return lstat(path.c_str(), &facts) == 0 && S_ISDIR(facts.st_mode) && facts.st_uid == geteuid();
}

/// Precondition: this process has the lock of the directory, so no stage in it is in use.
void remove_abandoned_stages(const fs::path& directory) {
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory, ignored)) {
    if (is_stage_name(entry.path().filename().string()) && is_own_directory(entry.path())) {
      fs::remove_all(entry.path(), ignored);
    }
  }
}

/// Whether the path still names the open file.
bool stands_at(int descriptor, const fs::path& path) {
  struct stat opened {};
  struct stat named {};
  return fstat(descriptor, &opened) == 0 && lstat(path.c_str(), &named) == 0 && opened.st_dev == named.st_dev &&
         opened.st_ino == named.st_ino;
}

[[noreturn]] void fail_as_locked(const fs::path& directory, const std::string& advice = "") {
  throw UsageError(
      fmt::format("--out: another run writes to the directory {}; wait until it ends, or choose another directory{}",
                  directory.string(), advice));
}

/// The lock file of the directory, open and locked; -1 if the file system has no locks. The file is empty. Throws
/// UsageError if another run holds the lock, or if the file is not empty and so not Carom's.
int locked_file(const fs::path& directory) {
  const fs::path path = directory / lock_name;
  constexpr mode_t as_umask_permits = 0666;
  for (;;) {
    const int file = open(path.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, as_umask_permits);
    if (file < 0) {
      fail_to_write(path, errno);
    }
    struct stat facts {};
    if (fstat(file, &facts) != 0 || !S_ISREG(facts.st_mode) || facts.st_size != 0) {
      close(file);
      throw UsageError(
          fmt::format("--out: {} is not Carom's; move it away, or choose another directory", path.string()));
    }
    if (flock(file, LOCK_EX | LOCK_NB) != 0) {
      const int error = errno;
      close(file);
      if (error == EWOULDBLOCK) {
        fail_as_locked(directory);
      }
      unlink(path.c_str());
      return -1;
    }
    if (stands_at(file, path)) {
      return file;
    }
    close(file);  // the run that ended removed the file before it was locked here
  }
}

void bring_to_disk(const fs::path& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) {
    fail_to_write(path, errno);
  }
  const int status = fsync(descriptor);
  const int error = errno;
  close(descriptor);
  // Some directories and special files cannot be flushed.
  if (status != 0 && error != EINVAL && error != ENOTSUP) {
    fail_to_write(path, error);
  }
}

/// The files of the stage, as paths relative to the stage.
std::vector<fs::path> files_below(const fs::path& stage) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(stage, error), end; !error && entry != end; entry.increment(error)) {
    if (!entry->is_directory()) {
      files.push_back(entry->path().lexically_relative(stage));
    }
  }
  if (error) {
    fail_to_write(stage, error.value());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Moves a file. If the file systems differ, first copies it to a temporary file beside `to`.
void move_file(const fs::path& from, const fs::path& to, const fs::path& stage_name) {
  if (std::rename(from.c_str(), to.c_str()) == 0) {
    return;
  }
  if (errno != EXDEV) {
    fail_to_write(to, errno);
  }
  const fs::path beside = to.parent_path() / stage_name;
  std::error_code error;
  fs::copy_file(from, beside, fs::copy_options::overwrite_existing, error);
  if (!error) {
    bring_to_disk(beside);
    fs::rename(beside, to, error);
  }
  if (error) {
    std::error_code ignored;
    fs::remove(beside, ignored);
    fail_to_write(to, error.value());
  }
}

}  // namespace

StagedOutput::StagedOutput(fs::path directory) : directory_(std::move(directory)) {
  make_directories(directory_);
  lock_ = locked_file(directory_);
  // The npm package, too, makes its own lock before it looks for this one. So one of two runs at once sees the other.
  if (const fs::path lock = directory_ / npm_lock_name; fs::exists(fs::symlink_status(lock))) {
    release_lock();
    fail_as_locked(directory_, fmt::format(". If there is no such run, remove {}", lock.string()));
  }
  if (lock_ >= 0) {
    remove_abandoned_stages(directory_);
  }
  stage_ = directory_ / new_stage_name();
  if (mkdir(stage_.c_str(), S_IRWXU) != 0) {
    const int error = errno;
    release_lock();
    throw UsageError(fmt::format("--out: the directory {} cannot be created: {}; choose another directory",
                                 stage_.string(), subjects::protocol::message_of({error, std::generic_category()})));
  }
}

StagedOutput::~StagedOutput() {
  std::error_code ignored;
  fs::remove_all(stage_, ignored);
  release_lock();
}

void StagedOutput::release_lock() const {
  if (lock_ >= 0) {
    unlink((directory_ / lock_name).c_str());  // before the lock ends, so that the file is nobody else's lock
    close(lock_);
  }
}

void StagedOutput::put_in_place(const std::string& last) {
  std::vector<fs::path> files = files_below(stage_);
  std::stable_partition(files.begin(), files.end(), [&](const fs::path& file) { return file != last; });
  std::vector<fs::path> folders{directory_};
  for (const fs::path& file : files) {
    const fs::path place = directory_ / file;
    if (fs::is_directory(place)) {
      fail_to_write(place, EISDIR);
    }
    bring_to_disk(stage_ / file);
    if (std::find(folders.begin(), folders.end(), place.parent_path()) == folders.end()) {
      make_directories(place.parent_path());
      folders.push_back(place.parent_path());
    }
  }
  for (const fs::path& file : files) {
    if (file == last) {
      std::for_each(folders.begin(), folders.end(), bring_to_disk);
    }
    move_file(stage_ / file, directory_ / file, stage_.filename());
  }
  bring_to_disk(directory_);
}

void write_output(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) {
    fail_to_print(errno);
  }
  flush_output();
}

void flush_output() {
  if (std::fflush(stdout) != 0) {
    fail_to_print(errno);
  }
}

std::function<void(std::uint64_t, std::uint64_t)> progress_line(std::string what) {
  if (isatty(STDERR_FILENO) == 0) {
    return {};
  }
  return [what = std::move(what), shown = std::uint64_t{101}](std::uint64_t done, std::uint64_t all) mutable {
    const std::uint64_t percent = 100 * done / all;
    if (percent != shown) {
      shown = percent;
      std::fputs(fmt::format("\r{} of {} {}, {} %{}", done, all, what, percent, done == all ? "\n" : "").c_str(),
                 stderr);
      std::fflush(stderr);
    }
  };
}

}  // namespace carom::tool
