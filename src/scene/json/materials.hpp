// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include <carom/scene/json/fields.hpp>
#include <carom/scene/scene.hpp>

namespace carom::scene {

class MaterialsReader {
 public:
  /// The scene must outlive the reader.
  explicit MaterialsReader(Scene& scene) : scene_(scene) {}

  /// Reads "materials" and "contacts" into the scene. Throws FormatError.
  void read(Fields& root);

  /// The index of a body's material. Throws FormatError.
  [[nodiscard]] std::size_t material_of(Fields& body) const;

  /// Call after all bodies are read. Throws FormatError if the file has "contacts", but no contact for the materials of
  /// two bodies that can meet.
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
