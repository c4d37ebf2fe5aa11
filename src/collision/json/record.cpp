// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

#include <carom/collision/json/json.hpp>
#include <carom/collision/json/object_reader.hpp>
#include <carom/collision/json/record.hpp>

namespace carom {
namespace {

using nlohmann::json;

using detail::found;
using detail::ObjectReader;

/// "after.a.velocity.y" for the JSON pointer "/after/a/velocity/1".
std::string dotted(const std::string& pointer) {
  std::string path;
  std::string field;
  std::size_t begin = 1;
  while (begin <= pointer.size()) {
    const std::size_t end = std::min(pointer.find('/', begin), pointer.size());
    std::string part = pointer.substr(begin, end - begin);
    const std::string_view letters = components_of(field);
    if (part.size() == 1 && std::isdigit(static_cast<unsigned char>(part[0])) != 0 &&
        static_cast<std::size_t>(part[0] - '0') < letters.size()) {
      part = letters.substr(static_cast<std::size_t>(part[0] - '0'), 1);
    }
    path += (path.empty() ? "" : ".") + part;
    field = part;
    begin = end + 1;
  }
  return path;
}

/// The lengths of the vectors in a record. A shape and moments may have three in any record.
struct Lengths {
  bool has_two = false;
  bool has_three = false;
};
void add_lengths(const json& value, Lengths& lengths) {
  for (const auto& [name, field] : value.items()) {
    if (field.is_array() && components_of(name) == "xyz" && name != "box" && name != "principal_inertia") {
      lengths.has_two = lengths.has_two || field.size() == 2;
      lengths.has_three = lengths.has_three || field.size() >= 3;
    } else if (field.is_object() && (name == "a" || name == "b" || name == "after")) {
      add_lengths(field, lengths);
    }
  }
}

class RecordReader {
 public:
  explicit RecordReader(const json& value) {
    if (value.is_object()) {
      Lengths lengths;
      add_lengths(value, lengths);
      is_planar_ = lengths.has_two && !lengths.has_three;
    }
  }

  Record read(const json& value) {
    ObjectReader reader(value, {});
    Collision& c = record_.collision;
    read_body(reader, "a", c.a);
    read_body(reader, "b", c.b);
    read_vector(reader, "point", c.point);
    read_vector(reader, "normal", c.normal);
    record_.has_restitution = reader.has("restitution");
    record_.has_friction = reader.has("friction");
    record_.has_tangential_restitution = reader.has("tangential_restitution");
    c.restitution = 0;
    reader.optional_number("restitution", c.restitution);
    reader.optional_number("friction", c.friction);
    reader.optional_number("tangential_restitution", c.tangential_restitution);
    ObjectReader after(reader.required("after"), reader.at("after"));
    read_after(after, "a", c.a, record_.after.a);
    read_after(after, "b", c.b, record_.after.b);
    keep_others(after);
    keep_others(reader);
    return std::move(record_);
  }

 private:
  void read_vector(ObjectReader<json>& reader, const char* name, Vector3<double>& into) {
    if (is_planar_) {
      Eigen::Vector2d planar;
      reader.numbers(name, planar);
      into = {planar[0], planar[1], 0};
    } else {
      reader.numbers(name, into);
    }
  }

  void read_spin(ObjectReader<json>& reader, Vector3<double>& into) {
    if (is_planar_) {
      into = Vector3<double>::Zero();
      reader.number("angular_velocity", into[2]);
    } else {
      reader.numbers("angular_velocity", into);
    }
  }

  /// The moments, or the shape that gives them.
  void read_moments(ObjectReader<json>& reader, Record::Shape& shape, Body& body) {
    if (reader.has("sphere")) {
      double radius = 0;
      reader.number("sphere", radius);
      body.principal_inertia = moments_of_sphere(body.mass, radius);
      shape = {radius, Vector3<double>::Constant(4.0 / 5.0 * body.mass * radius)};
    } else if (reader.has("box")) {
      Vector3<double> lengths;
      read_vector(reader, "box", lengths);
      const auto slope = [&](int i, int j) { return body.mass / 6 * (lengths[i] + lengths[j]); };
      body.principal_inertia = moments_of_box(body.mass, lengths);
      shape = {lengths.maxCoeff(), {slope(1, 2), slope(2, 0), slope(0, 1)}};
      if (is_planar_) {
        body.principal_inertia.setConstant(body.principal_inertia[2]);
      }
    } else if (is_planar_ && !reader.has("principal_inertia")) {
      if (!reader.has("moment")) {
        throw FormatError(reader.at("moment"), "is missing; add this field, or \"sphere\" or \"box\"");
      }
      double moment = 0;
      reader.number("moment", moment);
      body.principal_inertia.setConstant(moment);
    } else {
      if (!reader.has("principal_inertia")) {
        throw FormatError(reader.at("principal_inertia"), "is missing; add this field, or \"sphere\" or \"box\"");
      }
      reader.numbers("principal_inertia", body.principal_inertia);
    }
  }

