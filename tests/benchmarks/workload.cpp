// SPDX-License-Identifier: BSL-1.0
#include "workload.hpp"

#include <cstdint>
#include <span>
#include <utility>

#include <carom/properties/cases/beyond_domain.hpp>
#include <carom/properties/cases/body_pairs.hpp>
#include <carom/properties/draws/stream.hpp>

namespace carom::benchmarks {

namespace {

template <class Generate>
std::vector<Collision> colliding_of(const Generate& generate, std::size_t count) {
  std::vector<Collision> collisions;
  for (std::uint64_t i = 0; collisions.size() < count; ++i) {
    properties::Stream stream = properties::case_stream(1, "benchmarks", i);
    const Collision collision = generate(stream).collision;
    const auto contact = impulse::make_contact<double>(collision);
    if (is_colliding(contact, normal_velocity(contact))) {
      collisions.push_back(collision);
    }
  }
  return collisions;
}

}  // namespace

std::vector<Collision> colliding(std::size_t count) { return colliding_of(properties::general_bodies, count); }

std::vector<Collision> colliding_slender(std::size_t count) { return colliding_of(properties::convex_bodies, count); }

std::vector<Collision> colliding_tips(std::size_t count) { return colliding_of(properties::needle_tip, count); }

std::vector<Collision> colliding_spheres(std::size_t count) {
  return colliding_of(properties::touching_spheres, count);
}

void triad(Workload<double>& workload) {
  std::vector<std::span<const double>> from;
  auto contacts = std::as_const(workload.contacts).arrays();
  impulse::for_each_array(contacts, [&](const std::span<const double>& array) { from.push_back(array); });
  std::size_t k = 0;
  auto outcomes = workload.outcomes.arrays();
  impulse::for_each_array(outcomes, [&](const std::span<double>& array) {
    const double* x = from[2 * k].data();
    const double* y = from[2 * k + 1].data();
    double* z = array.data();
    for (std::size_t i = 0; i < array.size(); ++i) {
      z[i] = x[i] + 3 * y[i];
    }
    ++k;
  });
}

}  // namespace carom::benchmarks
