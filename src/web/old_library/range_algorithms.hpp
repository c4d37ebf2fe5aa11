// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

#if _LIBCPP_VERSION != 13000
#error "prelude.hpp names the only library that this file extends"
#endif

/// The algorithms of std::ranges that the judge uses, on whole ranges, for libc++ 13. prelude.hpp says why they are in
/// namespace std::ranges.
namespace std::ranges {

namespace old_library {

template <class Compare, class Projection>
auto on_projected(Compare compare, Projection projection) {
  return [compare, projection](const auto& x, const auto& y) {
    return std::invoke(compare, std::invoke(projection, x), std::invoke(projection, y));
  };
}

}  // namespace old_library

template <class R, class Compare = less, class Projection = identity>
void sort(R&& range, Compare compare = {}, Projection projection = {}) {
  std::sort(std::begin(range), std::end(range), old_library::on_projected(compare, projection));
}

template <class R, class Compare = less, class Projection = identity>
void stable_sort(R&& range, Compare compare = {}, Projection projection = {}) {
  std::stable_sort(std::begin(range), std::end(range), old_library::on_projected(compare, projection));
}

template <class R>
void reverse(R&& range) {
  std::reverse(std::begin(range), std::end(range));
}

template <class R, class T, class Projection = identity>
auto find(R&& range, const T& value, Projection projection = {}) {
  return std::find_if(std::begin(range), std::end(range),
                      [&](const auto& x) { return std::invoke(projection, x) == value; });
}

template <class R, class T, class Projection = identity>
auto count(R&& range, const T& value, Projection projection = {}) {
  return std::count_if(std::begin(range), std::end(range),
                       [&](const auto& x) { return std::invoke(projection, x) == value; });
}

template <class R, class Predicate>
auto count_if(R&& range, Predicate predicate) {
  return std::count_if(std::begin(range), std::end(range), predicate);
}

template <class R, class Predicate>
bool all_of(R&& range, Predicate predicate) {
  return std::all_of(std::begin(range), std::end(range), predicate);
}

template <class R, class Predicate>
bool any_of(R&& range, Predicate predicate) {
  return std::any_of(std::begin(range), std::end(range), predicate);
}

template <class R, class T>
bool binary_search(R&& range, const T& value) {
  return std::binary_search(std::begin(range), std::end(range), value);
}

template <class R, class Out, class Predicate>
void copy_if(R&& range, Out out, Predicate predicate) {
  std::copy_if(std::begin(range), std::end(range), out, predicate);
}

template <class R, class Out>
void move(R&& range, Out out) {
  std::move(std::begin(range), std::end(range), out);
}

template <class R, class Out, class Function>
void transform(R&& range, Out out, Function function) {
  std::transform(std::begin(range), std::end(range), out, function);
}

template <class R1, class R2, class Out>
void set_difference(R1&& range, R2&& subtracted, Out out) {
  std::set_difference(std::begin(range), std::end(range), std::begin(subtracted), std::end(subtracted), out);
}

}  // namespace std::ranges
