// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/contacts_of_file.hpp"

#include "commands/input_file.hpp"

namespace carom::tool::plan {

std::vector<properties::plan::ClassedCollision> contacts_of_file(const std::string& file) {
  std::vector<properties::plan::ClassedCollision> contacts;
  for (const ReadCollision& read : read_collisions(file, OutOfRange::kept)) {
    contacts.push_back({read.contact_class, read.one.collision, read.place});
  }
  return contacts;
}

}  // namespace carom::tool::plan
