// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>

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
  std::string two;    // the path of a vector with two coordinates; empty if there is none
  std::string three;  // the same for three or more
};
void add_lengths(const json& value, const std::string& place, Lengths& lengths) {
  for (const auto& [name, field] : value.items()) {
    if (field.is_array() && components_of(name) == "xyz" && name != "box" && name != "principal_inertia") {
      std::string& path = field.size() == 2 ? lengths.two : lengths.three;
      if (field.size() >= 2 && path.empty()) {
        path = place + name;
      }
    } else if (field.is_object() && (name == "a" || name == "b" || name == "after")) {
      add_lengths(field, place + name + '.', lengths);
    }
  }
}

/// The fields of which one gives the moments of a body.
std::span<const char* const> fields_of_moments(bool is_planar) {
  static constexpr std::array names{"sphere", "box", "principal_inertia", "moment", "disc"};
  return std::span(names).first(is_planar ? 5 : 3);
}

/// The required fields that a record does not have.
class MissingFields {
 public:
  MissingFields(const json& record, bool is_planar, const std::string& spatial_vector)
      : is_planar_(is_planar), spatial_vector_(spatial_vector) {
    require(record, "", {"a", "b", "point", "normal", "after"});
    const json& after = part(record, "after");
    for (const char* const name : {"a", "b"}) {
      const json& body = part(record, name);
      const std::string place = std::string(name) + '.';
      if (const json& immovable = part(body, "immovable"); immovable.is_null() || immovable == json(false)) {
        require(body, place, {"mass"});
        require_moments(body, place);
        require(after, "after.", {name});
      }
      require(body, place, {"position", "velocity", "angular_velocity"});
      require(part(after, name), "after." + place, {"velocity", "angular_velocity"});
    }
  }

  /// Throws FormatError that names all of them.
  void expect_none() const {
    if (names_.empty()) {
      return;
    }
    std::string names = names_[0];
    for (std::size_t i = 1; i < names_.size(); ++i) {
      names += (i + 1 < names_.size() ? ", " : " and ") + names_[i];
    }
    throw FormatError(names + (names_.size() == 1 ? ": is missing; add this field" : " are missing; add these fields") +
                      hint_ + " (docs/guide/check.md)");
  }

 private:
  static const json& part(const json& object, const char* name) {
    static const json nothing;
    return object.contains(name) ? object.at(name) : nothing;
  }

  void require(const json& object, const std::string& place, std::initializer_list<const char*> names) {
    for (const char* const name : names) {
      if (object.is_object() && !object.contains(name)) {
        names_.push_back(place + name);
      }
    }
  }

  void require_moments(const json& body, const std::string& place) {
    const auto has = [&](const char* name) { return body.contains(name); };
    const std::span<const char* const> fields = fields_of_moments(is_planar_);
    if (!body.is_object() || std::any_of(fields.begin(), fields.end(), has)) {
      return;
    }
    const std::string moments = is_planar_ ? "moment" : "principal_inertia";
    const std::string round = is_planar_ ? "disc" : "sphere";
    names_.push_back(place + moments);
    if ((has("moment") || has("disc")) && !spatial_vector_.empty()) {
      hint_ = "; only a planar record has \"moment\" or \"disc\", and " + spatial_vector_ + " has three coordinates";
    } else if (has("circle") || has("inertia")) {
      hint_ = "; did you mean '" + (has("circle") ? round : moments) + "'?";
    } else {
      hint_ = std::string(", or ") + (is_planar_ ? "\"disc\", " : "") + "\"sphere\" or \"box\"";
    }
  }

  bool is_planar_;
  const std::string& spatial_vector_;  // the path of a vector with three coordinates; empty if there is none
  std::vector<std::string> names_;
  std::string hint_;
};

