// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <map>
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

/// Lazy values, each with a key. A reference to a value stays valid.
template <class Key, class T>
class LazyMap {
 public:
  template <class Make>
  const T& get(const Key& key, const Make& make) const {
    return values_[key].get(make);
  }

 private:
  mutable std::map<Key, Lazy<T>> values_;
};

}  // namespace carom::oracles
