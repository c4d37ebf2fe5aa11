// SPDX-License-Identifier: BSL-1.0
#include "case_bytes.hpp"

#include <bit>

namespace carom::fuzz {
namespace {

constexpr std::uint8_t first_beyond_domain = 120;
constexpr std::uint8_t first_of_numbers = 128;
constexpr std::uint8_t a_is_immovable = 1;
constexpr std::uint8_t b_is_immovable = 2;

void append(std::vector<std::uint8_t>& bytes, std::uint64_t word) {
  for (std::size_t i = 0; i < sizeof word; ++i) {
    bytes.push_back(static_cast<std::uint8_t>(word >> 8U * i));
  }
}

Collision collision_from(Input& input) {
  Collision collision;
  const std::uint8_t immovable = input.byte();
  collision.a.immovable = (immovable & a_is_immovable) != 0;
  collision.b.immovable = (immovable & b_is_immovable) != 0;
  for_each_number([&](const FieldPath&, double& number) { number = input.number(); }, collision);
  return collision;
}

}  // namespace

ReadCase case_from(Input& input) {
  const std::uint8_t form = input.byte();
  if (form >= first_of_numbers) {
    return {{collision_from(input), false}, false};
  }
  properties::Stream stream = input.stream();
  if (form >= first_beyond_domain) {
    const auto beyond = properties::families_beyond_domain();
    return {beyond[(form - first_beyond_domain) % beyond.size()].generate(stream), false};
  }
  const auto families = properties::all_families();
  return {families[form % families.size()].generate(stream), true};
}

namespace {

std::vector<std::uint8_t> drawn_bytes(std::size_t form, const properties::Family& drawn, std::uint64_t index) {
  std::vector<std::uint8_t> bytes{static_cast<std::uint8_t>(form)};
  properties::Stream integers = properties::case_stream(1, drawn.name, index);
  properties::Stream noted([&] {
    const std::uint64_t word = integers.bits();
    append(bytes, word);
    return word;
  });
  (void)drawn.generate(noted);
  return bytes;
}

}  // namespace

std::vector<std::uint8_t> bytes_of_family(std::size_t family, std::uint64_t index) {
  return drawn_bytes(family, properties::all_families()[family], index);
}

std::vector<std::uint8_t> bytes_beyond_domain(std::size_t family, std::uint64_t index) {
  return drawn_bytes(first_beyond_domain + family, properties::families_beyond_domain()[family], index);
}

std::vector<std::uint8_t> bytes_of(const Collision& collision) {
  const int immovable = (collision.a.immovable ? a_is_immovable : 0) | (collision.b.immovable ? b_is_immovable : 0);
  std::vector<std::uint8_t> bytes{first_of_numbers, static_cast<std::uint8_t>(immovable)};
  for_each_number([&](const FieldPath&, const double& number) { append(bytes, std::bit_cast<std::uint64_t>(number)); },
                  collision);
  return bytes;
}

}  // namespace carom::fuzz
