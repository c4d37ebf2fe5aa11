// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace carom::report {

/// A value in a JSON text, and its place. Its members throw FormatError that names the place if the value has another
/// type. Precondition: the JSON text outlives the object.
class Field {
 public:
  explicit Field(const nlohmann::json& value, std::string place = {}) : value_(&value), place_(std::move(place)) {}

  [[nodiscard]] const nlohmann::json& value() const { return *value_; }
  [[nodiscard]] const std::string& place() const { return place_; }

  /// The field with this name. `at` throws FormatError if there is none. The object may have other fields.
  [[nodiscard]] Field at(const std::string& name) const;
  [[nodiscard]] std::optional<Field> find(const std::string& name) const;

  [[nodiscard]] std::vector<Field> elements() const;
  [[nodiscard]] std::vector<std::pair<std::string, Field>> members() const;

  [[nodiscard]] std::string text() const;
  /// The text as one line that is safe to print.
  [[nodiscard]] std::string line() const;
  [[nodiscard]] std::uint64_t count() const;
  [[nodiscard]] double number() const;                          // also reads "nan", "inf" and "-inf"
  [[nodiscard]] std::optional<double> optional_number() const;  // none for null
  [[nodiscard]] bool flag() const;

  /// Throws FormatError, which says that `expected` was expected at this place.
  [[noreturn]] void fail(const std::string& expected) const;

 private:
  const nlohmann::json* value_;
  std::string place_;  // a JSON pointer
};

}  // namespace carom::report
