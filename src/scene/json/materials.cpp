// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <optional>
#include <vector>

#include <carom/scene/json/materials.hpp>
#include <carom/scene/json/scene_json.hpp>

namespace carom::scene {

using detail::found;
using nlohmann::json;

void MaterialsReader::read(Fields& root) {
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
  const json& contacts = read_list(root, "contacts");
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    read_contact(contacts[i], "/contacts/" + std::to_string(i));
  }
}

void MaterialsReader::read_contact(const json& value, const std::string& place) {
  Fields fields(value, place);
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
  fields.reject_others();
  scene_.pairs.set(a, b, pair);
}

std::size_t MaterialsReader::material_named(const json& name, const std::string& place) const {
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

std::size_t MaterialsReader::material_of(Fields& body) const {
  if (body.has("material")) {
    return material_named(body.required("material"), body.at("material"));
  }
  if (scene_.materials.size() > 1) {
    throw FormatError(body.at("material"),
                      "is missing; name one of the " + std::to_string(scene_.materials.size()) + " materials");
  }
  return 0;
}

void MaterialsReader::check_all_listed() const {
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
  const auto require = [&](std::size_t a, std::size_t b, const std::string& body_a, const std::string& body_b) {
    if (!places_.contains(std::minmax(a, b))) {
      throw FormatError("/contacts", "expected an entry for the materials " + json(scene_.materials[a]).dump() +
                                         " and " + json(scene_.materials[b]).dump() + ", of " + body_a + " and " +
                                         body_b);
    }
  };
  for (std::size_t a = 0; a < users.size(); ++a) {
    for (std::size_t b = 0; b < users.size() && !users[a].bodies.empty(); ++b) {
      if (b > a && !users[b].bodies.empty()) {
        require(a, b, users[a].bodies[0], users[b].bodies[0]);
      }
      if (b == a && users[a].bodies.size() > 1) {
        require(a, a, users[a].bodies[0], users[a].bodies[1]);
      }
      if (users[b].plane) {
        require(a, b, users[a].bodies[0], *users[b].plane);
      }
    }
  }
}

std::string MaterialsReader::place_of(std::size_t a, std::size_t b) const {
  const auto known = places_.find(std::minmax(a, b));
  return known == places_.end() ? "/contacts" : known->second;
}

}  // namespace carom::scene
