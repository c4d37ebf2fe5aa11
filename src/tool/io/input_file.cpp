// SPDX-License-Identifier: BSL-1.0
#include "io/input_file.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <carom/collision/expects.hpp>
#include <carom/collision/json/json.hpp>
#include <carom/collision/json/text.hpp>
#include <carom/collision/validate.hpp>
#include <carom/properties/gate/by_name.hpp>
#include <carom/properties/invariants/invariant.hpp>
#include <carom/properties/plan/lint.hpp>
#include <carom/report/results/archive.hpp>
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

using nlohmann::json;

/// The longest message about a record [bytes]. A record may have megabytes.
constexpr std::size_t longest_complaint = 4000;

[[noreturn]] void fail(const std::string& place, const std::string& what) {
  throw UsageError(fmt::format("{}: {}", place, carom::printable_line(what, longest_complaint)));
}

json parsed(const std::string& text, const std::string& place) {
  try {
    return parse_json(text);
  } catch (const FormatError& error) {
    fail(place, error.what());
  }
}

/// Throws FormatError that names the place.
WitnessFacts witness_facts(const report::Field& record) {
  WitnessFacts facts;
  if (const auto invariant = record.find("invariant")) {
    facts.invariant = invariant->text();
    if (properties::invariant_named(facts.invariant) == nullptr) {
      std::vector<std::string> known;
      for (const properties::Invariant& one : properties::all_invariants()) {
        known.emplace_back(one.name);
      }
      throw FormatError(invariant->place(), fmt::format("there is no invariant '{}'{}", facts.invariant,
                                                        properties::did_you_mean(facts.invariant, known)));
    }
  }
  if (const auto subject = record.find("subject")) {
    facts.subject = subject->at("name").text();
    if (const auto specification = subject->find("specification")) {
      facts.subject = specification->text();
    }
    if (const auto model = subject->find("model")) {
      facts.law = law_named(model->text());
      if (!facts.law) {
        std::vector<std::string_view> known;
        for (const Law law : all_laws) {
          known.push_back(name_of(law));
        }
        throw FormatError(model->place(), fmt::format("there is no law '{}'; expected one of {}", model->text(),
                                                      fmt::join(known, ", ")));
      }
    }
  }
  return facts;
}

/// The collision of a record that is itself a collision, without the field `class`.
Collision bare_collision(json record) {
  if (record.is_object()) {
    record.erase("class");
  }
  return collision_from_json(record);
}

ReadCollision read_record(const json& record, const std::string& place, OutOfRange out_of_range, OfWitness of_witness) {
  ReadCollision read{place, {}, std::nullopt};
  const bool is_wrapped = record.is_object() && record.contains("collision");
  const std::string field = of_witness == OfWitness::drawn ? "drawn" : "collision";
  if (of_witness == OfWitness::drawn && !(is_wrapped && record.contains(field))) {
    fail(place, "/drawn: is missing; only a witness of carom gate has this field, so use --drawn with a witness");
  }
  try {
    const report::Field fields(record);
    if (const auto contact_class = record.is_object() ? fields.find("class") : std::nullopt) {
      read.contact_class = contact_class->text();
    }
    read.one.collision = is_wrapped ? collision_from_json(record.at(field), '/' + field) : bare_collision(record);
    if (is_wrapped && (record.contains("invariant") || record.contains("subject"))) {
      read.witness = witness_facts(fields);
    }
    if (const auto convex_uniform = is_wrapped ? fields.find("convex_uniform") : std::nullopt) {
      read.one.convex_uniform = convex_uniform->flag();
    }
  } catch (const FormatError& error) {
    fail(place, error.what());
  }
  const bool is_kept = out_of_range == OutOfRange::kept && properties::plan::is_out_of_range(read.one.collision);
  const bool may_be_invalid = is_kept || (read.witness && read.witness->is_of_invalid());
  const std::vector<InputError> errors = validate(read.one.collision);
  if (!errors.empty() && !may_be_invalid) {
    fail(place, describe(errors));
  }
  return read;
}

}  // namespace

bool is_blank(std::string_view text) { return text.find_first_not_of(" \t\r\n") == std::string_view::npos; }

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

BoundedInput::End BoundedInput::add_line(std::string& text) {
  ++lines_;
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

void BoundedInput::add_rest(std::string& text) {
  while (fill()) {
    text.append(buffer_, next_);
    next_ = buffer_.size();
    if (text.size() > largest_whole) {
      throw UsageError(
          fmt::format("{}: the file is larger than {} MiB; write it as JSON Lines", file_, largest_whole / mebibyte));
    }
  }
}

std::optional<BoundedInput::Line> BoundedInput::next_line() {
  while (!has_ended_) {
    Line line;
    const End end = add_line(line.text);
    line.number = lines_;
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

JsonFile::JsonFile(const std::string& file, const std::stop_token& stop) : file_(file), input_(file, stop) {
  using End = BoundedInput::End;
  std::string line;
  std::size_t number = 0;
  End end = End::line;
  while (end == End::line && is_blank(line) && whole_.size() <= longest_line) {
    whole_ += number > 0 ? line + '\n' : "";
    line.clear();
    ++number;
    end = input_.add_line(line);
  }
  if (end == End::line && !is_blank(line) && nlohmann::json::accept(line)) {
    read_.push_back({number, line});
    if (std::optional<Line> second = input_.next_line()) {
      read_.push_back(std::move(*second));
      is_lines_ = true;
      whole_.clear();
      return;
    }
    read_.clear();
  }
  whole_ += line + (end == End::line ? "\n" : "");
  input_.add_rest(whole_);
}

std::optional<JsonFile::Line> JsonFile::next_line() {
  CAROM_EXPECTS(is_lines_, file_);
  if (read_.empty()) {
    return input_.next_line();
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

bool WitnessFacts::is_of_invalid() const {
  const properties::Invariant* const known = properties::invariant_named(invariant);
  return known != nullptr && known->is_of_invalid();
}

void for_each_collision(JsonFile& file, OutOfRange out_of_range, const std::function<void(const ReadCollision&)>& visit,
                        OfWitness of_witness) {
  if (file.is_lines()) {
    while (const std::optional<JsonFile::Line> line = file.next_line()) {
      const std::string place = fmt::format("{}:{}", file.file(), line->number);
      visit(read_record(parsed(line->text, place), place, out_of_range, of_witness));
    }
    return;
  }
  if (file.whole().find_first_not_of(" \t\r\n") == std::string::npos) {
    fail(file.file(), "the file is empty; expected a collision");
  }
  const json whole = parsed(file.whole(), file.file());
  if (!whole.is_array()) {
    visit(read_record(whole, file.file(), out_of_range, of_witness));
    return;
  }
  if (whole.empty()) {
    fail(file.file(), "the array is empty; expected at least one collision");
  }
  for (std::size_t i = 0; i < whole.size(); ++i) {
    visit(read_record(whole[i], fmt::format("{}: element {}", file.file(), i), out_of_range, of_witness));
  }
}

}  // namespace carom::tool
