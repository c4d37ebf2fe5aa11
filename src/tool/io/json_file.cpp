// SPDX-License-Identifier: BSL-1.0
#include "io/json_file.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <carom/collision/expects.hpp>
#include <carom/subjects/protocol/shortage.hpp>

#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

using End = BoundedInput::End;

constexpr std::size_t buffer_size = std::size_t{1} << 16;
constexpr int glance = 50;  // interval between checks for a request to stop [ms]

[[noreturn]] void fail_to_read(const std::string& file, int error) {
  throw UsageError(fmt::format("{}: the file cannot be read: {}", file,
                               subjects::protocol::message_of({error, std::generic_category()})));
}

constexpr std::size_t mebibyte = std::size_t{1} << 20;

bool is_blank(const std::string& line) { return line.find_first_not_of(" \t\r") == std::string::npos; }

void add_rest(BoundedInput& input, std::string& text, const std::string& file) {
  if (input.add_all(text, largest_whole) == End::limit) {
    throw UsageError(
        fmt::format("{}: the file is larger than {} MiB; write it as JSON Lines", file, largest_whole / mebibyte));
  }
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

JsonFile::JsonFile(const std::string& file, const std::stop_token& stop) : file_(file), input_(file, stop) {
  std::string line;
  End end = End::line;
  while (end == End::line && is_blank(line) && whole_.size() <= longest_line) {
    whole_ += number_ > 0 ? line + '\n' : "";
    line.clear();
    ++number_;
    end = input_.add_line(line, longest_line);
  }
  if (end == End::line && !is_blank(line) && nlohmann::json::accept(line)) {
    read_.push_back({number_, line});
    if (std::optional<Line> second = next_line_of_input()) {
      read_.push_back(std::move(*second));
      is_lines_ = true;
      whole_.clear();
      return;
    }
    read_.clear();
  }
  whole_ += line + (end == End::line ? "\n" : "");
  add_rest(input_, whole_, file);
}

std::optional<JsonFile::Line> JsonFile::next_line_of_input() {
  while (!has_ended_) {
    Line line{++number_, {}};
    const End end = input_.add_line(line.text, longest_line);
    if (end == End::limit) {
      throw UsageError(fmt::format("{}:{}: the line is longer than {} MiB; write one collision per line", file_,
                                   line.number, longest_line / mebibyte));
    }
    has_ended_ = end == End::file;
    if (!is_blank(line.text)) {
      return line;
    }
  }
  return std::nullopt;
}

std::optional<JsonFile::Line> JsonFile::next_line() {
  CAROM_EXPECTS(is_lines_, file_);
  if (read_.empty()) {
    return next_line_of_input();
  }
  Line line = std::move(read_.front());
  read_.pop_front();
  return line;
}

std::string content_of_file(const std::string& file, const std::stop_token& stop) {
  BoundedInput input(file, stop);
  std::string text;
  add_rest(input, text, file);
  return text;
}

}  // namespace carom::tool
