// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <new>
#include <span>
#include <vector>

#include <carom/collision/expects.hpp>
#include <carom/impulse/batch/contact_arrays.hpp>

namespace carom::impulse {

namespace detail {

inline constexpr std::size_t cache_line = 64;
inline constexpr std::size_t page = 4096;

template <class S>
struct PageAllocator {
  using value_type = S;
  PageAllocator() = default;
  template <class T>
  // NOLINTNEXTLINE(google-explicit-constructor): allocators convert
  PageAllocator(const PageAllocator<T>&) {}
  [[nodiscard]] S* allocate(std::size_t n) {
    return static_cast<S*>(::operator new (n * sizeof(S), std::align_val_t{page}));
  }
  void deallocate(S* memory, std::size_t) { ::operator delete (memory, std::align_val_t{page}); }
  friend bool operator==(const PageAllocator&, const PageAllocator&) { return true; }
};

/// Arrays of one length in one piece of memory. Each array begins at a cache line. The first array begins at the offset
/// within a page that it would have after `before` other arrays. OutcomeBatch sets `before` to the number of arrays of
/// a ContactBatch, so that contacts and outcomes have different offsets. A load waits for a recent store to another
/// page if both have the same offset.
template <class S>
class ArraysInOnePiece {
 public:
  ArraysInOnePiece(std::size_t arrays, std::size_t length, std::size_t before)
      : length_(length),
        stride_(stride(length)),
        begin_(before * stride_ % (page / sizeof(S))),
        memory_(begin_ + arrays * stride_) {}

  [[nodiscard]] std::size_t length() const { return length_; }
  [[nodiscard]] S* begin_of(std::size_t k) { return memory_.data() + begin_ + k * stride_; }
  [[nodiscard]] const S* begin_of(std::size_t k) const { return memory_.data() + begin_ + k * stride_; }
  [[nodiscard]] std::span<S> operator[](std::size_t k) { return {begin_of(k), length_}; }
  [[nodiscard]] std::span<const S> operator[](std::size_t k) const { return {begin_of(k), length_}; }

 private:
  /// An odd number of cache lines, so that equal indices of different arrays map to different sets of a cache.
  static std::size_t stride(std::size_t length) {
    constexpr std::size_t line = cache_line / sizeof(S);
    return ((length + line - 1) / line | 1) * line;
  }

  std::size_t length_;
  std::size_t stride_;
  std::size_t begin_;
  std::vector<S, PageAllocator<S>> memory_;
};

/// `Arrays` that refer to the arrays in `memory`.
template <class Arrays, class Memory>
[[nodiscard]] Arrays arrays_over(Memory& memory) {
  Arrays arrays;
  std::size_t k = 0;
  for_each_array(arrays, [&](auto& array) { array = memory[k++]; });
  return arrays;
}

}  // namespace detail

/// Contacts as a structure of arrays that owns its memory. Initially all numbers are zero.
template <class S>
class ContactBatch {
 public:
  explicit ContactBatch(std::size_t size) : memory_(contact_number_count, size, 0) {}

  [[nodiscard]] std::size_t size() const { return memory_.length(); }
  [[nodiscard]] ContactArrays<S> arrays() { return detail::arrays_over<ContactArrays<S>>(memory_); }
  [[nodiscard]] ContactArrays<const S> arrays() const { return detail::arrays_over<ContactArrays<const S>>(memory_); }
  /// The beginning of the array of the k-th number, in the order of for_each_array. Precondition: k <
  /// contact_number_count.
  [[nodiscard]] const S* begin_of(std::size_t k) const {
    CAROM_EXPECTS(k < contact_number_count, k);
    return memory_.begin_of(k);
  }

  /// Precondition: i < size().
  [[nodiscard]] Contact<S> at(std::size_t i) const {
    CAROM_EXPECTS(i < size(), i, size());
    return contact_of<S>([&](std::size_t k) { return memory_[k][i]; });
  }
  /// Precondition: i < size().
  void set(std::size_t i, const Contact<S>& contact) {
    CAROM_EXPECTS(i < size(), i, size());
    write_contact(contact, [&](std::size_t k, const S& number) { memory_[k][i] = number; });
  }

 private:
  detail::ArraysInOnePiece<S> memory_;
};

/// Outcomes as a structure of arrays that owns its memory.
template <class S>
class OutcomeBatch {
 public:
  explicit OutcomeBatch(std::size_t size) : memory_(outcome_number_count, size, contact_number_count) {}

  [[nodiscard]] std::size_t size() const { return memory_.length(); }
  [[nodiscard]] OutcomeArrays<S> arrays() { return detail::arrays_over<OutcomeArrays<S>>(memory_); }
  /// The beginning of the array of the k-th number, in the order of for_each_array. Precondition: k <
  /// outcome_number_count.
  [[nodiscard]] S* begin_of(std::size_t k) {
    CAROM_EXPECTS(k < outcome_number_count, k);
    return memory_.begin_of(k);
  }

  /// Precondition: i < size().
  [[nodiscard]] Outcome<S> at(std::size_t i) const {
    CAROM_EXPECTS(i < size(), i, size());
    return outcome_of<S>([&](std::size_t k) { return memory_[k][i]; });
  }

 private:
  detail::ArraysInOnePiece<S> memory_;
};

}  // namespace carom::impulse
