// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <concepts>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include <carom/collision/json/json.hpp>

/// Writes a value as JSON and reads it back, both by one description of its type. A type has either a function
/// `fields(archive, value)`, which names each of its fields once, or a specialisation of Json with `write` and `read`.
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

template <class T>
struct Json;

template <class V, class T>
concept Is = std::same_as<std::remove_const_t<V>, T>;

class Writer {
 public:
  static constexpr bool reads = false;

  /// A field that is always present.
  template <class T>
  void operator()(const char* name, const T& value) {
    record[name] = Json<T>::write(value);
  }

  /// A field that is left out if it has its default.
  template <class T>
  void unless_default(const char* name, const T& value) {
    bool is_default = false;
    if constexpr (requires { value.empty(); }) {
      is_default = value.empty();
    } else {
      is_default = value == T{};
    }
    if (!is_default) {
      (*this)(name, value);
    }
  }

  template <class T>
  void unless_default(const char* name, const std::optional<T>& value) {
    if (value) {
      (*this)(name, *value);
    }
  }

  nlohmann::json record = nlohmann::json::object();
};

class Reader {
 public:
  static constexpr bool reads = true;

  explicit Reader(const Field& from) : record(from) {}

  template <class T>
  void operator()(const char* name, T& value) {
    value = Json<T>::read(record.at(name));
  }

  template <class T>
  void unless_default(const char* name, T& value) {
    if (const std::optional<Field> field = record.find(name)) {
      value = Json<T>::read(*field);
    }
  }

  template <class T>
  void unless_default(const char* name, std::optional<T>& value) {
    if (const std::optional<Field> field = record.find(name)) {
      value = Json<T>::read(*field);
    }
  }

  const Field& record;
};

/// For a type with `fields`.
template <class T>
struct Json {
  static nlohmann::json write(const T& value) {
    Writer writer;
    fields(writer, value);
    return std::move(writer.record);
  }
  static T read(const Field& field) {
    T value{};
    Reader reader(field);
    fields(reader, value);
    return value;
  }
};

template <>
struct Json<bool> {
  static nlohmann::json write(bool value) { return value; }
  static bool read(const Field& field) { return field.flag(); }
};

template <>
struct Json<std::uint64_t> {
  static nlohmann::json write(std::uint64_t value) { return value; }
  static std::uint64_t read(const Field& field) { return field.count(); }
};

template <>
struct Json<double> {
  static nlohmann::json write(double value) { return number_to_json(value); }
  static double read(const Field& field) { return field.number(); }
};

template <>
struct Json<std::string> {
  static nlohmann::json write(const std::string& value) { return value; }
  static std::string read(const Field& field) { return field.text(); }
};

/// A missing value is written as null.
template <class T>
struct Json<std::optional<T>> {
  static nlohmann::json write(const std::optional<T>& value) { return value ? Json<T>::write(*value) : nullptr; }
  static std::optional<T> read(const Field& field) {
    return field.value().is_null() ? std::nullopt : std::optional<T>(Json<T>::read(field));
  }
};

template <class T>
struct Json<std::vector<T>> {
  static nlohmann::json write(const std::vector<T>& values) {
    nlohmann::json list = nlohmann::json::array();
    for (const T& value : values) {
      list.push_back(Json<T>::write(value));
    }
    return list;
  }
  static std::vector<T> read(const Field& field) {
    std::vector<T> values;
    for (const Field& element : field.elements()) {
      values.push_back(Json<T>::read(element));
    }
    return values;
  }
};

template <class T>
struct Json<std::map<std::string, T>> {
  static nlohmann::json write(const std::map<std::string, T>& values) {
    nlohmann::json record = nlohmann::json::object();
    for (const auto& [name, value] : values) {
      record[name] = Json<T>::write(value);
    }
    return record;
  }
  static std::map<std::string, T> read(const Field& field) {
    std::map<std::string, T> values;
    for (const auto& [name, value] : field.members()) {
      values.emplace(name, Json<T>::read(value));
    }
    return values;
  }
};

}  // namespace carom::report
