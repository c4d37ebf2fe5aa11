// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <iterator>

#include <CGAL/Algebraic_kernel_d_1.h>
#include <CGAL/Gmpz.h>
#include <CGAL/Polynomial.h>

#include <carom/collision/expects.hpp>
#include <carom/oracles/exact/gmpq.hpp>
#include <carom/oracles/exact/roots.hpp>

namespace carom::oracles {
namespace {

using Kernel = CGAL::Algebraic_kernel_d_1<CGAL::Gmpz>;
using RationalPolynomial = CGAL::Polynomial<CGAL::Gmpq>;

/// The polynomial times a positive number, with coefficients in ℤ.
Kernel::Polynomial_1 multiple_in_integers(const Coefficients& coefficients) {
  std::vector<CGAL::Gmpq> numbers;
  for (const Rational& one : coefficients) {
    numbers.push_back(Rational::Number::of(one));
  }
  Kernel::Polynomial_1 numerator;
  CGAL::Gmpz denominator;
  CGAL::Fraction_traits<RationalPolynomial>::Decompose()(RationalPolynomial(numbers.begin(), numbers.end()), numerator,
                                                         denominator);
  return numerator;
}

}  // namespace

std::vector<Rational> positive_roots(const Coefficients& polynomial, const Coefficients& side, int bits) {
  CAROM_EXPECTS(!side.empty() && bits > 0, side.size(), bits);
  CAROM_EXPECTS(std::any_of(polynomial.begin(), polynomial.end(), [](const Rational& x) { return x != 0; }),
                polynomial.size());
  const Kernel kernel;
  const Kernel::Polynomial_1 integer_side = multiple_in_integers(side);
  std::vector<Kernel::Algebraic_real_1> all;
  kernel.solve_1_object()(multiple_in_integers(polynomial), false, std::back_inserter(all));
  std::vector<Rational> roots;
  for (const Kernel::Algebraic_real_1& root : all) {
    if (kernel.compare_1_object()(root, 0) == CGAL::LARGER &&
        kernel.sign_at_1_object()(integer_side, root) == CGAL::POSITIVE) {
      roots.push_back(
          Rational::Number::made([&] { return kernel.approximate_relative_1_object()(root, bits).second; }));
    }
  }
  return roots;
}

}  // namespace carom::oracles
