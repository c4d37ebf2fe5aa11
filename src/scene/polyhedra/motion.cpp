// SPDX-License-Identifier: GPL-3.0-or-later
#include <carom/scene/polyhedra/motion.hpp>

namespace carom::scene {

Placement placement_at(const Motion& motion, double time) {
  const BoundedRotation rotation = motion.rotation.at(time);
  const Vector3<double> moved = time * (motion.velocity + time / 2 * motion.acceleration);
  const double terms = motion.position.norm() + time * (motion.velocity.norm() + time / 2 * motion.acceleration.norm());
  return {rotation.state.orientation, motion.position + moved, rotation.angle_error, 0x1p-50 * terms};
}

}  // namespace carom::scene
