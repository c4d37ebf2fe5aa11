// SPDX-License-Identifier: BSL-1.0
#include <cstddef>

#include <fmt/format.h>

#include <carom/collision/json/json.hpp>
#include <carom/collision/json/text.hpp>
#include <carom/report/results/archive.hpp>
#include <carom/report/results/words.hpp>

namespace carom::report {
namespace {

using nlohmann::json;

constexpr std::size_t longest_found = 100;

}  // namespace

Field Field::at(const std::string& name) const {
  if (const std::optional<Field> field = find(name)) {
    return *field;
  }
  throw FormatError(place_ + '/' + name, "is missing");
}

std::optional<Field> Field::find(const std::string& name) const {
  if (!value_->is_object()) {
    fail("an object");
  }
  const auto found = value_->find(name);
  return found == value_->end() ? std::nullopt : std::optional<Field>(Field(*found, place_ + '/' + name));
}

std::vector<Field> Field::elements() const {
  if (!value_->is_array()) {
    fail("an array");
  }
  std::vector<Field> fields;
  fields.reserve(value_->size());
  for (const json& element : *value_) {
    fields.emplace_back(element, fmt::format("{}/{}", place_, fields.size()));
  }
  return fields;
}

std::vector<std::pair<std::string, Field>> Field::members() const {
  if (!value_->is_object()) {
    fail("an object");
  }
  std::vector<std::pair<std::string, Field>> fields;
  for (const auto& [name, value] : value_->items()) {
    fields.emplace_back(name, Field(value, place_ + '/' + printable_line(name, longest_line)));
  }
  return fields;
}

std::string Field::text() const {
  if (!value_->is_string()) {
    fail("a string");
  }
  return value_->get<std::string>();
}

std::string Field::line() const { return printable_line(text(), longest_line); }

std::uint64_t Field::count() const {
  if (!value_->is_number_unsigned()) {
    fail("a count");
  }
  return value_->get<std::uint64_t>();
}

double Field::number() const { return number_from_json(*value_, place_); }

std::optional<double> Field::optional_number() const {
  return value_->is_null() ? std::nullopt : std::optional<double>(number());
}

bool Field::flag() const {
  if (!value_->is_boolean()) {
    fail("true or false");
  }
  return value_->get<bool>();
}

void Field::fail(const std::string& expected) const {
  throw FormatError(
      place_, fmt::format("expected {}, found {}", expected,
                          printable_line(value_->dump(-1, ' ', false, json::error_handler_t::replace), longest_found)));
}

}  // namespace carom::report
