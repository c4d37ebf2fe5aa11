// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include <carom/scene/json/fields.hpp>
#include <carom/scene/scene.hpp>

namespace carom::scene {

/// Reads the materials of a scene file and the properties of their pairs.
class MaterialsReader {
 public:
  /// `scene` is the scene that is being read. It must outlive the reader.
  explicit MaterialsReader(Scene& scene) : scene_(scene) {}

  /// Reads "materials" and "contacts" into the scene. Throws FormatError.
  void read(Fields& root);

  /// The index of the material of a body. The field "material" may be absent if there is only one material. Throws
  /// FormatError.
  [[nodiscard]] std::size_t material_of(Fields& body) const;

  /// Call after all bodies are read. If the file has "contacts", throws FormatError if two bodies can meet whose pair
  /// of materials is not listed there.
  void check_all_listed() const;

  /// The place of a pair of materials in the file; "/contacts" if the pair is not listed.
  [[nodiscard]] std::string place_of(std::size_t a, std::size_t b) const;

 private:
  void read_contact(const nlohmann::json& value, const std::string& place);
  [[nodiscard]] std::size_t material_named(const nlohmann::json& name, const std::string& place) const;

  Scene& scene_;
  std::map<std::string, std::size_t> indices_;
  bool has_contacts_ = false;
  std::map<std::pair<std::size_t, std::size_t>, std::string> places_;  // the key is a sorted pair of material indices
};

}  // namespace carom::scene
