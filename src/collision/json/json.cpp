// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include <carom/collision/json/json.hpp>
#include <carom/collision/json/object_reader.hpp>
#include <carom/collision/json/record.hpp>
#include <carom/collision/json/text.hpp>

namespace carom {
namespace {

using nlohmann::json;

using detail::found;
using detail::ObjectReader;
using detail::read_number;
using detail::shortened;

template <class Vector>
json numbers_to_json(const Vector& vector) {
  json array = json::array();
  for (Eigen::Index i = 0; i < vector.size(); ++i) {
    array.push_back(number_to_json(vector[i]));
  }
  return array;
}

/// The number in the text, rounded once to binary64. `wide` is the number as a long double.
double rounded_once(const std::string& text, long double wide) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  // Beyond the range of binary64, rounding to long double first does not change the result.
  return error == std::errc() ? number : static_cast<double>(wide);
}

/// Builds a Json value from the events of the parser. Throws FormatError as parse_json does. `number` reads a number
/// that is not an integer.
template <class Json, class Number>
class Builder : public nlohmann::json_sax<WideJson> {
 public:
  explicit Builder(Number number) : number_(number) {}

  [[nodiscard]] Json take() { return std::move(root_); }

  bool null() override { return put(nullptr); }
  bool boolean(bool value) override { return put(value); }
  bool number_integer(number_integer_t value) override { return put(value); }
  bool number_unsigned(number_unsigned_t value) override { return put(value); }
  bool number_float(number_float_t value, const string_t& text) override { return put(number_(text, value)); }
  bool string(string_t& value) override { return put(std::move(value)); }
  bool binary(binary_t& /*value*/) override { return false; }  // only in binary formats
  bool start_object(std::size_t /*size*/) override { return enter(Json::object()); }
  bool end_object() override { return leave(); }
  bool start_array(std::size_t /*size*/) override { return enter(Json::array()); }
  bool end_array() override { return leave(); }

  bool key(string_t& name) override {
    const auto [member, is_new] = open_.back()->emplace(std::move(name), nullptr);
    if (!is_new) {
      throw FormatError("the field " + shortened(json(member.key())) + " occurs twice in one object; keep one of them");
    }
    next_ = &*member;
    return true;
  }

  bool parse_error(std::size_t /*at*/, const std::string& /*token*/,
                   const nlohmann::detail::exception& error) override {
    // The messages of nlohmann-json begin with a tag in brackets.
    const std::string what = error.what();
    const std::size_t prefix = what.find("] ");
    throw FormatError("not JSON: " + (prefix == std::string::npos ? what : what.substr(prefix + 2)));
  }

 private:
  /// The place of the next value.
  Json& place() {
    if (open_.empty()) {
      return root_;
    }
    if (open_.back()->is_array()) {
      return open_.back()->emplace_back(nullptr);
    }
    return *next_;
  }

  template <class Value>
  bool put(Value&& value) {
    place() = std::forward<Value>(value);
    return true;
  }

  bool enter(Json&& empty) {
    // A collision needs four levels. Deeper values could exhaust the stack of recursive readers.
    constexpr std::size_t deepest = 64;
    if (open_.size() == deepest) {
      throw FormatError("expected at most " + std::to_string(deepest) + " nested levels of objects and arrays");
    }
    Json& opened = place();
    opened = std::move(empty);
    open_.push_back(&opened);
    return true;
  }

  bool leave() {
    open_.pop_back();
    return true;
  }

  Number number_;
  Json root_;
  std::vector<Json*> open_;  // open objects and arrays, outermost first; only the last one grows
  Json* next_ = nullptr;     // the value of the last key
};

template <class Json, class Number>
Json built(std::string_view text, Number number) {
  if (text.find('\0') != std::string_view::npos) {
    throw FormatError("not JSON: the text contains a zero byte");
  }
  Builder<Json, Number> builder(number);
  (void)WideJson::sax_parse(text, &builder);
  return builder.take();
}

/// Whether the coefficient is +0, the value of an omitted field.
bool is_default(double coefficient) { return coefficient == 0 && !std::signbit(coefficient); }

json body_to_json(const Body& body) {
  json result = json::object();
  if (body.immovable) {
    result["immovable"] = true;
  } else {
    result["mass"] = number_to_json(body.mass);
    result["principal_inertia"] = numbers_to_json(body.principal_inertia);
    result["orientation"] = numbers_to_json(body.orientation);
  }
  result["position"] = numbers_to_json(body.position);
  result["velocity"] = numbers_to_json(body.velocity);
  result["angular_velocity"] = numbers_to_json(body.angular_velocity);
  return result;
}

Body body_from_json(const json& value, const std::string& place) {
  ObjectReader reader(value, place);
  Body body;
  if (reader.has("immovable")) {
    const json& immovable = reader.required("immovable");
    if (!immovable.is_boolean()) {
      throw FormatError(reader.at("immovable"), "expected true or false" + found(immovable));
    }
    body.immovable = immovable.get<bool>();
  }
  if (!body.immovable) {
    reader.number("mass", body.mass);
    reader.numbers("principal_inertia", body.principal_inertia);
    if (reader.has("orientation")) {
      reader.numbers("orientation", body.orientation);
    }
  }
  reader.numbers("position", body.position);
  reader.numbers("velocity", body.velocity);
  reader.numbers("angular_velocity", body.angular_velocity);
  reader.reject_others();
  return body;
}

}  // namespace

json parse_json(std::string_view text) {
  return built<json>(text, [](const std::string& digits, long double wide) {
    const double number = rounded_once(digits, wide);
    if (!std::isfinite(number)) {
      throw FormatError("the number '" + digits + "' overflows binary64");
    }
    return number;
  });
}

