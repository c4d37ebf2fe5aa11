// SPDX-License-Identifier: BSL-1.0
#include "io/staged_output.hpp"

#include <algorithm>
#include <cerrno>
#include <random>
#include <string_view>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/output_file.hpp"
#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view stage_prefix = ".carom-stage-";
constexpr std::size_t stage_digits = 16;

std::string new_stage_name() {
  std::random_device random;
  return fmt::format("{}{:08x}{:08x}", stage_prefix, random(), random());
}

bool is_stage_name(const std::string& name) {
  return name.size() == stage_prefix.size() + stage_digits && name.starts_with(stage_prefix) &&
         name.find_first_not_of("0123456789abcdef", stage_prefix.size()) == std::string::npos;
}

/// Opens the directory, but no symbolic link; -1 if it cannot be opened.
int opened_directory(const fs::path& path) {
  return open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

/// Whether the path still names the open directory.
bool stands_at(int descriptor, const fs::path& path) {
  struct stat opened {};
  struct stat named {};
  return fstat(descriptor, &opened) == 0 && lstat(path.c_str(), &named) == 0 && opened.st_dev == named.st_dev &&
         opened.st_ino == named.st_ino;
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
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(stage)) {
    if (!entry.is_directory()) {
      files.push_back(entry.path().lexically_relative(stage));
    }
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

/// An abandoned stage. The lock keeps other processes from treating it as abandoned.
class LockedStage {
 public:
  explicit LockedStage(const fs::path& path) : descriptor_(opened_directory(path)) {
    struct stat facts {};
    is_abandoned_ = descriptor_ >= 0 && fstat(descriptor_, &facts) == 0 && facts.st_uid == geteuid() &&
                    flock(descriptor_, LOCK_EX | LOCK_NB) == 0;
  }
  ~LockedStage() {
    if (descriptor_ >= 0) {
      close(descriptor_);
    }
  }
  LockedStage(const LockedStage&) = delete;
  LockedStage& operator=(const LockedStage&) = delete;

  [[nodiscard]] bool is_abandoned() const { return is_abandoned_; }

 private:
  int descriptor_;
  bool is_abandoned_ = false;
};

}  // namespace

StagedOutput::StagedOutput(fs::path directory) : directory_(std::move(directory)) {
  make_directories(directory_);
  // Until the stage is locked, another process may remove it as abandoned.
  constexpr int most_tries = 100;
  for (int tries = 0; tries < most_tries; ++tries) {
    stage_ = directory_ / new_stage_name();
    if (mkdir(stage_.c_str(), S_IRWXU) != 0) {
      throw UsageError(fmt::format("--out: the directory {} cannot be created: {}; choose another directory",
                                   stage_.string(), std::generic_category().message(errno)));
    }
    lock_ = opened_directory(stage_);
    if (lock_ < 0) {
      continue;
    }
    // If the file system has no locks, no process treats a stage as abandoned.
    if ((flock(lock_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) && stands_at(lock_, stage_)) {
      return;
    }
    close(lock_);
  }
  throw UsageError(fmt::format("--out: the directory {} cannot be created; choose another directory", stage_.string()));
}

StagedOutput::~StagedOutput() {
  std::error_code ignored;
  fs::remove_all(stage_, ignored);
  close(lock_);
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

std::vector<fs::path> abandoned_stages(const fs::path& directory) {
  std::vector<fs::path> stages;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory, ignored)) {
    if (is_stage_name(entry.path().filename().string()) && LockedStage(entry.path()).is_abandoned()) {
      stages.push_back(entry.path());
    }
  }
  return stages;
}

void remove_abandoned_stages(const fs::path& directory) {
  for (const fs::path& stage : abandoned_stages(directory)) {
    if (const LockedStage locked(stage); locked.is_abandoned()) {
      std::error_code ignored;
      fs::remove_all(stage, ignored);
    }
  }
}

}  // namespace carom::tool
