// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <limits>

#include <carom/properties/cases/body_pairs.hpp>
#include <carom/properties/cases/invalid.hpp>

namespace carom::properties {
namespace {

void make_not_finite(Stream& stream, Collision& collision) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr std::array not_finite{std::numeric_limits<double>::quiet_NaN(), infinity, -infinity};
  const double value = not_finite.at(static_cast<std::size_t>(stream.integer(0, 2)));
  int count = 0;
  for_each_number([&](const FieldPath&, double&) { ++count; }, collision);
  int chosen = stream.integer(0, count - 1);
  for_each_number(
      [&](const FieldPath&, double& number) {
        if (chosen-- == 0) {
          number = value;
        }
      },
      collision);
}

void put_out_of_range(Stream& stream, Collision& c) {
  Body& body = stream.chance(2) ? c.a : c.b;
  const double zero_or_less = stream.chance(2) ? 0 : -stream.between(0.125, 8);
  switch (stream.integer(0, 7)) {
    case 0:
      body.mass = zero_or_less;
      break;
    case 1:
      body.principal_inertia[stream.integer(0, 2)] = zero_or_less;
      break;
    case 2:
      body.orientation.setZero();
      break;
    case 3:
      c.normal.setZero();
      break;
    case 4:
      c.restitution = -stream.between(0.125, 8);
      break;
    case 5:
      c.restitution = 1 + stream.between(0.125, 8);
      break;
    case 6:
      c.friction = -stream.between(0.125, 8);
      break;
    default:
      c.tangential_restitution = 1 + stream.between(0.125, 8);
      if (!stream.chance(2)) {
        c.tangential_restitution = -c.tangential_restitution;
      }
  }
}

}  // namespace

Case invalid(Stream& stream) {
  Case result = general_bodies(stream);
  if (stream.chance(2)) {
    make_not_finite(stream, result.collision);
  } else {
    put_out_of_range(stream, result.collision);
  }
  return result;
}

}  // namespace carom::properties