json parse_spelled(std::string_view text) {
  return built<json>(text, [](const std::string& digits, long double /*wide*/) { return digits; });
}

WideJson parse_reply(std::string_view text, Precision precision) {
  return built<WideJson>(text, [precision](const std::string& digits, long double wide) {
    return precision == Precision::extended ? wide : static_cast<long double>(rounded_once(digits, wide));
  });
}

json number_to_json(double number) {
  if (std::isnan(number)) {
    return "nan";
  }
  if (std::isinf(number)) {
    return number > 0 ? "inf" : "-inf";
  }
  return number;
}

double number_from_json(const json& value, const std::string& place) {
  return read_number<double>(value, [&] { return place; });
}

json vector_to_json(const Vector3<double>& vector) { return numbers_to_json(vector); }

json collision_to_json(const Collision& collision) {
  json result = json::object();
  result["a"] = body_to_json(collision.a);
  result["b"] = body_to_json(collision.b);
  result["point"] = numbers_to_json(collision.point);
  result["normal"] = numbers_to_json(collision.normal);
  result["restitution"] = number_to_json(collision.restitution);
  if (!is_default(collision.friction)) {
    result["friction"] = number_to_json(collision.friction);
  }
  if (!is_default(collision.tangential_restitution)) {
    result["tangential_restitution"] = number_to_json(collision.tangential_restitution);
  }
  return result;
}

Collision collision_from_json(const json& value, const std::string& place) {
  ObjectReader reader(value, place);
  Collision collision;
  collision.a = body_from_json(reader.required("a"), reader.at("a"));
  collision.b = body_from_json(reader.required("b"), reader.at("b"));
  reader.numbers("point", collision.point);
  reader.numbers("normal", collision.normal);
  reader.number("restitution", collision.restitution);
  reader.optional_number("friction", collision.friction);
  reader.optional_number("tangential_restitution", collision.tangential_restitution);
  reader.reject_others();
  return collision;
}

Outcome<long double> outcome_from_json(const WideJson& value) {
  Outcome<long double> outcome;
  ObjectReader reader(value, {});
  const auto read = [&](const char* name, BodyVelocity<long double>& motion) {
    ObjectReader body(reader.required(name), reader.at(name));
    body.numbers("velocity", motion.velocity);
    body.numbers("angular_velocity", motion.angular_velocity);
  };
  read("a", outcome.a);
  read("b", outcome.b);
  return outcome;
}

Matrix3<long double> collision_matrix_from_json(const WideJson& value) {
  ObjectReader reader(value, {});
  const WideJson& rows = reader.required("C");
  if (!rows.is_array() || rows.size() != 3) {
    throw FormatError(reader.at("C"), "expected an array of 3 rows" + found(rows));
  }
  Matrix3<long double> matrix;
  for (std::size_t i = 0; i < 3; ++i) {
    Vector3<long double> row;
    detail::read_numbers(rows[i], row, [&] { return reader.at("C") + '/' + std::to_string(i); });
    matrix.row(static_cast<Eigen::Index>(i)) = row;
  }
  return matrix;
}

namespace {

/// Whether the text can be the value of a kind, such as "xy".
bool is_word(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char letter) {
    return letter == '_' || (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z');
  });
}

}  // namespace

std::string domain_from_json(const json& domain, const std::string& place) {
  constexpr std::size_t longest_name = 100;  // bytes
  if (!domain.is_object()) {
    throw FormatError(place, "expected an object");
  }
  std::string text;
  for (const auto& [name, range] : domain.items()) {
    const std::string quantity = printable_line(name, longest_name);
    if (name.find_first_of("=,:") != std::string::npos) {
      throw FormatError(place, "expected names of quantities, found " + quantity);
    }
    if (range.is_string() && is_word(range.get_ref<const std::string&>())) {
      text += (text.empty() ? "" : ",") + quantity + '=' + range.get<std::string>();
      continue;
    }
    const auto is_end = [](const json& end) { return end.is_null() || end.is_number(); };
    if (!range.is_array() || range.size() != 2 || !is_end(range[0]) || !is_end(range[1])) {
      throw FormatError(place + '/' + quantity,
                        "expected two numbers, the least and the greatest value, with null for no limit; or the text "
                        "of a kind");
    }
    const auto end = [](const json& number) { return number.is_null() ? std::string() : number.dump(); };
    text += (text.empty() ? "" : ",") + quantity + '=' + end(range[0]) + ':' + end(range[1]);
  }
  return text;
}

json domain_to_json(std::string_view text) {
  json record = json::object();
  while (!text.empty() && text != "everything") {
    const std::string_view part = text.substr(0, text.find(','));
    text.remove_prefix(std::min(part.size() + 1, text.size()));
    const std::size_t sign = part.find('=');
    if (sign == std::string_view::npos) {
      throw std::invalid_argument("the domain of a subject: expected ranges such as size=0.1:10, found " +
                                  std::string(part));
    }
    const std::string_view range = part.substr(sign + 1);
    if (is_word(range)) {
      record[std::string(part.substr(0, sign))] = range;
      continue;
    }
    const std::string_view least = range.substr(0, range.find(':'));
    const std::string_view most = least.size() == range.size() ? least : range.substr(least.size() + 1);
    const auto end = [&](std::string_view number) {
      const json parsed = number.empty() ? json() : json::parse(number, nullptr, false);
      if (!number.empty() && !parsed.is_number()) {
        throw std::invalid_argument("the domain of a subject: expected numbers in " + std::string(part));
      }
      return parsed;
    };
    record[std::string(part.substr(0, sign))] = {end(least), end(most)};
  }
  return record;
}

}  // namespace carom
