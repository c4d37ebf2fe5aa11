// SPDX-License-Identifier: BSL-1.0
#include "io/bounded_input.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <carom/subjects/protocol/shortage.hpp>

#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 16;
constexpr int glance = 50;  // interval between checks for a request to stop [ms]

[[noreturn]] void fail_to_read(const std::string& file, int error) {
  throw UsageError(fmt::format("{}: the file cannot be read: {}", file,
                               subjects::protocol::message_of({error, std::generic_category()})));
}

}  // namespace

BoundedInput::BoundedInput(std::string file, std::stop_token stop) : file_(std::move(file)), stop_(std::move(stop)) {
  // O_NONBLOCK lets a stop end the wait for a pipe that no process has opened for writing.
  descriptor_ = open(file_.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (descriptor_ < 0) {
    if (errno == ENOENT) {
      throw UsageError(fmt::format("{}: this file does not exist; check the path", file_));
    }
    fail_to_read(file_, errno);
  }
  struct stat facts {};
  if (fstat(descriptor_, &facts) == 0 && S_ISDIR(facts.st_mode)) {
    close(descriptor_);
    throw UsageError(fmt::format("{}: expected a file, found a directory", file_));
  }
}

BoundedInput::~BoundedInput() { close(descriptor_); }

bool BoundedInput::fill() {
  if (next_ < buffer_.size()) {
    return true;
  }
  next_ = 0;
  buffer_.resize(buffer_size);
  for (;;) {
    if (stop_.stop_requested()) {
      buffer_.clear();
      throw UsageError(fmt::format("{}: the user stopped the program before the end of the file", file_));
    }
    pollfd waited{descriptor_, POLLIN, 0};
    if (poll(&waited, 1, glance) == 0) {
      continue;
    }
    const ssize_t count = read(descriptor_, buffer_.data(), buffer_.size());
    if (count >= 0) {
      buffer_.resize(static_cast<std::size_t>(count));
      return count > 0;
    }
    if (errno != EAGAIN && errno != EINTR) {
      buffer_.clear();
      fail_to_read(file_, errno);
    }
  }
}

BoundedInput::End BoundedInput::add_line(std::string& text, std::size_t most_bytes) {
  while (fill()) {
    const std::size_t line_end = std::min(buffer_.find('\n', next_), buffer_.size());
    text.append(buffer_, next_, line_end - next_);
    const bool has_ended = line_end < buffer_.size();
    next_ = line_end + (has_ended ? 1 : 0);
    if (text.size() > most_bytes) {
      return End::limit;
    }
    if (has_ended) {
      return End::line;
    }
  }
  return End::file;
}

BoundedInput::End BoundedInput::add_all(std::string& text, std::size_t most_bytes) {
  while (fill()) {
    text.append(buffer_, next_);
    next_ = buffer_.size();
    if (text.size() > most_bytes) {
      return End::limit;
    }
  }
  return End::file;
}

}  // namespace carom::tool
