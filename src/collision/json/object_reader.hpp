// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include <carom/collision/json/json.hpp>

/// Shared code of the JSON readers. It is not installed.
namespace carom::detail {

/// The value as JSON text, cut to 60 bytes.
template <class Json>
[[nodiscard]] std::string shortened(const Json& value) {
  constexpr std::size_t most = 60;
  // nlohmann-json cannot print long double.
  const std::string text = nlohmann::json(value).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  return text.size() > most ? text.substr(0, most) + "…" : text;
}

/// The end of an error message: ", found true".
template <class Json>
[[nodiscard]] std::string found(const Json& value) {
  return ", found " + shortened(value);
}

/// Reads a number as number_to_json writes it. Calls `place`, the place for an error message, only on an error.
template <class Number, class Json, class Place>
[[nodiscard]] Number read_number(const Json& value, const Place& place) {
  using Limits = std::numeric_limits<Number>;
  if (value.is_number()) {
    return value.template get<Number>();
  }
  if (value == "nan") {
    return Limits::quiet_NaN();
  }
  if (value == "inf") {
    return Limits::infinity();
  }
  if (value == "-inf") {
    return -Limits::infinity();
  }
  throw FormatError(place(), "expected a number" + found(value));
}

/// Reads all components of a vector.
template <class Json, class Vector, class Place>
void read_numbers(const Json& array, Vector& into, const Place& place) {
  if (!array.is_array() || array.size() != static_cast<std::size_t>(into.size())) {
    throw FormatError(place(), "expected an array of " + std::to_string(into.size()) + " numbers" + found(array));
  }
  for (Eigen::Index i = 0; i < into.size(); ++i) {
    into[i] = read_number<typename Vector::Scalar>(array[static_cast<std::size_t>(i)],
                                                   [&] { return place() + '/' + std::to_string(i); });
  }
}

/// Reads the fields of one JSON object. Remembers the requested names, so that reject_others can find unknown fields.
template <class Json>
class ObjectReader {
 public:
  ObjectReader(const Json& value, std::string place) : object_(value), place_(std::move(place)) {
    if (!value.is_object()) {
      throw FormatError(place_, "expected an object" + found(value));
    }
  }

  [[nodiscard]] bool has(const char* name) {
    if (std::find(asked_.begin(), asked_.end(), name) == asked_.end()) {
      asked_.emplace_back(name);
    }
    return object_.contains(name);
  }

  [[nodiscard]] const Json& required(const char* name) {
    if (!has(name)) {
      throw FormatError(at(name), "is missing; add this field");
    }
    return object_.at(name);
  }

  [[nodiscard]] std::string at(std::string_view name) const { return place_ + '/' + std::string(name); }

  void number(const char* name, double& into) {
    into = read_number<double>(required(name), [&] { return at(name); });
  }

  void optional_number(const char* name, double& into) {
    if (has(name)) {
      number(name, into);
    }
  }

  template <class Vector>
  void numbers(const char* name, Vector& into) {
    read_numbers(required(name), into, [&] { return at(name); });
  }

  /// Calls visit(name, value) for each field that was not requested.
  template <class Visit>
  void for_each_other(const Visit& visit) const {
    for (const auto& [name, value] : object_.items()) {
      if (std::find(asked_.begin(), asked_.end(), name) == asked_.end()) {
        visit(name, value);
      }
    }
  }

  void reject_others() const {
    for_each_other([&](const std::string& name, const Json& /*value*/) {
      std::string known;
      for (const std::string& field : asked_) {
        known += (known.empty() ? "" : ", ") + field;
      }
      throw FormatError(at(name), "unknown field; expected one of " + known);
    });
  }

 private:
  const Json& object_;
  std::string place_;
  std::vector<std::string> asked_;
};

}  // namespace carom::detail
