// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <carom/properties/phenomena/measure.hpp>
#include <carom/properties/phenomena/posing.hpp>
#include <carom/properties/phenomena/relations.hpp>

namespace carom::properties {
namespace {

using namespace posing;

constexpr double duration = 2;
constexpr double saved_at = 1;
constexpr double between_reports = 0.05;
constexpr double moved_by = 8;      // [m] to the right
constexpr double tolerance = 1e-3;  // [m] and [rad]

/// Maps a body by a permutation of the axes with signs, which rounds nothing.
void map_body(SteppedBody& body, const Matrix3<double>& axes) {
  const Matrix3<double> of_axial = axes.determinant() * axes;
  const Matrix3<double> of_lengths = axes.cwiseAbs();
  BodyState& state = body.state;
  state.position = axes * state.position;
  state.velocity = axes * state.velocity;
  state.angular_velocity = of_axial * state.angular_velocity;
  state.orientation.tail<3>() = of_axial * Vector3<double>(state.orientation.tail<3>());
  body.principal_inertia = of_lengths * body.principal_inertia;
  if (auto* box = std::get_if<BoxShape>(&body.shape)) {
    box->lengths = of_lengths * box->lengths;
  }
}

/// A heap that is related to the heap, and how its states are mapped back: without rounding, but for `translation`.
struct RelatedHeap {
  std::string_view name;
  std::string_view change;
  std::function<void(Stepping&)> to;
  std::function<void(std::vector<BodyState>&)> back;
};

/// A heap whose axes are mapped. Body 0 is the floor. It keeps its place, because it has no sides.
RelatedHeap mapped(std::string_view name, std::string_view change, const Matrix3<double>& axes) {
  return {name, change,
          [axes](Stepping& heap) {
            std::for_each(heap.scene.bodies.begin() + 1, heap.scene.bodies.end(),
                          [&](SteppedBody& body) { map_body(body, axes); });
          },
          [axes](std::vector<BodyState>& states) {
            std::for_each(states.begin(), states.end(), [&](BodyState& state) {
              SteppedBody body{SphereShape{1}, false, 1, {1, 1, 1}, state};
              map_body(body, axes.transpose());
              state = body.state;
            });
          }};
}

std::vector<RelatedHeap> related_heaps(const Stepper& stepper) {
  const bool planar = stepper.is_planar;
  const auto nothing = [](auto&) {};
  std::vector<RelatedHeap> all{
      {"memoryless", "run twice", nothing, nothing},
      {"swap", "with the bodies in another order",
       [](Stepping& heap) { std::reverse(heap.scene.bodies.begin() + 1, heap.scene.bodies.end()); },
       [](std::vector<BodyState>& states) { std::reverse(states.begin() + 1, states.end()); }},
      mapped("reflection_symmetry", "mirrored in x = 0", Vector3<double>(-1, 1, 1).asDiagonal()),
      {"translation", "moved by 8 m",
       [](Stepping& heap) {
         std::for_each(heap.scene.bodies.begin() + 1, heap.scene.bodies.end(),
                       [](SteppedBody& body) { body.state.position[0] += moved_by; });
       },
       [](std::vector<BodyState>& states) {
         std::for_each(states.begin() + 1, states.end(), [](BodyState& state) { state.position[0] -= moved_by; });
       }},
      {"local", "with a bystander 64 m away",
       [planar](Stepping& heap) {
         SteppedBody bystander = ball(directions(planar), 0.5);
         bystander.state.position = directions(planar).at(64, 32);  // it does not land within two seconds
         heap.scene.bodies.push_back(bystander);
       },
       [](std::vector<BodyState>& states) { states.pop_back(); }}};
  if (!planar) {
    const Matrix3<double> x_to_y{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}};
    all.push_back(mapped("rotation", "turned by 90° about the vertical", x_to_y));
  }
  if (stepper.restores) {
    all.push_back({"restored", "saved at 1 s, run to the end, and restored",
                   [](Stepping& heap) { heap.restored = steps_to(saved_at, heap.step); }, nothing});
  }
  return all;
}

bool is_same(const BodyState& x, const BodyState& y) {
  return x.position == y.position && x.orientation == y.orientation && x.velocity == y.velocity &&
         x.angular_velocity == y.angular_velocity;
}

double difference(const BodyState& x, const BodyState& y) {
  return std::max((x.position - y.position).norm(), turn_between(x.orientation, y.orientation));
}

void compare(RelationResult& result, const Stepping& stepping, const SteppedStates& first,
             const SteppedStates& second) {
  bool is_same_so_far = true;
  bool are_as_fast = true;
  double greatest = 0;
  for (std::size_t k = 0; k < stepping.report.size(); ++k) {
    const std::vector<BodyState>& x = first.states[k];
    const std::vector<BodyState>& y = second.states[k];
    result.time = stepping.step * static_cast<double>(stepping.report[k]);
    for (std::size_t i = 1; i < x.size(); ++i) {
      is_same_so_far = is_same_so_far && is_same(x[i], y[i]);
      are_as_fast = are_as_fast && x[i].velocity == y[i].velocity && x[i].angular_velocity == y[i].angular_velocity;
      greatest = std::max(greatest, difference(x[i], y[i]));
    }
    if (greatest > tolerance) {
      result.likeness = Likeness::differs;
      return;
    }
  }
  result.likeness = is_same_so_far                  ? Likeness::same_bits
                    : greatest == 0 && !are_as_fast ? Likeness::same_places
                                                    : Likeness::same_digits;
  result.digits = greatest > 0 ? static_cast<int>(std::floor(-std::log10(greatest))) : 16;
}

/// A ball hits a row of four balls that touch, at 1 m/s, without friction and gravity. Each bounce keeps the energy.
RelationResult row_of_balls(const Stepper& stepper, Stepper::Session& session, double step) {
  const Directions d = directions(stepper.is_planar);
  constexpr double radius = 0.1;
  constexpr double end = 1;  // after the impact at 0.3 s
  Stepping row{{{0, 0, 0}, 1, 0, false, {}}, step, report_at({end}, step)};
  for (int n = -1; n < 4; ++n) {
    SteppedBody one = ball(d, radius);
    one.state.position = (n < 0 ? -0.5 : n * 2 * radius) * d.right;
    one.state.velocity = (n < 0 ? 1 : 0) * d.right;
    row.scene.bodies.push_back(one);
  }
  RelationResult result{"energy", "a ball hits a row of balls, ε = 1", Likeness::unanswered, 0, end, {}};
  const auto answer = answer_of(stepper, session, row);
  if (const auto* states = std::get_if<SteppedStates>(&answer)) {
    for (std::size_t i = 0; i < row.scene.bodies.size(); ++i) {
      const BodyState& now = states->states.at(0)[i];
      const SteppedBody& posed = row.scene.bodies[i];  // twice its energy, because the energy before is half a joule
      result.energy += posed.mass * now.velocity.squaredNorm();
      result.energy += posed.principal_inertia.dot(now.angular_velocity.cwiseAbs2());
    }
    result.likeness = result.energy > 1 + tolerance ? Likeness::differs : Likeness::same_digits;
  } else {
    const auto& none = std::get<NoAnswer>(answer);
    result.why = none.why;
    result.is_failure = none.is_failure;
  }
  return result;
}

}  // namespace

