// SPDX-License-Identifier: BSL-1.0
#include "io/record_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>

#include <fmt/format.h>
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wstringop-truncation"  // libfccp cuts long names of files
#endif
#define CSV_IO_NO_THREAD  // the workers parse the lines
#include <libfccp/csv.h>

#include <carom/collision/json/json.hpp>
#include <carom/subjects/protocol/shortage.hpp>

#include "io/input_file.hpp"
#include "io/usage_error.hpp"

namespace carom::tool {

using nlohmann::json;

namespace {

bool is_blank(std::string_view text) { return text.find_first_not_of(" \t\r\n") == std::string_view::npos; }

/// The elements of the array that the text is; none if it is no array. Each element is found by its brackets, so that
/// parsing it finds its errors.
std::optional<std::vector<std::string_view>> elements_of(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos || text[begin] != '[') {
    return std::nullopt;
  }
  std::vector<std::string_view> elements;
  std::size_t depth = 0;
  std::size_t first = begin + 1;
  bool is_in_string = false;
  for (std::size_t i = begin; i < text.size(); ++i) {
    const char letter = text[i];
    if (is_in_string) {
      i += letter == '\\' ? 1 : 0;
      is_in_string = letter != '"';
      continue;
    }
    is_in_string = letter == '"';
    depth += letter == '[' || letter == '{' ? 1 : 0;
    const bool closes = letter == ']' || letter == '}';
    if ((letter == ',' && depth == 1) || (closes && depth == 1)) {
      const std::string_view element = text.substr(first, i - first);
      if (letter == ',' || !elements.empty() || !is_blank(element)) {
        elements.push_back(element);
      }
      first = i + 1;
    }
    depth -= closes ? 1 : 0;
    if (depth == 0) {
      return is_blank(text.substr(i + 1)) ? std::optional(elements) : std::nullopt;
    }
  }
  return std::nullopt;
}

/// A record's column in a CSV file.
struct Column {
  std::vector<std::string> path;  // "after", "a", "velocity"; for an unknown column, its name alone
  int component = -1;             // of a vector
  bool is_known = false;
  bool is_flag = false;
};

Column column_named(const std::string& name) {
  Column column;
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('.', begin), name.size());
    column.path.push_back(name.substr(begin, end - begin));
    begin = end + 1;
  }
  std::vector<std::string>& path = column.path;
  if (path.size() >= 2 && path.back().size() == 1) {
    const std::string_view letters = components_of(path[path.size() - 2]);
    const std::size_t place = letters.find(path.back()[0]);
    if (place != std::string_view::npos) {
      column.component = static_cast<int>(place);
      path.pop_back();
    }
  }
  const std::string& field = path.back();
  const std::vector<std::string>& fields = fields_of_records();
  const bool is_field = std::find(fields.begin(), fields.end(), field) != fields.end();
  const bool is_vector = !components_of(field).empty();
  const bool has_form = (column.component >= 0) == is_vector || field == "angular_velocity";
  const auto is_body = [](const std::string& word) { return word == "a" || word == "b"; };
  const bool is_of_contact = field == "point" || field == "normal" || field == "restitution" || field == "friction" ||
                             field == "tangential_restitution";
  const bool is_after = path.size() == 3 && path[0] == "after" && is_body(path[1]) && field.ends_with("velocity");
  const bool is_of_body = path.size() == 2 && is_body(path[0]) && !is_of_contact;
  column.is_known = is_field && has_form && (is_after || is_of_body || (path.size() == 1 && is_of_contact));
  column.is_flag = field == "immovable";
  if (!column.is_known) {
    column = {{name}};
  }
  return column;
}

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  return first == std::string_view::npos ? ""
                                         : std::string(text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

/// The number in the text; "nan", "inf" and "-inf" as JSON spells them; other text as it is.
json number_in(const std::string& text) {
  const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const char* const end = text.data() + text.size();
  double number = 0;
  const auto [stop, error] = std::from_chars(begin, end, number);
  if (error == std::errc() && stop == end) {
    return number_to_json(number);
  }
  return text;
}

json flag_in(const std::string& text) {
  std::string word = text;
  std::transform(word.begin(), word.end(), word.begin(), [](unsigned char x) { return std::tolower(x); });
  if (word == "true" || word == "1") {
    return true;
  }
  return word == "false" || word == "0" ? json(false) : json(text);
}

/// The cells of a line, with quotes taken off. Throws FormatError.
template <char Separator>
std::vector<std::string> cells_separated(std::string line) {
  using Quotes = io::double_quote_escape<Separator, '"'>;
  std::vector<std::string> cells;
  char* begin = line.data();
  for (;;) {
    const char* found = nullptr;
    try {
      found = Quotes::find_next_column_end(begin);
    } catch (const io::error::base&) {
      throw FormatError("a quotation mark is not closed");
    }
    char* end = begin + (found - begin);
    const bool is_last = *end == '\0';
    *end = '\0';
    char* first = begin;
    char* last = end;
    Quotes::unescape(first, last);
    cells.push_back(trimmed(std::string_view(first, static_cast<std::size_t>(last - first))));
    if (is_last) {
      return cells;
    }
    begin = end + 1;
  }
}

std::vector<std::string> cells_of(const std::string& line, char separator) {
  if (separator == ';') {
    return cells_separated<';'>(line);
  }
  return separator == '\t' ? cells_separated<'\t'>(line) : cells_separated<','>(line);
}

}  // namespace