class RecordReader {
 public:
  explicit RecordReader(const json& value) {
    if (value.is_object()) {
      Lengths lengths;
      add_lengths(value, "", lengths);
      is_planar_ = !lengths.two.empty() && lengths.three.empty();
      MissingFields(value, is_planar_, lengths.three).expect_none();
      if (!is_planar_ && !lengths.two.empty()) {
        throw FormatError(lengths.two, "expected an array of 3 numbers, as " + lengths.three +
                                           " has; a planar record has 2 in each vector, and one number as "
                                           "angular_velocity");
      }
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
  void read_vector(ObjectReader<json>& reader, const char* name, Vector3<double>& into) const {
    read_vector(reader, name, into, is_planar_);
  }
  static void read_vector(ObjectReader<json>& reader, const char* name, Vector3<double>& into, bool is_planar) {
    if (is_planar) {
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

  /// The one field that gives the moments of a body.
  std::string field_of_moments(ObjectReader<json>& reader) const {
    std::string given;
    for (const char* const name : fields_of_moments(is_planar_)) {
      if (reader.has(name)) {
        if (!given.empty()) {
          throw FormatError(reader.at(name), "contradicts \"" + given + "\"; keep one of them");
        }
        given = name;
      }
    }
    return given;
  }

  static void expect_length(const std::string& place, double length) {
    if (!(length > 0 && std::isfinite(length))) {
      throw FormatError(place, "expected a finite length greater than 0" + found(number_to_json(length)));
    }
  }

  /// The lengths of a box. The third is 0 in a planar record.
  Vector3<double> read_box(ObjectReader<json>& reader) const {
    Vector3<double> lengths;
    const bool is_flat = is_planar_ && reader.required("box").size() == 2;
    read_vector(reader, "box", lengths, is_flat);
    for (int i = 0; i < (is_flat ? 2 : 3); ++i) {
      expect_length(reader.at("box") + '/' + std::to_string(i), lengths[i]);
    }
    lengths[2] = is_planar_ ? 0 : lengths[2];
    return lengths;
  }

  /// The moments, or the shape that gives them.
  void read_moments(ObjectReader<json>& reader, Record::Shape& shape, Body& body) {
    const std::string given = field_of_moments(reader);
    if (given == "sphere") {
      double radius = 0;
      reader.number("sphere", radius);
      expect_length(reader.at("sphere"), radius);
      body.principal_inertia = moments_of_sphere(body.mass, radius);
      shape = {radius, Vector3<double>::Constant(4.0 / 5.0 * body.mass * radius)};
    } else if (given == "disc") {
      double radius = 0;
      reader.number("disc", radius);
      expect_length(reader.at("disc"), radius);
      body.principal_inertia.setConstant(body.mass / 2 * radius * radius);
      shape = {radius, Vector3<double>::Constant(body.mass * radius)};
    } else if (given == "box") {
      const Vector3<double> lengths = read_box(reader);
      const auto slope = [&](int i, int j) { return body.mass / 6 * (lengths[i] + lengths[j]); };
      body.principal_inertia = moments_of_box(body.mass, lengths);
      shape = {lengths.maxCoeff(), {slope(1, 2), slope(2, 0), slope(0, 1)}};
      if (is_planar_) {
        body.principal_inertia.setConstant(body.principal_inertia[2]);
      }
    } else if (given == "moment") {
      double moment = 0;
      reader.number("moment", moment);
      body.principal_inertia.setConstant(moment);
    } else {
      reader.numbers("principal_inertia", body.principal_inertia);
    }
    const bool is_in_range = body.principal_inertia.allFinite() && body.principal_inertia.minCoeff() > 0;
    if (shape.length > 0 && body.mass > 0 && std::isfinite(body.mass) && !is_in_range) {
      throw FormatError(reader.at(given), "gives moments of inertia beyond the range of binary64");
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
    } else {
      (void)reader.has("mass");
      (void)reader.has("orientation");
      for (const char* const unread : fields_of_moments(true)) {
        (void)reader.has(unread);
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
    if (what.starts_with("/: ")) {
      throw FormatError(what.substr(3));
    }
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
        // The name of an unknown field may look like a path.
        if (name.find('.') == std::string::npos) {
          walk(field, path.empty() ? name : path + '.' + name);
        }
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
                                              "disc",
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
