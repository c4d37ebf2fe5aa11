// SPDX-License-Identifier: BSL-1.0
#include <string_view>

#include <carom/collision/json/json.hpp>

#include "target.hpp"

namespace carom::fuzz {
namespace {

bool same_numbers(const Collision& x, const Collision& y) {
  bool same = x.a.immovable == y.a.immovable && x.b.immovable == y.b.immovable;
  for_each_number([&](const FieldPath&, const double& of_x, const double& of_y) { same &= same_number(of_x, of_y); }, x,
                  y);
  return same;
}

void read_collision(std::string_view text) {
  try {
    const nlohmann::json json = parse_json(text);
    require(json == nlohmann::json::parse(text), "parse_json reads another value than nlohmann::json::parse");
    const Collision collision = collision_from_json(json);
    const Collision again = collision_from_json(parse_json(collision_to_json(collision).dump()));
    require(same_numbers(collision, again), "a collision does not survive being written");
  } catch (const FormatError&) {
    return;
  }
}

}  // namespace
}  // namespace carom::fuzz

CAROM_FUZZ_TARGET(json_collision) {
  carom::fuzz::read_collision(carom::fuzz::Input({data, size}).text());
  return 0;
}
