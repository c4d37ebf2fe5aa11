// SPDX-License-Identifier: BSL-1.0
#include "io/record_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>
#include <variant>

#include <fmt/format.h>
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wstringop-truncation"  // libfccp cuts long names of files
#endif
#define CSV_IO_NO_THREAD  // the workers parse the lines
#include <libfccp/csv.h>

#include <carom/collision/json/json.hpp>

#include "io/input_file.hpp"
#include "io/usage_error.hpp"

namespace carom::tool {

using nlohmann::json;

namespace {

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
  std::string name;
  std::vector<std::string> path = {};  // "after", "a", "velocity"; for an unknown column, its name alone
  int component = -1;                  // of a vector
  std::size_t length = 0;              // the number of components that the columns of this vector name
  bool is_known = false;
  bool is_flag = false;
};

Column column_named(const std::string& name) {
  Column column{name};
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
    column = {name, {name}};
  }
  return column;
}

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  return first == std::string_view::npos ? ""
                                         : std::string(text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

/// The number in the text; "nan", "inf" and "-inf" as JSON spells them; other text as it is. Throws FormatError if the
/// number overflows.
json number_in(const std::string& text) {
  const char* const begin = text.data() + (text.starts_with('+') && !text.starts_with("+-") ? 1 : 0);
  const char* const end = text.data() + text.size();
  double number = 0;
  const auto [stop, error] = std::from_chars(begin, end, number);
  if (error == std::errc() && stop == end) {
    return number_to_json(number);
  }
  if (error == std::errc::result_out_of_range && stop == end) {
    number = std::strtod(begin, nullptr);  // from_chars does not tell overflow from underflow
    if (std::isinf(number)) {
      throw FormatError("the number '" + text + "' overflows binary64");
    }
    return number;
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
  CsvRecords(const std::string& file, const std::stop_token& stop) : file_(file), input_(file, stop) {
    std::optional<BoundedInput::Line> line = input_.next_line();
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (line && line->text.starts_with(byte_order_mark)) {
      line->text.erase(0, byte_order_mark.size());
    }
    if (!line || is_blank(line->text)) {
      throw UsageError(fmt::format("{}: the file is empty; expected a line of column names", file));
    }
    const std::string header = without_return(std::move(line->text));
    for (const char separator : {',', ';', '\t'}) {
      if (header.find(separator) != std::string::npos) {
        separator_ = separator;
        break;
      }
    }
    try {
      for (const std::string& name : cells_of(header, separator_)) {
        columns_.push_back(column_named(name));
      }
      relate_columns();
    } catch (const FormatError& error) {
      throw UsageError(fmt::format("{}:{}: {}", file, line->number, error.what()));
    }
    if (std::none_of(columns_.begin(), columns_.end(), [](const Column& column) { return column.is_known; })) {
      throw UsageError(
          fmt::format("{}: expected columns such as a.velocity.x and after.a.velocity.x, found {}", file, header));
    }
  }

  std::optional<RecordFile::Text> next() {
    std::optional<BoundedInput::Line> line = input_.next_line();
    return line ? std::optional(RecordFile::Text{fmt::format("{}:{}", file_, line->number),
                                                 without_return(std::move(line->text))})
                : std::nullopt;
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
        while (place->size() < column.length) {
          place->push_back(nullptr);
        }
        place = &(*place)[static_cast<std::size_t>(column.component)];
      }
      if (column.is_known && column.is_flag) {
        *place = flag_in(cells[i]);
      } else {
        *place = spelled || !column.is_known ? json(cells[i]) : number_at(column.name, cells[i]);
      }
    }
    return result;
  }

 private:
  static std::string without_return(std::string line) {
    if (line.ends_with('\r')) {
      line.pop_back();
    }
    return line;
  }

  static json number_at(const std::string& column, const std::string& text) {
    try {
      return number_in(text);
    } catch (const FormatError& error) {
      throw FormatError(column, error.what());
    }
  }

  /// Sets the lengths. Throws FormatError if a column occurs twice, or if one column is a part of another.
  void relate_columns() {
    std::vector<Column*> sorted;
    for (Column& column : columns_) {
      sorted.push_back(&column);
    }
    const auto key = [](const Column* column) { return std::tie(column->path, column->component, column->name); };
    std::sort(sorted.begin(), sorted.end(), [&](const Column* x, const Column* y) { return key(x) < key(y); });
    // The columns of a vector, and those that a column contains, follow it.
    for (std::size_t i = sorted.size(); i-- > 0;) {
      Column& column = *sorted[i];
      const bool is_first = i == 0 || sorted[i - 1]->path != column.path;
      if (is_first && column.component == 2 && column.path.back() == "angular_velocity") {
        column.component = -1;  // a planar log may name the only component
      }
      column.length = static_cast<std::size_t>(column.component + 1);
      if (i + 1 == sorted.size()) {
        continue;
      }
      const Column& next = *sorted[i + 1];
      if (column.name == next.name) {
        throw FormatError(fmt::format("the column {} occurs twice; keep one of them", column.name));
      }
      const bool contains_next = column.path.size() <= next.path.size() &&
                                 std::equal(column.path.begin(), column.path.end(), next.path.begin());
      if (contains_next && (column.path != next.path || column.component < 0)) {
        throw FormatError(
            fmt::format("the columns {} and {} contradict each other; keep one of them", column.name, next.name));
      }
      column.length = contains_next ? next.length : column.length;
    }
  }

  std::string file_;
  BoundedInput input_;
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
                  ? std::make_unique<Source>(std::in_place_type<CsvRecords>, file, stop)
                  : std::make_unique<Source>(std::in_place_type<JsonRecords>, file, stop)) {}

RecordFile::~RecordFile() = default;

std::optional<RecordFile::Text> RecordFile::next() {
  return std::visit([](auto& records) { return records.next(); }, source_->is);
}

json RecordFile::parsed(const Text& record, bool spelled) const {
  return std::visit([&](const auto& records) { return records.parsed(record, spelled); }, source_->is);
}

}  // namespace carom::tool
