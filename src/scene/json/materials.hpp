// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include <carom/scene/json/fields.hpp>
#include <carom/scene/scene.hpp>

namespace carom::scene {

/// The materials of a scene file and how they meet.
class MaterialsReader {
 public:
  /// The scene is the one that is being read, and outlives the reader.
  explicit MaterialsReader(Scene& scene) : scene_(scene) {}

  /// Reads "materials" and "contacts" into the scene. Throws FormatError.
  void read(Fields& root);

  /// The field "material" of a body, which may be absent where there is one material.
  [[nodiscard]] std::size_t material_of(Fields& body) const;

  /// Once all bodies are read: throws FormatError where two can meet whose materials "contacts" does not list.
  void check_all_listed() const;

  /// The place of a listed pair of materials.
  [[nodiscard]] std::string place_of(std::size_t a, std::size_t b) const;

 private:
  void read_contact(const nlohmann::json& value, const std::string& place);
  [[nodiscard]] std::size_t material_named(const nlohmann::json& name, const std::string& place) const;

  Scene& scene_;
  std::map<std::string, std::size_t> indices_;
  bool has_contacts_ = false;
  std::map<std::pair<std::size_t, std::size_t>, std::string> places_;  // of pairs in order
};

}  // namespace carom::scene
