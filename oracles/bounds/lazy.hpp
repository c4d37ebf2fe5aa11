// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <forward_list>
#include <optional>
#include <utility>

namespace carom::oracles {

/// A value that is computed on first use and then kept. For one thread.
template <class T>
class Lazy {
 public:
  Lazy() = default;
  explicit Lazy(T known) : value_(std::move(known)) {}

  /// Precondition: `make` does not request the same value.
  template <class Make>
  const T& get(const Make& make) const {
    if (!value_) {
      value_.emplace(make());
    }
    return *value_;
  }

 private:
  mutable std::optional<T> value_;
};

/// Lazy values, each with a key. A reference to a value stays valid. For few keys: `get` compares them one by one.
template <class Key, class T>
class LazyMap {
 public:
  /// Precondition: `make` does not request a value of the same map.
  template <class Make>
  const T& get(const Key& key, const Make& make) const {
    for (const auto& [known, value] : values_) {
      if (known == key) {
        return value;
      }
    }
    return values_.emplace_front(key, make()).second;
  }

 private:
  mutable std::forward_list<std::pair<Key, T>> values_;
};

}  // namespace carom::oracles
