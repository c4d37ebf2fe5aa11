// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <map>
#include <optional>
#include <utility>

namespace carom::oracles {

/// A value that is made when it is first asked for, and then kept. For one thread.
template <class T>
class Lazy {
 public:
  Lazy() = default;
  explicit Lazy(T known) : value_(std::move(known)) {}

  /// The value, made by `make()` the first time. Precondition: `make` does not ask for the same value.
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

/// Many such values, each with a key. A reference to one stays valid.
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
