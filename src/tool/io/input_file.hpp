// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include <carom/collision/expects.hpp>
#include <carom/collision/law.hpp>
#include <carom/properties/cases/family.hpp>

namespace carom::tool {

/// Whether the text has nothing but blanks and ends of lines.
[[nodiscard]] bool is_blank(std::string_view text);

/// A file of any kind, including a pipe or an endless device. Keeps only as many bytes as the caller asks for. All
/// errors are UsageErrors that name the file.
class BoundedInput {
 public:
  /// Throws if the file is a directory or cannot be opened.
  BoundedInput(std::string file, std::stop_token stop);
  ~BoundedInput();
  BoundedInput(const BoundedInput&) = delete;
  BoundedInput& operator=(const BoundedInput&) = delete;

  /// The reason why a read ended. The end of a line is consumed, but not added to the text.
  enum class End { line, file, limit };
  /// Appends to the text up to the end of the line, or until the text is longer than a line may be. Throws if the file
  /// cannot be read, or if a stop is requested while the function waits.
  [[nodiscard]] End add_line(std::string& text);

  /// Appends the rest of the file to the text. Throws as add_line does, or if the text is too large.
  void add_rest(std::string& text);

  struct Line {
    std::size_t number = 0;  // from 1
    std::string text = {};
  };
  /// The next line that is not blank; none at the end. Throws as add_line does, or if the line is too long.
  [[nodiscard]] std::optional<Line> next_line();

 private:
  /// Returns whether there is more to read. If there is, next_ < buffer_.size().
  [[nodiscard]] bool fill();

  std::string file_;
  std::stop_token stop_;
  int descriptor_ = -1;
  std::string buffer_;
  std::size_t next_ = 0;   // in the buffer
  std::size_t lines_ = 0;  // that were read
  bool has_ended_ = false;
};

/// A JSON file. It is JSON Lines, of any length, if its first non-blank line is a complete JSON text and another
/// non-blank line follows. Otherwise it is one JSON text. Errors are UsageErrors that name the file and, for JSON
/// Lines, the line.
class JsonFile {
 public:
  /// Reads until the form is known. Throws if the file cannot be read, or is a single text that is too large.
  explicit JsonFile(const std::string& file, const std::stop_token& stop = {});

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] bool is_lines() const { return is_lines_; }

  using Line = BoundedInput::Line;
  /// The next line that is not blank; none at the end. Throws if the line cannot be read or is too long. Precondition:
  /// is_lines().
  [[nodiscard]] std::optional<Line> next_line();

  /// Precondition: !is_lines().
  [[nodiscard]] const std::string& whole() const {
    CAROM_EXPECTS(!is_lines_, file_);
    return whole_;
  }

 private:
  std::string file_;
  BoundedInput input_;
  bool is_lines_ = false;
  std::deque<Line> read_;  // lines that were read ahead
  std::string whole_;
};

/// The whole content of a file. Throws UsageError that names the file if it cannot be read or is too large.
[[nodiscard]] std::string content_of_file(const std::string& file, const std::stop_token& stop = {});

/// The facts that a witness (a violation that can be replayed) adds to its collision.
struct WitnessFacts {
  std::string subject;  // as the command line names it
  std::string invariant;
  std::optional<Law> law = {};  // that the subject claims

  /// Whether the invariant is about invalid collisions.
  [[nodiscard]] bool is_of_invalid() const;
};

struct ReadCollision {
  std::string place;  // "FILE", "FILE:7" for a line, "FILE: element 3" for an element of an array
  properties::Case one;
  std::optional<WitnessFacts> witness;
  std::string contact_class = {};  // the field `class`; empty if there is none
};

/// Whether to keep a collision whose only defects are ε, μ or e_t out of range.
enum class OutOfRange { refused, kept };

/// The collision to read from a witness: the shrunk one, or the one that the family drew.
enum class OfWitness { shrunk, drawn };

/// Passes each collision of the file to `visit`, in order. The file is one witness or collision, an array of them, or
/// JSON Lines of them. Each line is visited before the next line is read. The field `class` of a collision, or of the
/// record that holds it, names the class of the contact. Throws UsageError that names the file, the place, and what was
/// expected. An invalid collision is an error, too, unless its witness is about invalid collisions. If `of_witness` is
/// `drawn`, every record must be a witness.
void for_each_collision(JsonFile& file, OutOfRange out_of_range, const std::function<void(const ReadCollision&)>& visit,
                        OfWitness of_witness = OfWitness::shrunk);

}  // namespace carom::tool
