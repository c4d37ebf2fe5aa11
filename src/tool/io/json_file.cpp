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

constexpr std::size_t mebibyte = std::size_t{1} << 20;
constexpr std::size_t longest_line = 16 * mebibyte;    // of JSON Lines [bytes]
constexpr std::size_t largest_whole = 256 * mebibyte;  // of a file that is read as a whole [bytes]
constexpr std::size_t buffer_size = std::size_t{1} << 16;
constexpr int glance = 50;  // interval between checks for a request to stop [ms]

[[noreturn]] void fail_to_read(const std::string& file, int error) {
  throw UsageError(fmt::format("{}: the file cannot be read: {}", file,
                               subjects::protocol::message_of({error, std::generic_category()})));
}

bool is_blank(const std::string& line) { return line.find_first_not_of(" \t\r") == std::string::npos; }

/// The reason why a read ended. The end of a line is consumed, but not added to the text.
enum class End { line, file, limit };

}  // namespace

/// A file of any kind, including a pipe or an endless device. Keeps only as many bytes as the caller asks for. All
/// errors are UsageErrors that name the file.
class BoundedInput {
 public:
  /// Throws if the file is a directory or cannot be opened.
  BoundedInput(std::string file, std::stop_token stop) : file_(std::move(file)), stop_(std::move(stop)) {
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
  ~BoundedInput() { close(descriptor_); }
  BoundedInput(const BoundedInput&) = delete;
  BoundedInput& operator=(const BoundedInput&) = delete;

  /// Appends to the text up to the end of the line, or until the text is longer than a line may be. Throws if the file
  /// cannot be read, or if a stop is requested while the function waits.
  End add_line(std::string& text) {
    while (fill()) {
      const std::size_t line_end = std::min(buffer_.find('\n', next_), buffer_.size());
      text.append(buffer_, next_, line_end - next_);
      const bool has_ended = line_end < buffer_.size();
      next_ = line_end + (has_ended ? 1 : 0);
      if (text.size() > longest_line) {
        return End::limit;
      }
      if (has_ended) {
        return End::line;
      }
    }
    return End::file;
  }

  /// Appends the rest of the file to the text. Throws as add_line does, or if the text is too large.
  void add_rest(std::string& text) {
    while (fill()) {
      text.append(buffer_, next_);
      next_ = buffer_.size();
      if (text.size() > largest_whole) {
        throw UsageError(
            fmt::format("{}: the file is larger than {} MiB; write it as JSON Lines", file_, largest_whole / mebibyte));
      }
    }
  }

 private:
  /// Returns whether there is more to read. If there is, next_ < buffer_.size().
  bool fill() {
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

  std::string file_;
  std::stop_token stop_;
  int descriptor_ = -1;
  std::string buffer_;
  std::size_t next_ = 0;  // in the buffer
};

JsonFile::JsonFile(const std::string& file, const std::stop_token& stop)
    : file_(file), input_(std::make_unique<BoundedInput>(file, stop)) {
  std::string line;
  End end = End::line;
  while (end == End::line && is_blank(line) && whole_.size() <= longest_line) {
    whole_ += number_ > 0 ? line + '\n' : "";
    line.clear();
    ++number_;
    end = input_->add_line(line);
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
  input_->add_rest(whole_);
}

JsonFile::~JsonFile() = default;

std::optional<JsonFile::Line> JsonFile::next_line_of_input() {
  while (!has_ended_) {
    Line line{++number_, {}};
    const End end = input_->add_line(line.text);
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
  input.add_rest(text);
  return text;
}

}  // namespace carom::tool
