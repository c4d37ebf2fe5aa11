// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include <carom/collision/collision.hpp>
#include <carom/collision/outcome.hpp>

namespace carom {

/// A collision and the velocities after it, as somebody measured or logged them (docs/reference/protocol.md).
struct Record {
  Collision collision;  // a coefficient that was not recorded is 0
  Outcome<double> after;
  bool has_restitution = false;
  bool has_friction = false;
  bool has_tangential_restitution = false;

  /// The shape that gives the moments of a body.
  struct Shape {
    double length = 0;  // the largest of its lengths [m]; 0 if the record gives the moments
    /// ∂J_i/∂s, where s changes all lengths.
    Vector3<double> moments_by_length = Vector3<double>::Zero();
  };
  std::array<Shape, 2> shapes = {};                  // of A and B
  nlohmann::json others = nlohmann::json::object();  // the unknown fields, by their path
};

/// The principal moments of a solid, uniform sphere, or of such a box with these full lengths.
[[nodiscard]] Vector3<double> moments_of_sphere(double mass, double radius);
[[nodiscard]] Vector3<double> moments_of_box(double mass, const Vector3<double>& lengths);

/// Reads a record. Bodies may have a shape in place of moments. If all vectors have two coordinates, the record is
/// planar. Does not validate the numbers. Throws FormatError that names the place: "after.a.velocity.y: expected …".
[[nodiscard]] Record record_from_json(const nlohmann::json& json);

/// Parses JSON as parse_json does, but keeps each number that is not an integer as its text.
[[nodiscard]] nlohmann::json parse_spelled(std::string_view text);

/// Calls visit(path, text) for each number of a parsed record, as text: ("after.a.velocity", "-1.60"). Leaves out
/// fields that have a dot in their name.
void for_each_spelling(const nlohmann::json& spelled,
                       const std::function<void(const std::string& path, const std::string& text)>& visit);

/// The letters of the components of a vector: x, y, z, or w, x, y, z of an orientation. Empty if the field is no
/// vector.
[[nodiscard]] std::string_view components_of(std::string_view field);

/// The names of the fields that a record or its bodies may have, in any order.
[[nodiscard]] const std::vector<std::string>& fields_of_records();

}  // namespace carom
