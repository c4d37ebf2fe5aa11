// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

#include <CGAL/Algebraic_kernel_d_1.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Gmpz.h>

#include <carom/collision/expects.hpp>
#include <carom/scene/exact_time.hpp>

namespace carom::scene {
namespace {

using Rational = CGAL::Gmpq;
using Kernel = CGAL::Algebraic_kernel_d_1<CGAL::Gmpz>;
using Root = Kernel::Algebraic_real_1;

const Kernel& kernel() {
  static const Kernel instance;
  return instance;
}

/// Coefficients in ascending powers of t − origin.
template <std::size_t N>
using Coefficients = std::array<Rational, N>;

template <std::size_t N>
Coefficients<2 * N - 1> square_of(const Coefficients<N>& x) {
  Coefficients<2 * N - 1> result{};
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < N; ++j) {
      result[i + j] += x[i] * x[j];
    }
  }
  return result;
}

Coefficients<3> coordinate(const Path& path, int axis, const Rational& origin) {
  const Rational delay = origin - Rational(path.start);
  const Rational half = Rational(path.acceleration[axis]) / Rational(2);
  const Rational velocity(path.velocity[axis]);
  return {Rational(path.position[axis]) + delay * (velocity + delay * half), velocity + Rational(2) * half * delay,
          half};
}

Coefficients<5> squared_gap(const Path& a, const Path& b, const Rational& origin) {
  const Rational radii = Rational(a.radius) + Rational(b.radius);
  Coefficients<5> sum{};
  sum[0] = -radii * radii;
  for (int axis = 0; axis < 3; ++axis) {
    Coefficients<3> difference = coordinate(a, axis, origin);
    const Coefficients<3> other = coordinate(b, axis, origin);
    for (std::size_t k = 0; k < 3; ++k) {
      difference[k] -= other[k];
    }
    const Coefficients<5> square = square_of(difference);
    for (std::size_t k = 0; k < 5; ++k) {
      sum[k] += square[k];
    }
  }
  return sum;
}

Coefficients<3> height(const Path& sphere, const Reach& plane, const Rational& origin) {
  Coefficients<3> sum{};
  sum[0] = -Rational(plane.reach);
  for (int axis = 0; axis < 3; ++axis) {
    const Coefficients<3> x = coordinate(sphere, axis, origin);
    for (std::size_t k = 0; k < 3; ++k) {
      sum[k] += Rational(plane.normal[axis]) * x[k];
    }
  }
  return sum;
}

Coefficients<5> gap(const Path& a, const Path& b, const Rational& origin) { return squared_gap(a, b, origin); }
Coefficients<3> gap(const Path& a, const Reach& b, const Rational& origin) { return height(a, b, origin); }

/// The sign of a polynomial just after the origin.
template <std::size_t N>
int sign_from_origin(const Coefficients<N>& q) {
  for (const Rational& coefficient : q) {
    if (coefficient != Rational(0)) {
      return CGAL::sign(coefficient);
    }
  }
  return 0;
}

template <class Sequence>
Kernel::Polynomial_1 with_whole_coefficients(const Sequence& q) {
  CGAL::Gmpz denominator = 1;
  for (const Rational& coefficient : q) {
    denominator = denominator *
                  CGAL::integral_division(coefficient.denominator(), CGAL::gcd(denominator, coefficient.denominator()));
  }
  std::vector<CGAL::Gmpz> whole;
  for (const Rational& coefficient : q) {
    whole.push_back(coefficient.numerator() * CGAL::integral_division(denominator, coefficient.denominator()));
  }
  return {whole.begin(), whole.end()};
}

/// The real roots in ascending order, with their multiplicities.
template <class Sequence>
std::vector<std::pair<Root, int>> roots_of(const Sequence& q) {
  std::vector<std::pair<Root, int>> roots;
  kernel().solve_1_object()(with_whole_coefficients(q), std::back_inserter(roots));
  return roots;
}

Root as_root(const Rational& time) { return roots_of(std::array{-time, Rational(1)}).front().first; }

CGAL::Comparison_result compare(const Root& left, const Root& right) {
  return kernel().compare_1_object()(left, right);
}

}  // namespace

struct ExactTime::Instant {
  Root root;
};

