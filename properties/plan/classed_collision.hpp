// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/collision/collision.hpp>

namespace carom::properties::plan {

/// A collision that a plan must serve.
struct ClassedCollision {
  std::string contact_class;  // empty: `contact_class_of` names one
  Collision collision;
  std::string place = {};          // its source, "FILE:7", for messages
  bool is_normal_derived = false;  // from the bodies' positions, so its length is not a user's mistake
};

}  // namespace carom::properties::plan
