// SPDX-License-Identifier: BSL-1.0
#include <carom/oracles/bounds/enclosure.hpp>
#include <carom/oracles/motion/sliding.hpp>

namespace carom::oracles {
namespace {

Enclosure deceleration(const Slide& slide) { return Enclosure(slide.friction) * Enclosure(slide.gravity); }

/// Whether x < y. Both sides of the border have the same answers, so an undecided order may be either.
bool is_less(const Enclosure& x, const Enclosure& y) { return x.middle() < y.middle(); }

/// The distance after `time`, with v₀ before `end` under μ g, and `speed` after it.
Enclosure distance(const Slide& slide, const Enclosure& time, const Enclosure& end, const Enclosure& speed) {
  const Enclosure slowed = is_less(time, end) ? time : end;
  const Enclosure in_slide = slowed * (Enclosure(slide.speed) - deceleration(slide) * slowed / Enclosure(2));
  return is_less(time, end) ? in_slide : in_slide + speed * (time - end);
}

Enclosure stop(const Slide& slide) { return Enclosure(slide.speed) / deceleration(slide); }

/// k = J / (m R²).
Enclosure shape_factor(const SlideToRoll& roll) {
  return Enclosure(roll.inertia) / (Enclosure(roll.mass) * Enclosure(roll.radius) * Enclosure(roll.radius));
}

Enclosure rolls_from(const SlideToRoll& roll) {
  const Enclosure k = shape_factor(roll);
  return stop(roll.slide) * k / (Enclosure(1) + k);
}

Enclosure rolling_speed(const SlideToRoll& roll) {
  return Enclosure(roll.slide.speed) / (Enclosure(1) + shape_factor(roll));
}

}  // namespace

Known slide_speed(const Slide& slide, const StepTime& time) {
  const Enclosure t = exact(time);
  return is_less(t, stop(slide)) ? known(Enclosure(slide.speed) - deceleration(slide) * t) : Known{};
}

Known slide_distance(const Slide& slide, const StepTime& time) {
  return known(distance(slide, exact(time), stop(slide), Enclosure(0)));
}

Known rolling_time(const SlideToRoll& roll) { return known(rolls_from(roll)); }

Known roll_speed(const SlideToRoll& roll, const StepTime& time) {
  const Enclosure t = exact(time);
  return known(is_less(t, rolls_from(roll)) ? Enclosure(roll.slide.speed) - deceleration(roll.slide) * t
                                            : rolling_speed(roll));
}

Known roll_spin(const SlideToRoll& roll, const StepTime& time) {
  const Enclosure t = exact(time);
  return known(is_less(t, rolls_from(roll)) ? deceleration(roll.slide) * t / shape_factor(roll) : rolling_speed(roll));
}

Known roll_distance(const SlideToRoll& roll, const StepTime& time) {
  return known(distance(roll.slide, exact(time), rolls_from(roll), rolling_speed(roll)));
}

Known slope_acceleration(double along, double into, double friction) {
  const Enclosure excess = Enclosure(along) - Enclosure(friction) * Enclosure(into);
  return excess.sign().value() > 0 ? known(excess) : Known{};
}

}  // namespace carom::oracles
