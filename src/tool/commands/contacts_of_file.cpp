// SPDX-License-Identifier: BSL-1.0
#include "commands/contacts_of_file.hpp"

#include <fmt/format.h>

#include <carom/collision/json/json.hpp>

#include "io/input_file.hpp"
#include "io/json_file.hpp"
#include "io/usage_error.hpp"

namespace carom::tool::plan {
namespace {

bool is_scene(const std::string& text) {
  try {
    const nlohmann::json json = parse_json(text);
    return json.is_object() && json.contains("duration");
  } catch (const FormatError&) {
    return false;  // JSON Lines, or a defect that the later reader reports better
  }
}

}  // namespace

RecordedContacts contacts_of_file(const std::string& file, const ContactsOfScene& contacts_of_scene,
                                  const std::stop_token& stop) {
  JsonFile read_file(file, stop);
  if (!read_file.is_lines() && is_scene(read_file.whole())) {
    if (!contacts_of_scene) {
      throw UsageError(fmt::format("{}: this file is a scene; to plan it, install carom-scene", file));
    }
    return contacts_of_scene(read_file.whole(), file, stop);
  }
  RecordedContacts recorded;
  for_each_collision(read_file, OutOfRange::kept, [&](const ReadCollision& read) {
    recorded.contacts.push_back({read.contact_class, read.one.collision, read.place});
  });
  return recorded;
}

}  // namespace carom::tool::plan