ExactTime ExactTime::at(double time) {
  CAROM_EXPECTS(std::isfinite(time), time);
  return ExactTime(std::make_shared<const Instant>(Instant{as_root(Rational(time))}));
}

std::strong_ordering operator<=>(const ExactTime& left, const ExactTime& right) {
  return compare(left.instant_->root, right.instant_->root) <=> CGAL::EQUAL;
}

TimeBounds ExactTime::bounds() const {
  const Root& root = instant_->root;
  const Root zero = as_root(Rational(0));
  if (compare(root, zero) == CGAL::EQUAL) {
    return {0, 0};
  }
  constexpr int bits = 60;  // more than the 53 bits of a double, so that few doubles remain to be tested
  double below = CGAL::to_interval(kernel().approximate_relative_1_object()(root, bits).first).first;
  for (;;) {
    const double next = std::nextafter(below, never);
    if (next == never) {
      return {below, never};  // the contact of a very slow sphere may be later than every double
    }
    switch (compare(as_root(Rational(next)), root)) {
      case CGAL::SMALLER:
        below = next;
        break;
      case CGAL::EQUAL:
        return {next, next};
      case CGAL::LARGER:
        return compare(as_root(Rational(below)), root) == CGAL::EQUAL ? TimeBounds{below, below}
                                                                      : TimeBounds{below, next};
    }
  }
}

namespace {

template <class Other>
std::optional<ExactTime> first_fall(const Path& path, const Other& other, double now) {
  const int sign = sign_from_origin(gap(path, other, Rational(now)));
  if (sign < 0) {
    return ExactTime::at(now);
  }
  if (sign == 0) {
    return std::nullopt;
  }
  const Root begin = as_root(Rational(now));
  for (const auto& [root, multiplicity] : roots_of(gap(path, other, Rational(0)))) {
    if (compare(root, begin) == CGAL::LARGER && multiplicity % 2 == 1) {
      return ExactTime(std::make_shared<const ExactTime::Instant>(ExactTime::Instant{root}));
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<ExactTime> exact_contact(const Path& a, const Path& b, double now) { return first_fall(a, b, now); }
std::optional<ExactTime> exact_contact(const Path& sphere, const Reach& plane, double now) {
  return first_fall(sphere, plane, now);
}

int sign_of_gap(const Path& a, const Path& b, double time) { return CGAL::sign(gap(a, b, Rational(time))[0]); }
int sign_of_gap(const Path& sphere, const Reach& plane, double time) {
  return CGAL::sign(gap(sphere, plane, Rational(time))[0]);
}

namespace {

/// The index of a double in the ascending order of all doubles, with 0 for zero.
std::int64_t in_order(double x) {
  const auto bits = std::bit_cast<std::int64_t>(std::abs(x));
  return x < 0 ? -bits : bits;
}
double from_order(std::int64_t place) {
  const double size = std::bit_cast<double>(place < 0 ? -place : place);
  return place < 0 ? -size : size;
}

}  // namespace

double reach_of(const Vector3<double>& normal, const Vector3<double>& point, double radius) {
  Rational level(0);
  Rational square(0);
  for (int axis = 0; axis < 3; ++axis) {
    level += Rational(normal[axis]) * Rational(point[axis]);
    square += Rational(normal[axis]) * Rational(normal[axis]);
  }
  square *= Rational(radius) * Rational(radius);
  // Whether x ≥ normal·point + radius |normal|, without a square root.
  const auto is_clear = [&](double x) {
    const Rational over = Rational(x) - level;
    return over >= Rational(0) && over * over >= square;
  };
  // The search runs over the indices of doubles. Each step is twice as long as the step before.
  std::int64_t low = in_order(CGAL::to_double(level) + std::sqrt(CGAL::to_double(square)));
  std::int64_t high = low;
  for (std::int64_t step = 1; is_clear(from_order(low)); step *= 2) {
    high = low;
    low -= step;
  }
  for (std::int64_t step = 1; !is_clear(from_order(high)); step *= 2) {
    low = high;
    high += step;
  }
  while (high - low > 1) {
    const std::int64_t middle = low + (high - low) / 2;
    (is_clear(from_order(middle)) ? high : low) = middle;
  }
  return from_order(high);
}

}  // namespace carom::scene
