// SPDX-License-Identifier: BSL-1.0
#include <algorithm>

#include <carom/collision/expects.hpp>
#include <carom/scene/polyhedra/free_flight.hpp>

namespace carom::scene {

BoundedRotation rotation_at(const FreeFlight& motion, double time) {
  CAROM_EXPECTS(motion.start <= time && time <= motion.end(), time, motion.start, motion.end());
  const double elapsed = std::min(time - motion.start, motion.rotation.duration());
  BoundedRotation rotation = motion.rotation.at(elapsed);
  if (motion.start != 0) {
    rotation.angle_error += 0x1p-52 * elapsed * motion.rotation.greatest_rate();
    rotation.rate_error += 0x1p-52 * elapsed * motion.rotation.greatest_rate() * motion.rotation.greatest_rate() *
                           motion.rotation.greatest_turning();
  }
  return rotation;
}

Placement placement_at(const FreeFlight& motion, double time) {
  const double elapsed = time - motion.start;
  const BoundedRotation rotation = rotation_at(motion, time);
  const Vector3<double> moved = elapsed * (motion.velocity + elapsed / 2 * motion.acceleration);
  const double terms =
      motion.position.norm() + elapsed * (motion.velocity.norm() + elapsed / 2 * motion.acceleration.norm());
  return {rotation.state.orientation, motion.position + moved, rotation.angle_error, 0x1p-49 * terms};
}

}  // namespace carom::scene
