// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstddef>

namespace carom {

/// A value for each enumerator of an enumeration that counts from 0.
template <class Enum, class T, std::size_t Count>
struct EnumArray {
  std::array<T, Count> values{};

  [[nodiscard]] constexpr T& operator[](Enum key) { return values[static_cast<std::size_t>(key)]; }
  [[nodiscard]] constexpr const T& operator[](Enum key) const { return values[static_cast<std::size_t>(key)]; }

  [[nodiscard]] constexpr auto begin() { return values.begin(); }
  [[nodiscard]] constexpr auto end() { return values.end(); }
  [[nodiscard]] constexpr auto begin() const { return values.begin(); }
  [[nodiscard]] constexpr auto end() const { return values.end(); }

  constexpr EnumArray& operator+=(const EnumArray& other) {
    for (std::size_t i = 0; i < Count; ++i) {
      values[i] += other.values[i];
    }
    return *this;
  }

  friend constexpr bool operator==(const EnumArray&, const EnumArray&) = default;
};

/// Whether `all` lists every enumerator from 0 to `last`, in order.
template <class Enum, std::size_t Count>
[[nodiscard]] constexpr bool counts_from_zero_to(const std::array<Enum, Count>& all, Enum last) {
  for (std::size_t i = 0; i < Count; ++i) {
    if (static_cast<std::size_t>(all[i]) != i) {
      return false;
    }
  }
  return all[Count - 1] == last;
}

}  // namespace carom
