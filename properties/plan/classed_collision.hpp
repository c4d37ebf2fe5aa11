// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/collision/collision.hpp>

namespace carom::properties::plan {

/// A collision that a plan is to serve, and the class of contacts that it belongs to.
struct ClassedCollision {
  std::string contact_class;  // empty: `contact_class_of` names one
  Collision collision;
  std::string place = {};          // where it was read, "FILE:7", for what is said of it
  bool is_normal_derived = false;  // from where the bodies are: its length is nobody's mistake
};

}  // namespace carom::properties::plan
