// SPDX-License-Identifier: BSL-1.0
#include "io/staged_output.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <random>
#include <regex>
#include <string_view>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <carom/subjects/protocol/shortage.hpp>

#include "io/output_file.hpp"
#include "io/usage_error.hpp"

namespace carom::tool {
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

/// Whether the path still names the open file.
bool stands_at(int descriptor, const fs::path& path) {
  struct stat opened {};
  struct stat named {};
  return fstat(descriptor, &opened) == 0 && lstat(path.c_str(), &named) == 0 && opened.st_dev == named.st_dev &&
         opened.st_ino == named.st_ino;
}

/// The text of the open file; empty if the file is too long for a lock, or cannot be read.
std::string short_text_of(int file) {
  std::array<char, 1024> text{};
  const ssize_t length = pread(file, text.data(), text.size(), 0);
  return length < 0 || length == ssize_t{text.size()} ? std::string() : std::string(text.data(), length);
}

std::string this_host() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

/// The text of a lock: the process that holds it, a mark of its own, and its machine.
const std::regex& lock_text() {
  static const std::regex text(R"((\d{1,9}) \S+ (.*)\n)");
  return text;
}

/// Whether the run that wrote the text of a lock was killed. The answer is no if it ran on another machine.
bool is_dead(const std::string& text) {
  std::smatch parts;
  return std::regex_match(text, parts, lock_text()) && parts[2] == this_host() && kill(std::stoi(parts[1]), 0) != 0 &&
         errno == ESRCH;
}

/// Whether the open file may be a lock of this program: it is empty, or names a run.
bool may_be_lock(int descriptor) {
  struct stat facts {};
  return fstat(descriptor, &facts) == 0 && S_ISREG(facts.st_mode) &&
         (facts.st_size == 0 || std::regex_match(short_text_of(descriptor), lock_text()));
}

/// Writes this process into the lock, where the npm package finds it. On a full disk, the lock stays empty, and the npm
/// package takes it for that of a living run.
bool name_this_process(int lock) {
  const std::string text = fmt::format("{} native {}\n", getpid(), this_host());
  return ftruncate(lock, 0) == 0 &&
         (pwrite(lock, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size()) || ftruncate(lock, 0) == 0);
}

/// Whether a run of the npm package may write to the directory. Each of the two programs makes its own lock before it
/// looks for the other's, so one of two runs at once sees the other.
bool is_locked_by_npm(const fs::path& directory) {
  const int lock = open((directory / npm_lock_name).c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (lock < 0) {
    return errno != ENOENT;
  }
  const std::string text = short_text_of(lock);
  close(lock);
  return !is_dead(text);
}

[[noreturn]] void fail_as_locked(const fs::path& directory, const std::string& advice = "") {
  throw UsageError(
      fmt::format("--out: another run writes to the directory {}; wait until it ends, or choose another directory{}",
                  directory.string(), advice));
}

/// The lock file of the directory, open and locked; -1 if the file system has no locks. Throws UsageError if another
/// run holds the lock.
int locked_file(const fs::path& directory) {
  const fs::path path = directory / lock_name;
  constexpr mode_t as_umask_permits = 0666;
  for (;;) {
    const int file = open(path.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, as_umask_permits);
    if (file < 0) {
      fail_to_write(path, errno);
    }
    if (!may_be_lock(file)) {
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
      if (!name_this_process(file)) {
        const int error = errno;
        close(file);
        fail_to_write(path, error);
      }
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

bool is_own_directory(const fs::path& path) {
  struct stat facts {};
  return lstat(path.c_str(), &facts) == 0 && S_ISDIR(facts.st_mode) && facts.st_uid == geteuid();
}

}  // namespace

StagedOutput::StagedOutput(fs::path directory) : directory_(std::move(directory)) {
  make_directories(directory_);
  lock_ = locked_file(directory_);
  if (is_locked_by_npm(directory_)) {
    release_lock();
    fail_as_locked(directory_,
                   fmt::format(". If there is no such run, remove {}", (directory_ / npm_lock_name).string()));
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

std::vector<fs::path> StagedOutput::abandoned_stages() const {
  std::vector<fs::path> stages;
  if (lock_ < 0) {
    return stages;  // other runs may be alive
  }
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory_, ignored)) {
    const fs::path& path = entry.path();
    if (is_stage_name(path.filename().string()) && path.filename() != stage_.filename() && is_own_directory(path)) {
      stages.push_back(path);
    }
  }
  return stages;
}

void StagedOutput::remove_abandoned_stages() const {
  for (const fs::path& stage : abandoned_stages()) {
    std::error_code ignored;
    fs::remove_all(stage, ignored);
  }
}

}  // namespace carom::tool
