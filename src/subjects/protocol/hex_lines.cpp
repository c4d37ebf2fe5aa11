// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <iterator>
#include <optional>
#include <span>

#include <fmt/format.h>

#include <carom/collision/doubles.hpp>
#include <carom/collision/json/json.hpp>
#include <carom/collision/json/text.hpp>
#include <carom/subjects/protocol/hex_lines.hpp>
#include <carom/subjects/protocol/messages.hpp>

namespace carom::subjects::protocol {
namespace {

constexpr std::size_t digits_of_a_number = 16;
constexpr std::size_t width = 1 + digits_of_a_number;  // of a space and a number

void add_numbers(std::string& text, std::span<const double> numbers) {
  for (const double number : numbers) {
    fmt::format_to(std::back_inserter(text), " {:016x}", std::bit_cast<std::uint64_t>(number));
  }
}

/// Reads a number from 16 digits. Returns false if the word has another form.
bool read_number(std::string_view word, double& number) {
  std::uint64_t bits = 0;
  const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), bits, 16);
  number = std::bit_cast<double>(bits);
  return word.size() == digits_of_a_number && failure == std::errc() && end == word.data() + word.size();
}

/// Reads numbers of this form: a space and 16 digits each. Returns false if the text has another form.
bool read_numbers(std::string_view text, std::span<double> numbers) {
  bool is_right = text.size() == width * numbers.size();
  for (std::size_t i = 0; is_right && i < numbers.size(); ++i) {
    is_right = text[width * i] == ' ' && read_number(text.substr(width * i + 1, digits_of_a_number), numbers[i]);
  }
  return is_right;
}

std::string shown(std::string_view text) {
  constexpr std::size_t longest = 100;  // bytes
  return printable_line(std::string(text), longest);
}

/// "/a/velocity/1" for "a.velocity[1]", as in the errors of JSON lines.
std::string pointer_to(std::string path) {
  std::replace_if(
      path.begin(), path.end(), [](char letter) { return letter == '.' || letter == '['; }, '/');
  std::erase(path, ']');
  return '/' + path;
}

std::string place_in_request(std::size_t place) { return pointer_to(path_of_double(place).text()); }

std::string place_in_reply(std::size_t place) {
  if (place >= doubles_of_an_outcome) {
    const std::size_t in_matrix = place - doubles_of_an_outcome;
    return fmt::format("/C/{}/{}", in_matrix / 3, in_matrix % 3);
  }
  return pointer_to(fmt::format("{}[{}]", name_of(all_outcome_vectors.at(place / 3)), place % 3));
}

/// Throws the first error of a text that is not `count` numbers.
[[noreturn]] void fail(std::string_view text, std::size_t count, std::string (*place_of)(std::size_t)) {
  std::size_t found = 0;
  while (!text.empty()) {
    text.remove_prefix(1);  // the space
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(word.size());
    double number = 0;
    if (found == count) {
      throw FormatError(fmt::format("expected {} numbers, found more: {}", count, shown(word)));
    }
    if (!read_number(word, number)) {
      throw FormatError(place_of(found), "expected 16 hexadecimal digits, found " + shown(word));
    }
    ++found;
  }
  throw FormatError(place_of(found), fmt::format("is missing; expected {} numbers, found {}", count, found));
}

/// Removes the id from the line, up to the first space.
std::uint64_t take_id(std::string_view& line, const std::string& expected) {
  const std::string_view word = line.substr(0, line.find(' '));
  std::uint64_t id = 0;
  const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), id);
  if (failure != std::errc() || end != word.data() + word.size()) {
    throw FormatError("/id", fmt::format("expected {}, found {}", expected, shown(word)));
  }
  line.remove_prefix(word.size());
  return id;
}

/// The text after " WORD"; none if the line does not begin so.
std::optional<std::string> reason_after(std::string_view word, std::string_view line) {
  if (!line.starts_with(word)) {
    return std::nullopt;
  }
  line.remove_prefix(word.size());
  if (!line.empty() && line.front() != ' ') {
    return std::nullopt;
  }
  line.remove_prefix(std::min<std::size_t>(line.size(), 1));
  return printable_line(std::string(line), longest_reason);
}

}  // namespace

void add_hex_request(std::string& text, std::uint64_t id, const Collision& collision) {
  text += fmt::format_int(id).c_str();
  add_numbers(text, doubles_of(collision));
  text += '\n';
}

HexRequest hex_request_from(std::string_view line) {
  const std::uint64_t id = take_id(line, "an integer from 0 to 2^64 - 1");
  std::array<double, doubles_of_a_collision> doubles{};
  if (!read_numbers(line, doubles)) {
    fail(line, doubles.size(), place_in_request);
  }
  return {id, collision_of(doubles)};
}

void add_hex_reply(std::string& text, std::uint64_t id, const Answer& answer) {
  text += fmt::format_int(id).c_str();
  if (const auto* outcome = std::get_if<ReportedOutcome>(&answer)) {
    add_numbers(text, doubles_of<long double>(*outcome));
    if (outcome->collision_matrix) {
      add_numbers(text, doubles_of(*outcome->collision_matrix));
    }
  } else if (const auto* skipped = std::get_if<Skipped>(&answer)) {
    text += " skipped " + printable_line(skipped->why, longest_reason);
  } else {
    const auto* refused = std::get_if<Refused>(&answer);
    text +=
        " error " + printable_line(refused != nullptr ? refused->why : std::get<Failed>(answer).why, longest_reason);
  }
  text += '\n';
}

Answer answer_from_hex(std::string_view line, std::uint64_t id, bool shows_matrix) {
  while (line.ends_with(' ') || line.ends_with('\r')) {
    line.remove_suffix(1);
  }
  const std::string expected = std::to_string(id);
  if (const std::uint64_t found = take_id(line, expected); found != id) {
    throw FormatError("/id", fmt::format("expected {}, found {}", id, found));
  }
  if (const auto why = reason_after(" skipped", line)) {
    return Skipped{*why};
  }
  if (const auto why = reason_after(" error", line)) {
    return Refused{*why};
  }
  constexpr std::size_t most = doubles_of_an_outcome + doubles_of_a_matrix;
  const bool has_matrix = shows_matrix && line.size() > width * doubles_of_an_outcome;
  std::array<double, most> doubles{};
  const auto numbers = std::span(doubles).first(has_matrix ? most : doubles_of_an_outcome);
  if (!read_numbers(line, numbers)) {
    fail(line, numbers.size(), place_in_reply);
  }
  ReportedOutcome outcome = outcome_of<long double>(std::span(doubles).first<doubles_of_an_outcome>());
  if (has_matrix) {
    outcome.collision_matrix = matrix_of<long double>(std::span(doubles).last<doubles_of_a_matrix>());
  }
  return outcome;
}

}  // namespace carom::subjects::protocol