SteppedScene heap(bool planar) {
  const Directions d = directions(planar);
  SteppedScene scene = on_the_floor(d);
  scene.restitution = 0.25;
  scene.friction = 0.5;
  // Multiples of 1/64 m, so that the related heaps are posed without rounding, in binary32 too.
  const auto offset = [](int n) { return (n % 11 - 5) / 64.0; };
  for (int n = 0; n < 20; ++n) {
    const int layer = n / 4;
    const double x = planar ? n % 4 - 1.5 : n % 2 - 0.5;
    const double y = n / 2 % 2 - 0.5;
    SteppedBody body = (n + layer) % 2 == 0 ? ball(d, 0.375) : block(d, 0.75, 0.5, 0.625, 1);
    body.state.position = (x + offset(7 * n)) * d.right + (1 + layer + offset(5 * n)) * d.up;
    if (!planar) {
      body.state.position += (y + offset(3 * n)) * d.across;
    }
    scene.bodies.push_back(body);
  }
  return scene;
}

std::vector<RelationResult> heap_relations(const Stepper& stepper, Stepper::Session& session, double step) {
  std::vector<double> times(static_cast<std::size_t>(std::lround(duration / between_reports)));
  for (std::size_t k = 0; k < times.size(); ++k) {
    times[k] = between_reports * static_cast<double>(k + 1);
  }
  const Stepping plain{heap(stepper.is_planar), step, report_at(times, step)};
  const auto first = answer_of(stepper, session, plain);
  std::vector<RelationResult> results;
  for (const RelatedHeap& related : related_heaps(stepper)) {
    RelationResult result{related.name, related.change, Likeness::unanswered, 0, 0, {}};
    Stepping changed = plain;
    related.to(changed);
    auto second = first.index() == 0 ? answer_of(stepper, session, changed) : first;
    if (auto* states = std::get_if<SteppedStates>(&second)) {
      std::for_each(states->states.begin(), states->states.end(), related.back);
      compare(result, plain, std::get<SteppedStates>(first), *states);
    } else {
      const auto& none = std::get<NoAnswer>(second);
      result.why = none.why;
      result.is_failure = none.is_failure;
    }
    results.push_back(std::move(result));
  }
  results.push_back(row_of_balls(stepper, session, step));
  return results;
}

std::string in_words(const RelationResult& result) {
  if (result.energy > 0) {
    return fmt::format("{:.3g} times the energy", result.energy);
  }
  switch (result.likeness) {
    case Likeness::same_bits:
      return "same bits";
    case Likeness::same_places:
      return fmt::format("same places, other velocities until {:.3g} s", result.time);
    case Likeness::same_digits:
      return fmt::format("same to {} digits until {:.3g} s", result.digits, result.time);
    case Likeness::differs:
      return fmt::format("differs from {:.3g} s on", result.time);
    case Likeness::unanswered:
      break;
  }
  return result.why;
}

}  // namespace carom::properties