class CsvRecords {
 public:
  explicit CsvRecords(const std::string& file) : file_(file), lines_(file, opened(file)) {
    std::string header;
    while (is_blank(header)) {
      const std::optional<std::string> line = next_line();
      if (!line) {
        throw UsageError(fmt::format("{}: the file is empty; expected a line of column names", file));
      }
      header = *line;
    }
    for (const char separator : {',', ';', '\t'}) {
      if (header.find(separator) != std::string::npos) {
        separator_ = separator;
        break;
      }
    }
    std::set<std::string> names;
    for (const std::string& name : cells_of(header, separator_)) {
      if (!names.insert(name).second) {
        throw UsageError(
            fmt::format("{}:{}: the column {} occurs twice; keep one of them", file, lines_.get_file_line(), name));
      }
      columns_.push_back(column_named(name));
    }
    if (std::none_of(columns_.begin(), columns_.end(), [](const Column& column) { return column.is_known; })) {
      throw UsageError(
          fmt::format("{}: expected columns such as a.velocity.x and after.a.velocity.x, found {}", file, header));
    }
  }

  std::optional<RecordFile::Text> next() {
    while (std::optional<std::string> line = next_line()) {
      if (!is_blank(*line)) {
        return RecordFile::Text{fmt::format("{}:{}", file_, lines_.get_file_line()), *std::move(line)};
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] json parsed(const RecordFile::Text& record, bool spelled) const {
    const std::vector<std::string> cells = cells_of(record.text, separator_);
    if (cells.size() != columns_.size()) {
      throw FormatError(
          fmt::format("expected {} cells, as in the first line, found {}", columns_.size(), cells.size()));
    }
    json result = json::object();
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Column& column = columns_[i];
      if (cells[i].empty()) {
        continue;
      }
      json* place = &result;
      for (const std::string& name : column.path) {
        place = &(*place)[name];
      }
      if (column.component >= 0) {
        const auto size = static_cast<std::size_t>(column.component) + 1;
        while (place->size() < std::max(size, length_of(column))) {
          place->push_back(nullptr);
        }
        place = &(*place)[size - 1];
      }
      if (column.is_known && column.is_flag) {
        *place = flag_in(cells[i]);
      } else {
        *place = spelled || !column.is_known ? json(cells[i]) : number_in(cells[i]);
      }
    }
    return result;
  }

 private:
  static FILE* opened(const std::string& file) {
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored)) {
      throw UsageError(fmt::format("{}: expected a file, found a directory", file));
    }
    FILE* const stream = std::fopen(file.c_str(), "rb");
    if (stream == nullptr) {
      throw UsageError(errno == ENOENT ? fmt::format("{}: this file does not exist; check the path", file)
                                       : fmt::format("{}: the file cannot be read: {}", file,
                                                     subjects::protocol::message_of({errno, std::generic_category()})));
    }
    return stream;
  }

  std::optional<std::string> next_line() {
    try {
      const char* const line = lines_.next_line();
      return line == nullptr ? std::nullopt : std::optional<std::string>(line);
    } catch (const io::error::base&) {
      throw UsageError(fmt::format("{}:{}: the line is longer than 16 MiB", file_, lines_.get_file_line()));
    }
  }

  /// The number of components that the columns of this vector name.
  [[nodiscard]] std::size_t length_of(const Column& of) const {
    std::size_t length = 0;
    for (const Column& column : columns_) {
      if (column.path == of.path) {
        length = std::max(length, static_cast<std::size_t>(column.component) + 1);
      }
    }
    return length;
  }

  std::string file_;
  io::LineReader lines_;
  char separator_ = ',';
  std::vector<Column> columns_;
};

