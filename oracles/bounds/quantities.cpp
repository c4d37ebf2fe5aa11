// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>

#include <carom/oracles/bounds/quantities.hpp>

namespace carom::oracles {

double extent_of(const Body& body) {
  if (body.immovable) {
    return 0;
  }
  const Vector3<double> half = body.principal_inertia / 2;
  const double least =
      std::min({half[1] + half[2] - half[0], half[2] + half[0] - half[1], half[0] + half[1] - half[2]});
  return least > 0 ? std::sqrt(least) / std::sqrt(body.mass) : 0;
}

std::vector<Quantity> quantities_of(const Collision& collision) {
  std::vector<Quantity> quantities;
  std::array<double, 48> numbers{};
  std::size_t count = 0;
  for_each_number(
      [&](const FieldPath& path, const double& number) {
        if (path.component <= 0 || path.field == "principal_inertia") {
          quantities.push_back({count, 0, 0});
        }
        Quantity& q = quantities.back();
        numbers.at(count++) = number;
        ++q.count;
        const bool is_whole_position = path.field == "position" && q.count == 3;
        q.length = is_whole_position ? extent_of(path.body == "a" ? collision.a : collision.b) : 0;
      },
      collision);
  for (Quantity& q : quantities) {
    q.length += root_of_squares(q.count, [&](std::size_t i) { return numbers.at(q.first + i); });
  }
  return quantities;
}

}  // namespace carom::oracles
