// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include <carom/collision/json/object_reader.hpp>
#include <carom/collision/vector.hpp>

/// The functions throw FormatError. valid_scene.hpp tests the ranges of the numbers later.
namespace carom::scene {

using Fields = detail::ObjectReader<nlohmann::json>;

[[nodiscard]] inline double finite_number(const nlohmann::json& value, const std::string& place) {
  if (!value.is_number() || !std::isfinite(value.get<double>())) {
    throw FormatError(place, "expected a finite number" + detail::found(value));
  }
  return value.get<double>();
}

inline void read(Fields& fields, const char* name, double& into) {
  into = finite_number(fields.required(name), fields.at(name));
}

template <int size>
[[nodiscard]] Eigen::Matrix<double, size, 1> finite_vector(const nlohmann::json& array, const std::string& place) {
  if (!array.is_array() || array.size() != static_cast<std::size_t>(size)) {
    throw FormatError(place, "expected an array of " + std::to_string(size) + " numbers" + detail::found(array));
  }
  Eigen::Matrix<double, size, 1> vector;
  for (int k = 0; k < size; ++k) {
    vector[k] = finite_number(array[static_cast<std::size_t>(k)], place + '/' + std::to_string(k));
  }
  return vector;
}

inline void read(Fields& fields, const char* name, Vector3<double>& into) {
  into = finite_vector<3>(fields.required(name), fields.at(name));
}

inline void read(Fields& fields, const char* name, Quaternion<double>& into) {
  into = finite_vector<4>(fields.required(name), fields.at(name));
}

inline void read(Fields& fields, const char* name, std::string& into) {
  const nlohmann::json& value = fields.required(name);
  if (!value.is_string()) {
    throw FormatError(fields.at(name), "expected a string" + detail::found(value));
  }
  into = value.get<std::string>();
}

inline void read(Fields& fields, const char* name, bool& into) {
  const nlohmann::json& value = fields.required(name);
  if (!value.is_boolean()) {
    throw FormatError(fields.at(name), "expected true or false" + detail::found(value));
  }
  into = value.get<bool>();
}

inline void read(Fields& fields, const char* name, std::uint64_t& into) {
  const nlohmann::json& value = fields.required(name);
  if (!value.is_number_integer() || (!value.is_number_unsigned() && value.get<std::int64_t>() < 0)) {
    throw FormatError(fields.at(name), "expected an integer from 0 to 2^64 - 1" + detail::found(value));
  }
  into = value.get<std::uint64_t>();
}

/// Leaves the value unchanged if the field is absent.
template <class Value>
void read_optional(Fields& fields, const char* name, Value& into) {
  if (fields.has(name)) {
    read(fields, name, into);
  }
}

/// A list; empty if the field is absent.
[[nodiscard]] inline const nlohmann::json& read_list(Fields& fields, const char* name) {
  static const nlohmann::json none = nlohmann::json::array();
  if (!fields.has(name)) {
    return none;
  }
  const nlohmann::json& list = fields.required(name);
  if (!list.is_array()) {
    throw FormatError(fields.at(name), "expected an array" + detail::found(list));
  }
  return list;
}

}  // namespace carom::scene
