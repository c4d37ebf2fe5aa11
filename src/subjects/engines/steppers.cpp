// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <carom/subjects/protocol/exec_stepper.hpp>
#include <carom/subjects/steppers.hpp>

namespace carom::subjects {
namespace {

/// The steppers of an engine that this program was built without.
[[maybe_unused]] std::vector<Stepper> absent(const std::string& name, const std::string& package) {
  std::vector<Stepper> steppers;
  for (const char* const setting : {"", "-as-shipped"}) {
    Stepper stepper{name + setting};
    stepper.absent = package + " was not found when this program was built";
    steppers.push_back(std::move(stepper));
  }
  return steppers;
}

}  // namespace

std::vector<Stepper> all_steppers() {
  const std::array groups{
#ifdef CAROM_HAS_bullet
      bullet_steppers(),
#else
      absent("bullet", "libbullet-dev"),
#endif
#ifdef CAROM_HAS_ode
      ode_steppers(),
#else
      absent("ode", "libode-dev"),
#endif
#ifdef CAROM_HAS_box2d
      box2d_steppers(),
#else
      absent("box2d", "libbox2d-dev"),
#endif
      npm_steppers()};
  std::vector<Stepper> all;
  for (const std::vector<Stepper>& group : groups) {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}

Stepper started(const Stepper& stepper, const protocol::ExecOptions& options) {
  if (stepper.specification.empty() || !stepper.absent.empty()) {
    return stepper;
  }
  Stepper result = protocol::exec_stepper(stepper.specification, options);
  result.name = stepper.name;
  return result;
}

}  // namespace carom::subjects