  void read_body(ObjectReader<json>& parent, const char* name, Body& body) {
    ObjectReader reader(parent.required(name), parent.at(name));
    if (reader.has("immovable")) {
      const json& immovable = reader.required("immovable");
      if (!immovable.is_boolean()) {
        throw FormatError(reader.at("immovable"), "expected true or false" + found(immovable));
      }
      body.immovable = immovable.get<bool>();
    }
    if (!body.immovable) {
      reader.number("mass", body.mass);
      read_moments(reader, record_.shapes.at(name[0] == 'a' ? 0 : 1), body);
      if (!is_planar_ && reader.has("orientation")) {
        reader.numbers("orientation", body.orientation);
      }
    }
    read_vector(reader, "position", body.position);
    read_vector(reader, "velocity", body.velocity);
    read_spin(reader, body.angular_velocity);
    keep_others(reader);
  }

  void read_after(ObjectReader<json>& parent, const char* name, const Body& before, BodyVelocity<double>& into) {
    if (before.immovable && !parent.has(name)) {
      into = {before.velocity, before.angular_velocity};
      return;
    }
    ObjectReader reader(parent.required(name), parent.at(name));
    read_vector(reader, "velocity", into.velocity);
    read_spin(reader, into.angular_velocity);
    keep_others(reader);
  }

  void keep_others(const ObjectReader<json>& reader) {
    reader.for_each_other(
        [&](const std::string& name, const json& value) { record_.others[dotted(reader.at(name))] = value; });
  }

  bool is_planar_ = false;
  Record record_;
};

}  // namespace

Vector3<double> moments_of_sphere(double mass, double radius) {
  return Vector3<double>::Constant(2.0 / 5.0 * mass * radius * radius);
}

Vector3<double> moments_of_box(double mass, const Vector3<double>& lengths) {
  const Vector3<double> squares = lengths.cwiseProduct(lengths);
  return mass / 12 * Vector3<double>(squares[1] + squares[2], squares[2] + squares[0], squares[0] + squares[1]);
}

Record record_from_json(const json& value) {
  try {
    return RecordReader(value).read(value);
  } catch (const FormatError& error) {
    const std::string what = error.what();
    const std::size_t end = what.find(": ");
    if (what.size() < 2 || what[0] != '/' || end == std::string::npos || end < 2) {
      throw;
    }
    throw FormatError(dotted(what.substr(0, end)), what.substr(end + 2));
  }
}

void for_each_spelling(const json& spelled,
                       const std::function<void(const std::string& path, const std::string& text)>& visit) {
  const std::function<void(const json&, const std::string&)> walk = [&](const json& value, const std::string& path) {
    if (value.is_object()) {
      for (const auto& [name, field] : value.items()) {
        walk(field, path.empty() ? name : path + '.' + name);
      }
    } else if (value.is_array()) {
      for (const json& element : value) {
        walk(element, path);
      }
    } else if (value.is_number_integer()) {
      visit(path, value.dump());
    } else if (value.is_string()) {
      visit(path, value.get_ref<const std::string&>());
    }
  };
  walk(spelled, {});
}

std::string_view components_of(std::string_view field) {
  constexpr std::array vectors{"position", "velocity", "angular_velocity", "principal_inertia", "box",
                               "point",    "normal"};
  if (field == "orientation") {
    return "wxyz";
  }
  return std::find(vectors.begin(), vectors.end(), field) != vectors.end() ? "xyz" : "";
}

const std::vector<std::string>& fields_of_records() {
  static const std::vector<std::string> names{"a",
                                              "b",
                                              "after",
                                              "immovable",
                                              "mass",
                                              "principal_inertia",
                                              "sphere",
                                              "box",
                                              "moment",
                                              "position",
                                              "orientation",
                                              "velocity",
                                              "angular_velocity",
                                              "point",
                                              "friction",
                                              "restitution",
                                              "normal",
                                              "tangential_restitution"};
  return names;
}

}  // namespace carom
