// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <carom/collision/expects.hpp>
#include <carom/collision/json/object_reader.hpp>
#include <carom/collision/law.hpp>
#include <carom/collision/precision.hpp>
#include <carom/scene/json/scene_json.hpp>
#include <carom/scene/lattice.hpp>
#include <carom/scene/polyhedra/valid_polyhedra.hpp>
#include <carom/scene/valid_scene.hpp>

namespace carom::scene {
namespace {

using detail::found;
using nlohmann::json;

// These readers throw FormatError. valid_scene.hpp tests the ranges of the numbers later.

using Fields = detail::ObjectReader<json>;

double finite_number(const json& value, const std::string& place) {
  if (!value.is_number() || !std::isfinite(value.get<double>())) {
    throw FormatError(place, "expected a finite number" + found(value));
  }
  return value.get<double>();
}

void read(Fields& fields, const char* name, double& into) {
  into = finite_number(fields.required(name), fields.at(name));
}

template <int size>
Eigen::Matrix<double, size, 1> finite_vector(const json& array, const std::string& place) {
  if (!array.is_array() || array.size() != static_cast<std::size_t>(size)) {
    throw FormatError(place, "expected an array of " + std::to_string(size) + " numbers" + found(array));
  }
  Eigen::Matrix<double, size, 1> vector;
  for (int k = 0; k < size; ++k) {
    vector[k] = finite_number(array[static_cast<std::size_t>(k)], place + '/' + std::to_string(k));
  }
  return vector;
}

void read(Fields& fields, const char* name, Vector3<double>& into) {
  into = finite_vector<3>(fields.required(name), fields.at(name));
}

void read(Fields& fields, const char* name, Quaternion<double>& into) {
  into = finite_vector<4>(fields.required(name), fields.at(name));
}

void read(Fields& fields, const char* name, std::string& into) {
  const json& value = fields.required(name);
  if (!value.is_string()) {
    throw FormatError(fields.at(name), "expected a string" + found(value));
  }
  into = value.get<std::string>();
}

void read(Fields& fields, const char* name, bool& into) {
  const json& value = fields.required(name);
  if (!value.is_boolean()) {
    throw FormatError(fields.at(name), "expected true or false" + found(value));
  }
  into = value.get<bool>();
}

void read(Fields& fields, const char* name, std::uint64_t& into) {
  const json& value = fields.required(name);
  if (!value.is_number_integer() || (!value.is_number_unsigned() && value.get<std::int64_t>() < 0)) {
    throw FormatError(fields.at(name), "expected an integer from 0 to 2^64 - 1" + found(value));
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
const json& read_list(Fields& fields, const char* name) {
  static const json none = json::array();
  if (!fields.has(name)) {
    return none;
  }
  const json& list = fields.required(name);
  if (!list.is_array()) {
    throw FormatError(fields.at(name), "expected an array" + found(list));
  }
  return list;
}

/// Calls use(fields, i) for each object of a list. Every field must be used.
template <class Use>
void for_each_in(Fields& root, const char* name, const Use& use) {
  const json& list = read_list(root, name);
  for (std::size_t i = 0; i < list.size(); ++i) {
    Fields fields(list[i], root.at(name) + '/' + std::to_string(i));
    use(fields, i);
    fields.reject_others();
  }
}

class MaterialsReader {
 public:
  /// The scene must outlive the reader.
  explicit MaterialsReader(Scene& scene) : scene_(scene) {}

  /// Reads "materials" and "contacts" into the scene. Throws FormatError.
  void read_materials(Fields& root) {
    const json& names = read_list(root, "materials");
    if (names.size() > most_materials) {
      throw FormatError("/materials", "expected at most " + std::to_string(most_materials) + " materials, found " +
                                          std::to_string(names.size()));
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::string place = "/materials/" + std::to_string(i);
      if (!names[i].is_string() || names[i].get_ref<const std::string&>().empty()) {
        throw FormatError(place, "expected a nonempty name" + found(names[i]));
      }
      if (!indices_.emplace(names[i].get<std::string>(), i).second) {
        throw FormatError(place, "expected different names, found " + names[i].dump() + " twice");
      }
      scene_.materials.push_back(names[i]);
    }
    if (names.empty()) {
      scene_.materials = {"default"};
      indices_ = {{"default", 0}};
    }
    scene_.pairs = MaterialPairs(scene_.materials.size());
    has_contacts_ = root.has("contacts");
    for_each_in(root, "contacts", [&](Fields& fields, std::size_t i) { read_contact(fields, i); });
  }

  /// The index of a body's material. Throws FormatError.
  [[nodiscard]] std::size_t material_of(Fields& body) const {
    if (body.has("material")) {
      return material_named(body.required("material"), body.at("material"));
    }
    if (scene_.materials.size() > 1) {
      throw FormatError(body.at("material"),
                        "is missing; name one of the " + std::to_string(scene_.materials.size()) + " materials");
    }
    return 0;
  }

  /// Call after all bodies are read. Throws FormatError if the file has "contacts", but no contact for the materials of
  /// two bodies that can meet.
  void check_all_listed() const {
    if (!has_contacts_) {
      return;
    }
    // Two bodies of each material are enough: one for pairs with other materials, and both for the pair of the material
    // with itself.
    struct Users {
      std::vector<std::string> bodies;
      std::optional<std::string> plane;
    };
    std::vector<Users> users(scene_.materials.size());
    for (std::size_t i = 0; i < body_count(scene_); ++i) {
      std::vector<std::string>& bodies = users[carom::scene::material_of(scene_, i)].bodies;
      if (bodies.size() < 2) {
        bodies.push_back(description_of(scene_, i));
      }
    }
    for (std::size_t i = 0; i < scene_.planes.size(); ++i) {
      std::optional<std::string>& plane = users[scene_.planes[i].material].plane;
      if (!plane) {
        plane = "plane " + std::to_string(i) + " (" + scene_.planes[i].name + ")";
      }
    }
    for (std::size_t a = 0; a < users.size(); ++a) {
      for (std::size_t b = 0; b < users.size() && !users[a].bodies.empty(); ++b) {
        if (b > a && !users[b].bodies.empty()) {
          require_contact(a, b, users[a].bodies[0], users[b].bodies[0]);
        }
        if (b == a && users[a].bodies.size() > 1) {
          require_contact(a, a, users[a].bodies[0], users[a].bodies[1]);
        }
        if (users[b].plane) {
          require_contact(a, b, users[a].bodies[0], *users[b].plane);
        }
      }
    }
  }

  /// The place of a pair of materials in the file; "/contacts" if the pair is not listed.
  [[nodiscard]] std::string place_of(std::size_t a, std::size_t b) const {
    const auto known = places_.find(std::minmax(a, b));
    return known == places_.end() ? "/contacts" : known->second;
  }

 private:
  void read_contact(Fields& fields, std::size_t i) {
    const std::string place = "/contacts/" + std::to_string(i);
    const json& names = fields.required("materials");
    if (!names.is_array() || names.size() != 2) {
      throw FormatError(fields.at("materials"), "expected the names of two materials" + found(names));
    }
    const std::size_t a = material_named(names[0], fields.at("materials") + "/0");
    const std::size_t b = material_named(names[1], fields.at("materials") + "/1");
    const auto [known, is_new] = places_.emplace(std::minmax(a, b), place);
    if (!is_new) {
      throw FormatError(place, "expected each pair of materials once, but this repeats the pair of " + known->second);
    }
    MaterialPair pair;
    read_optional(fields, "restitution", pair.restitution);
    read_optional(fields, "friction", pair.friction);
    read_optional(fields, "tangential_restitution", pair.tangential_restitution);
    read_optional(fields, "rolling_resistance", pair.rolling_resistance);
    read_optional(fields, "spinning_resistance", pair.spinning_resistance);
    scene_.pairs.set(a, b, pair);
  }

  [[nodiscard]] std::size_t material_named(const json& name, const std::string& place) const {
    const auto known = name.is_string() ? indices_.find(name.get_ref<const std::string&>()) : indices_.end();
    if (known == indices_.end()) {
      std::string names;
      for (const std::string& material : scene_.materials) {
        names += (names.empty() ? "" : ", ") + json(material).dump();
      }
      throw FormatError(place, "expected one of the materials " + names + found(name));
    }
    return known->second;
  }

  void require_contact(std::size_t a, std::size_t b, const std::string& body_a, const std::string& body_b) const {
    if (!places_.contains(std::minmax(a, b))) {
      throw FormatError("/contacts", "expected an entry for the materials " + json(scene_.materials[a]).dump() +
                                         " and " + json(scene_.materials[b]).dump() + ", of " + body_a + " and " +
                                         body_b);
    }
  }

  Scene& scene_;
  std::map<std::string, std::size_t> indices_;
  bool has_contacts_ = false;
  std::map<std::pair<std::size_t, std::size_t>, std::string> places_;  // the key is a sorted pair of material indices
};

class SceneReader {
 public:
  explicit SceneReader(const json& value) : json_(value), root_(value, {}), materials_(scene_) {}

  [[nodiscard]] Scene scene() {
    read_settings();
    materials_.read_materials(root_);
    read_room();
    read_planes();
    read_spheres();
    read_lattices();
    read_polyhedra();
    root_.reject_others();
    materials_.check_all_listed();
    // Spheres among polyhedra must be apart by more.
    if (has_valid_fields(scene_)) {
      scene_.polyhedra.empty() ? move_apart(scene_) : move_bodies_apart(scene_);
    }
    if (const std::optional<SceneDefect> defect = first_defect(scene_)) {
      reject(*defect);
    }
    if (const std::optional<SceneDefect> defect = first_polyhedron_defect(scene_)) {
      reject(*defect);
    }
    return std::move(scene_);
  }

 private:
  void read_settings() {
    read_optional(root_, "title", scene_.title);
    scene_.law = Law::rough;
    if (root_.has("law")) {
      scene_.law = law_of(root_.required("law"));
    }
    if (root_.has("precision")) {
      scene_.precision = precision_of_name(root_.required("precision"));
    }
    read(root_, "duration", scene_.duration);
    read_optional(root_, "gravity", scene_.gravity);
    read_optional(root_, "capture_height", scene_.capture_height);
  }

  [[nodiscard]] static Law law_of(const json& value) {
    const std::optional<Law> law = value.is_string() ? law_named(value.get_ref<const std::string&>()) : std::nullopt;
    if (!law || *law == Law::any) {
      throw FormatError("/law", "expected frictionless, reflection, sticking, rough or coulomb" + found(value));
    }
    return *law;
  }

  [[nodiscard]] static Precision precision_of_name(const json& value) {
    for (const Precision precision : {Precision::binary32, Precision::binary64, Precision::extended}) {
      if (value == name_of(precision)) {
        return precision;
      }
    }
    throw FormatError("/precision", "expected binary32, binary64 or extended" + found(value));
  }

  void read_room() {
    if (!root_.has("room")) {
      return;
    }
    Fields room(root_.required("room"), "/room");
    Vector3<double> least;
    Vector3<double> greatest;
    read(room, "least", least);
    read(room, "greatest", greatest);
    const std::size_t material = materials_.material_of(room);
    room.reject_others();
    for (int axis = 0; axis < 3; ++axis) {
      const std::string letter(1, "xyz"[axis]);
      if (!(least[axis] < greatest[axis])) {
        const std::string place = "/" + std::to_string(axis);
        throw FormatError("/room/greatest" + place,
                          "expected a number greater than /room/least" + place +
                              found(root_.required("room").at("greatest").at(static_cast<std::size_t>(axis))));
      }
      Vector3<double> inward{0, 0, 0};
      inward[axis] = 1;
      scene_.planes.push_back({"room -" + letter, material, inward, least});
      scene_.planes.push_back({"room +" + letter, material, Vector3<double>::Zero() - inward, greatest});
    }
    planes_of_room_ = scene_.planes.size();
  }

  void read_planes() {
    const json& list = read_list(root_, "planes");
    if (list.size() > most_planes) {
      throw FormatError("/planes", "expected at most " + std::to_string(most_planes) + " planes, found " +
                                       std::to_string(list.size()));
    }
    for_each_in(root_, "planes", [&](Fields& fields, std::size_t i) {
      Plane plane;
      plane.name = "plane " + std::to_string(i);
      read_optional(fields, "name", plane.name);
      read(fields, "normal", plane.normal);
      read(fields, "point", plane.point);
      plane.material = materials_.material_of(fields);
      scene_.planes.push_back(std::move(plane));
    });
  }

  void read_spheres() {
    const std::size_t count = read_list(root_, "spheres").size();
    require_room_for(count, "/spheres");
    scene_.spheres.reserve(count);
    for_each_in(root_, "spheres", [&](Fields& fields, std::size_t i) {
      Sphere sphere;
      sphere.name = "sphere " + std::to_string(i);
      read_optional(fields, "name", sphere.name);
      read_substance(fields, sphere);
      read(fields, "position", sphere.position);
      read_optional(fields, "velocity", sphere.velocity);
      read_optional(fields, "angular_velocity", sphere.angular_velocity);
      scene_.spheres.push_back(std::move(sphere));
    });
  }

  void read_polyhedra() {
    const json& list = read_list(root_, "polyhedra");
    if (!list.empty() && scene_.spheres.size() + list.size() > most_bodies_with_polyhedra) {
      throw FormatError("/polyhedra", "expected at most " + std::to_string(most_bodies_with_polyhedra) +
                                          " bodies in a scene with polyhedra, found " +
                                          std::to_string(scene_.spheres.size() + list.size()));
    }
    for_each_in(root_, "polyhedra", [&](Fields& fields, std::size_t i) {
      Polyhedron polyhedron;
      polyhedron.name = "polyhedron " + std::to_string(i);
      read_optional(fields, "name", polyhedron.name);
      read_vertices(fields, polyhedron);
      read(fields, "density", polyhedron.density);
      polyhedron.material = materials_.material_of(fields);
      read(fields, "position", polyhedron.position);
      read_optional(fields, "orientation", polyhedron.orientation);
      read_optional(fields, "velocity", polyhedron.velocity);
      read_optional(fields, "angular_velocity", polyhedron.angular_velocity);
      scene_.polyhedra.push_back(std::move(polyhedron));
    });
  }

  static void read_vertices(Fields& fields, Polyhedron& polyhedron) {
    const json& list = fields.required("vertices");
    if (!list.is_array()) {
      throw FormatError(fields.at("vertices"), "expected an array" + found(list));
    }
    if (list.size() < 4 || list.size() > most_vertices) {
      throw FormatError(fields.at("vertices"), "expected 4 to " + std::to_string(most_vertices) + " points, found " +
                                                   std::to_string(list.size()));
    }
    for (std::size_t k = 0; k < list.size(); ++k) {
      polyhedron.vertices.push_back(finite_vector<3>(list[k], fields.at("vertices") + '/' + std::to_string(k)));
    }
  }

  void read_substance(Fields& fields, Sphere& sphere) const {
    read(fields, "radius", sphere.radius);
    read(fields, "density", sphere.density);
    sphere.material = materials_.material_of(fields);
  }

  void read_lattices() {
    for_each_in(root_, "lattices", [&](Fields& fields, std::size_t i) {
      Lattice lattice;
      read_count(fields, lattice);
      read(fields, "first", lattice.first);
      read(fields, "spacing", lattice.spacing);
      lattice.sphere.name = "lattice " + std::to_string(i) + " sphere";
      read_optional(fields, "name", lattice.sphere.name);
      read_substance(fields, lattice.sphere);
      read_optional(fields, "speed", lattice.speed);
      if (lattice.speed < 0) {
        throw FormatError(fields.at("speed"), "expected a number of at least 0" + found(fields.required("speed")));
      }
      read_optional(fields, "seed", lattice.seed);
      read_optional(fields, "at_rest_as_a_whole", lattice.at_rest_as_a_whole);
      first_of_lattices_.push_back(scene_.spheres.size());
      const std::vector<Sphere> spheres = spheres_of(lattice);
      scene_.spheres.insert(scene_.spheres.end(), spheres.begin(), spheres.end());
    });
  }

  void read_count(Fields& fields, Lattice& lattice) const {
    const json& counts = fields.required("count");
    const auto is_count = [](const json& value) {
      return value.is_number_integer() && (value.is_number_unsigned() || value.get<std::int64_t>() > 0) &&
             value.get<std::uint64_t>() > 0;
    };
    if (!counts.is_array() || counts.size() != 3 || !std::all_of(counts.begin(), counts.end(), is_count)) {
      throw FormatError(fields.at("count"), "expected three integers of at least 1" + found(counts));
    }
    std::size_t total = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      // The limits keep every product within 64 bits.
      const std::uint64_t count = std::min<std::uint64_t>(counts[axis].get<std::uint64_t>(), most_spheres + 1);
      lattice.count[axis] = count;
      total = std::min(total * count, most_spheres + 1);
    }
    require_room_for(total, fields.at("count"));
  }

  void require_room_for(std::size_t further, const std::string& place) const {
    if (scene_.spheres.size() + further > most_spheres) {
      throw FormatError(place, "expected at most " + std::to_string(most_spheres) + " spheres in total");
    }
  }

  [[nodiscard]] std::string place_of(const SceneDefect& defect) const {
    switch (defect.of) {
      case SceneDefect::Of::scene:
        break;
      case SceneDefect::Of::pair:
        return materials_.place_of(defect.index, defect.other);
      case SceneDefect::Of::plane:
        return defect.index < planes_of_room_ ? "/room" : "/planes/" + std::to_string(defect.index - planes_of_room_);
      case SceneDefect::Of::polyhedron:
        return "/polyhedra/" + std::to_string(defect.index);
      case SceneDefect::Of::sphere: {
        const auto lattice = std::upper_bound(first_of_lattices_.begin(), first_of_lattices_.end(), defect.index);
        return lattice == first_of_lattices_.begin()
                   ? "/spheres/" + std::to_string(defect.index)
                   : "/lattices/" + std::to_string(lattice - first_of_lattices_.begin() - 1);
      }
    }
    return {};
  }

  [[noreturn]] void reject(const SceneDefect& defect) const {
    const std::string body = place_of(defect);
    const std::string place = body + '/' + defect.field;
    const json::json_pointer pointer(place);
    if (defect.field.empty() || !json_.contains(pointer)) {
      // The spheres of a lattice have fields that the file does not contain.
      throw FormatError(body, defect.field.empty() ? defect.what : describe(defect));
    }
    throw FormatError(place, defect.what + found(json_.at(pointer)));
  }

  const json& json_;
  Scene scene_;
  Fields root_;
  MaterialsReader materials_;
  std::size_t planes_of_room_ = 0;
  std::vector<std::size_t> first_of_lattices_;  // the index of the first sphere of each lattice
};

json contacts_to_json(const Scene& scene) {
  json contacts = json::array();
  for (std::size_t a = 0; a < scene.materials.size(); ++a) {
    for (std::size_t b = a; b < scene.materials.size(); ++b) {
      const MaterialPair& pair = scene.pairs.of(a, b);
      contacts.push_back({{"materials", {scene.materials[a], scene.materials[b]}},
                          {"restitution", pair.restitution},
                          {"friction", pair.friction},
                          {"tangential_restitution", pair.tangential_restitution},
                          {"rolling_resistance", pair.rolling_resistance},
                          {"spinning_resistance", pair.spinning_resistance}});
    }
  }
  return contacts;
}

json polyhedra_to_json(const Scene& scene) {
  json polyhedra = json::array();
  for (const Polyhedron& polyhedron : scene.polyhedra) {
    json vertices = json::array();
    for (const Vector3<double>& vertex : polyhedron.vertices) {
      vertices.push_back(vector_to_json(vertex));
    }
    const Quaternion<double>& q = polyhedron.orientation;
    polyhedra.push_back({{"name", polyhedron.name},
                         {"vertices", vertices},
                         {"density", polyhedron.density},
                         {"material", scene.materials[polyhedron.material]},
                         {"position", vector_to_json(polyhedron.position)},
                         {"orientation", {q[0], q[1], q[2], q[3]}},
                         {"velocity", vector_to_json(polyhedron.velocity)},
                         {"angular_velocity", vector_to_json(polyhedron.angular_velocity)}});
  }
  return polyhedra;
}

}  // namespace

Scene scene_from_json(const json& value) { return SceneReader(value).scene(); }

json scene_to_json(const Scene& scene) {
  CAROM_EXPECTS(has_valid_fields(scene));
  json result = json::object();
  if (!scene.title.empty()) {
    result["title"] = scene.title;
  }
  result["law"] = name_of(scene.law);
  result["precision"] = name_of(scene.precision);
  result["duration"] = scene.duration;
  result["gravity"] = vector_to_json(scene.gravity);
  result["capture_height"] = scene.capture_height;
  result["materials"] = scene.materials;
  result["contacts"] = contacts_to_json(scene);
  json& planes = result["planes"] = json::array();
  for (const Plane& plane : scene.planes) {
    planes.push_back({{"name", plane.name},
                      {"material", scene.materials[plane.material]},
                      {"normal", vector_to_json(plane.normal)},
                      {"point", vector_to_json(plane.point)}});
  }
  json& spheres = result["spheres"] = json::array();
  for (const Sphere& sphere : scene.spheres) {
    spheres.push_back({{"name", sphere.name},
                       {"radius", sphere.radius},
                       {"density", sphere.density},
                       {"material", scene.materials[sphere.material]},
                       {"position", vector_to_json(sphere.position)},
                       {"velocity", vector_to_json(sphere.velocity)},
                       {"angular_velocity", vector_to_json(sphere.angular_velocity)}});
  }
  if (!scene.polyhedra.empty()) {
    result["polyhedra"] = polyhedra_to_json(scene);
  }
  return result;
}

}  // namespace carom::scene