class JsonRecords {
 public:
  JsonRecords(const std::string& file, const std::stop_token& stop) : file_(file, stop) {
    if (file_.is_lines()) {
      return;
    }
    if (is_blank(file_.whole())) {
      throw UsageError(fmt::format("{}: the file is empty; expected a record", file));
    }
    elements_ = elements_of(file_.whole());
    if (elements_ && elements_->empty()) {
      throw UsageError(fmt::format("{}: the array is empty; expected at least one record", file));
    }
  }

  std::optional<RecordFile::Text> next() {
    if (file_.is_lines()) {
      std::optional<JsonFile::Line> line = file_.next_line();
      return line ? std::optional(
                        RecordFile::Text{fmt::format("{}:{}", file_.file(), line->number), std::move(line->text)})
                  : std::nullopt;
    }
    const std::size_t place = next_++;
    if (!elements_) {
      return place == 0 ? std::optional(RecordFile::Text{file_.file(), file_.whole()}) : std::nullopt;
    }
    return place < elements_->size()
               ? std::optional(RecordFile::Text{fmt::format("{}: element {}", file_.file(), place),
                                                std::string((*elements_)[place])})
               : std::nullopt;
  }

  [[nodiscard]] json parsed(const RecordFile::Text& record, bool spelled) const {
    return spelled ? parse_spelled(record.text) : parse_json(record.text);
  }

 private:
  JsonFile file_;
  std::optional<std::vector<std::string_view>> elements_;  // of an array
  std::size_t next_ = 0;
};

class RecordFile::Source {
 public:
  template <class Records, class... Arguments>
  explicit Source(std::in_place_type_t<Records> type, Arguments&&... arguments)
      : is(type, std::forward<Arguments>(arguments)...) {}

  std::variant<CsvRecords, JsonRecords> is;
};

RecordFile::RecordFile(const std::string& file, const std::stop_token& stop)
    : source_(file.ends_with(".csv") || file.ends_with(".CSV")
                  ? std::make_unique<Source>(std::in_place_type<CsvRecords>, file)
                  : std::make_unique<Source>(std::in_place_type<JsonRecords>, file, stop)) {}

RecordFile::~RecordFile() = default;

std::optional<RecordFile::Text> RecordFile::next() {
  return std::visit([](auto& records) { return records.next(); }, source_->is);
}

json RecordFile::parsed(const Text& record, bool spelled) const {
  return std::visit([&](const auto& records) { return records.parsed(record, spelled); }, source_->is);
}

}  // namespace carom::tool
