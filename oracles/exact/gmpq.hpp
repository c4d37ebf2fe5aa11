// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <new>
#include <utility>

#include <CGAL/Gmpq.h>

#include <carom/oracles/exact/rational.hpp>

/// Only files that use CGAL include this header. It is not installed.
namespace carom::oracles {

struct Rational::Number {
  static const CGAL::Gmpq& of(const Rational& number) {
    return *std::launder(reinterpret_cast<const CGAL::Gmpq*>(number.number_.data()));
  }
  static CGAL::Gmpq& of(Rational& number) {
    return *std::launder(reinterpret_cast<CGAL::Gmpq*>(number.number_.data()));
  }
  template <class Make>
  static Rational made(const Make& make) {
    return Rational(std::in_place, make);
  }
};

template <class Make>
Rational::Rational(std::in_place_t, const Make& make) {
  static_assert(sizeof(CGAL::Gmpq) == sizeof number_ && alignof(CGAL::Gmpq) <= alignof(void*));
  new (number_.data()) CGAL::Gmpq(make());
}

}  // namespace carom::oracles
