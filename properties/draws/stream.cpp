// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <cmath>
#include <cstdlib>

#include <carom/properties/draws/stream.hpp>

namespace carom::properties {
namespace {

std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31U);
}

// Literals, because a library's powers need not round correctly.
constexpr std::array<double, 31> powers_of_ten{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10,
                                               1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21,
                                               1e22, 1e23, 1e24, 1e25, 1e26, 1e27, 1e28, 1e29, 1e30};

}  // namespace

std::string_view name_of(Adjustment adjustment) {
  constexpr PerAdjustment<std::string_view> names{"moments_enlarged", "moved_to_origin", "reversed", "drawn_again"};
  return names[adjustment];
}

std::uint64_t Stream::bits() {
  constexpr std::uint64_t half = std::uint64_t{1} << 32U;
  if (!answer_) {
    return next_();
  }
  const std::uint64_t high = below(half);
  return high * half + below(half);
}

int Stream::integer(int low, int high, int simplest) {
  const std::int64_t from = low;  // wide enough for every difference of two ints
  const auto count = static_cast<std::uint64_t>(high - from) + 1;
  return static_cast<int>(from + static_cast<std::int64_t>(below(count, static_cast<std::uint64_t>(simplest - from))));
}

double Stream::unit() {
  const bool is_short = integer(1, 8) == 1;
  if (is_short) {
    return integer(0, 7) / 8.0;
  }
  const std::uint64_t fraction = answer_ ? below(fractions) : next_() >> 11U;
  return static_cast<double>(fraction) / static_cast<double>(fractions);
}

double Stream::signed_unit() {
  const double magnitude = unit();
  return chance(2) ? -magnitude : magnitude;
}

double Stream::between(double low, double high) { return low + (high - low) * unit(); }

double Stream::power_of_two(int low, int high) { return std::ldexp(1.0, integer(low, high)); }

double power_of_ten(int k) {
  const double power = powers_of_ten.at(static_cast<std::size_t>(std::abs(k)));
  return k < 0 ? 1 / power : power;
}

double Stream::power_of_ten(int low, int high) { return properties::power_of_ten(integer(low, high)); }

Vector3<double> Stream::vector() {
  const double x = signed_unit();
  const double y = signed_unit();
  const double z = signed_unit();
  return {x, y, z};
}

Vector3<double> Stream::direction() {
  Vector3<double> result;
  if (chance(4)) {
    for (int i = 0; i < 3; ++i) {
      result[i] = integer(-3, 3);
    }
  } else {
    result = vector();
  }
  // Keeps the length at least 1/16, and so excludes zero.
  constexpr double short_length = 1.0 / 16;
  if ((result.array().abs() < short_length).all()) {
    result[integer(0, 2)] = 1;
  }
  return result;
}

Quaternion<double> Stream::quaternion() {
  Quaternion<double> result;
  for (int i = 0; i < 4; ++i) {
    result[i] = signed_unit();
  }
  constexpr double short_length = 1.0 / 8;
  if ((result.array().abs() < short_length).all()) {
    result[integer(0, 3)] = 1;
  }
  return result;
}

Stream stream_from(std::uint64_t seed) {
  return Stream([state = seed]() mutable {
    state += 0x9e3779b97f4a7c15U;
    return mixed(state);
  });
}

Stream case_stream(std::uint64_t seed, std::string_view family, std::uint64_t index) {
  std::uint64_t state = mixed(seed + 0x9e3779b97f4a7c15U);
  for (const char letter : family) {
    state = mixed(state ^ static_cast<unsigned char>(letter));
  }
  return stream_from(mixed(state + index));
}

}  // namespace carom::properties
