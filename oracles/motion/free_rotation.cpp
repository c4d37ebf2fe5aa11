// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <carom/collision/expects.hpp>
#include <carom/oracles/bounds/enclosure.hpp>
#include <carom/oracles/motion/free_rotation.hpp>

namespace carom::oracles {
namespace {

using Three = std::array<Enclosure, 3>;
using Four = std::array<Enclosure, 4>;

/// Coefficients of Taylor series of the solution of x₀' = c₀ x₁ x₂, x₁' = c₁ x₂ x₀, x₂' = c₂ x₀ x₁, one for each power
/// of the time. If |cᵢ| ≤ 1 and |xᵢ(0)| ≤ a, coefficient n is at most aⁿ⁺¹, because y' = y², y(0) = a has the solution
/// a / (1 − a t).
std::vector<Three> series(const Three& c, const Three& at_zero, std::size_t terms) {
  std::vector<Three> x{at_zero};
  for (std::size_t n = 0; n + 1 < terms; ++n) {
    Three next;
    for (std::size_t i = 0; i < 3; ++i) {
      Enclosure sum;
      for (std::size_t k = 0; k <= n; ++k) {
        sum += x[k][(i + 1) % 3] * x[n - k][(i + 2) % 3];
      }
      next[i] = c[i] * sum / Enclosure(static_cast<int>(n + 1));
    }
    x.push_back(next);
  }
  return x;
}

/// The value of a series at `time`, and the rest, which is at most `rest` in each component.
template <std::size_t N>
std::array<Enclosure, N> sum_of(const std::vector<std::array<Enclosure, N>>& series, const Enclosure& time,
                                double rest) {
  std::array<Enclosure, N> sum{};
  std::for_each(series.rbegin(), series.rend(), [&](const std::array<Enclosure, N>& coefficient) {
    std::transform(sum.begin(), sum.end(), coefficient.begin(), sum.begin(),
                   [&](const Enclosure& x, const Enclosure& c) { return x * time + c; });
  });
  std::transform(sum.begin(), sum.end(), sum.begin(), [&](const Enclosure& x) { return x.widened_by(rest); });
  return sum;
}

/// x^n / (1 − x), rounded upwards.
double rest_of(double x, std::size_t n) { return std::pow(x, static_cast<double>(n)) / (1 - x) * 1.0001; }

/// Jacobi's sn, cn and dn.
struct Elliptic {
  Enclosure sn, cn, dn;
};

/// The addition theorem (NIST DLMF 22.8.1 to 22.8.3). `m` is k².
Elliptic sum(const Elliptic& x, const Elliptic& y, const Enclosure& m) {
  const Enclosure both = x.sn * y.sn;
  const Enclosure divisor = Enclosure(1) - m * both * both;
  return {(x.sn * y.cn * y.dn + y.sn * x.cn * x.dn) / divisor, (x.cn * y.cn - both * x.dn * y.dn) / divisor,
          (x.dn * y.dn - m * both * x.cn * y.cn) / divisor};
}

/// The functions at u ≥ 0: a Taylor series near 0, and then doublings.
Elliptic elliptic(Enclosure u, const Enclosure& m) {
  unsigned doublings = 0;
  for (; u.middle() > 0.125; ++doublings) {
    u *= Enclosure(0.5);
  }
  constexpr std::size_t terms = 36;
  const Three at_u =
      sum_of(series({Enclosure(1), Enclosure(-1), -m}, {Enclosure(0), Enclosure(1), Enclosure(1)}, terms), u,
             rest_of(0.1251, terms));
  Elliptic result{at_u[0], at_u[1], at_u[2]};
  for (; doublings > 0; --doublings) {
    result = sum(result, result, m);
  }
  return result;
}

/// w as amplitudes of cn, sn and dn of p t + u₀, for axes first, 1 and last. The last axis is the one that w stays
/// near.
struct Jacobi {
  std::size_t first = 0;
  std::size_t last = 2;
  Three amplitude;  // of cn, sn and dn
  Enclosure rate;   // p [1/s]
  Enclosure m;      // k²
  Elliptic start;   // at u₀

  [[nodiscard]] Three at(const Enclosure& time) const {
    const Elliptic now = sum(start, elliptic(time * rate, m), m);
    Three w;
    w[first] = amplitude[0] * now.cn;
    w[1] = amplitude[1] * now.sn;
    w[last] = amplitude[2] * now.dn;
    return w;
  }
};

Jacobi jacobi(const FreeBody& body) {
  const auto j = [&](std::size_t i) { return Enclosure(body.principal_inertia[static_cast<Eigen::Index>(i)]); };
  const auto w = [&](std::size_t i) { return Enclosure(body.angular_velocity[static_cast<Eigen::Index>(i)]); };
  Enclosure energy;   // 2 E
  Enclosure squared;  // L²
  for (std::size_t i = 0; i < 3; ++i) {
    const Enclosure momentum = j(i) * w(i);
    energy += momentum * w(i);
    squared += momentum * momentum;
  }
  Jacobi result;
  if ((squared - energy * j(1)).sign().value() < 0) {
    std::swap(result.first, result.last);
  }
  const Enclosure first = j(result.first);
  const Enclosure last = j(result.last);
  const Enclosure to_last = energy * last - squared;    // 2 E J_last − L²
  const Enclosure to_first = squared - energy * first;  // L² − 2 E J_first
  result.amplitude = {sqrt(to_last / (first * (last - first))), sqrt(to_last / (j(1) * (last - j(1)))),
                      sqrt(to_first / (last * (last - first)))};
  result.rate = sqrt((last - j(1)) * to_first / (first * j(1) * last));
  result.m = (j(1) - first) * to_last / ((last - j(1)) * to_first);
  // If w_last < 0, its amplitude is negative. Then the amplitude of w₁ is negative too: Euler's equations allow both.
  if (w(result.last).sign().value() < 0) {
    result.amplitude[1] = -result.amplitude[1];
    result.amplitude[2] = -result.amplitude[2];
  }
  result.start = {w(1) / result.amplitude[1], w(result.first) / result.amplitude[0],
                  w(result.last) / result.amplitude[2]};
  return result;
}

Four product(const Four& q, const Four& r) {
  return {q[0] * r[0] - q[1] * r[1] - q[2] * r[2] - q[3] * r[3], q[0] * r[1] + q[1] * r[0] + q[2] * r[3] - q[3] * r[2],
          q[0] * r[2] - q[1] * r[3] + q[2] * r[0] + q[3] * r[1], q[0] * r[3] + q[1] * r[2] - q[2] * r[1] + q[3] * r[0]};
}

/// The series of q with q' = ½ q w and q(0) = 1.
std::vector<Four> attitude_series(const std::vector<Three>& w) {
  std::vector<Four> q{Four{Enclosure(1), Enclosure(0), Enclosure(0), Enclosure(0)}};
  for (std::size_t n = 0; n + 1 < w.size(); ++n) {
    Four sum{};
    for (std::size_t k = 0; k <= n; ++k) {
      const Four term = product(q[k], {Enclosure(0), w[n - k][0], w[n - k][1], w[n - k][2]});
      std::transform(sum.begin(), sum.end(), term.begin(), sum.begin(),
                     [](const Enclosure& x, const Enclosure& y) { return x + y; });
    }
    const Enclosure divisor(static_cast<int>(2 * (n + 1)));
    std::transform(sum.begin(), sum.end(), sum.begin(), [&](const Enclosure& x) { return x / divisor; });
    q.push_back(sum);
  }
  return q;
}

/// The Euclidean norm of the error of a quaternion.
double error_of(const Four& q) {
  double squares = 0;
  for (const Enclosure& x : q) {
    squares += x.radius() * x.radius();
  }
  return std::sqrt(squares) * enclosure::up;
}

/// The quaternion without its error, but for one rounding.
Four middle_of(const Four& q) {
  Four middle;
  std::transform(q.begin(), q.end(), middle.begin(),
                 [](const Enclosure& x) { return Enclosure(x.middle()) + Enclosure(x.lower_part()); });
  return middle;
}

}  // namespace

std::array<Known, 3> free_angular_velocity(const FreeBody& body, double time) {
  const Three w = jacobi(body).at(Enclosure(time));
  return {known(w[0]), known(w[1]), known(w[2])};
}

KnownAttitude free_attitude(const FreeBody& body, double time) {
  const Jacobi motion = jacobi(body);
  const Vector3<double>& j = body.principal_inertia;
  CAROM_EXPECTS(j[0] > 0 && j[0] < j[1] && j[1] < j[2] && j[2] < j[0] + j[1]);
  Three factors;  // of Euler's equations, at most 1 for a body that can exist
  for (std::size_t i = 0; i < 3; ++i) {
    const auto at = [&](std::size_t k) { return Enclosure(j[static_cast<Eigen::Index>(k % 3)]); };
    factors[i] = (at(i + 1) - at(i + 2)) / at(i);
  }
  const double greatest = std::max({motion.amplitude[0].magnitude_above(), motion.amplitude[1].magnitude_above(),
                                    motion.amplitude[2].magnitude_above()});
  // One part of the time is at most 1/8 of 1 / greatest. Coefficient n of the quaternion is at most greatestⁿ, because
  // Q' = (√3/2) a / (1 − a t) Q, Q(0) = 1 has the solution (1 − a t) to the power −√3/2.
  const auto parts = static_cast<std::size_t>(std::ceil(std::abs(time) * greatest * 8)) + 1;
  const double part = time / static_cast<double>(parts);
  constexpr std::size_t terms = 26;
  const double rest = rest_of(0.1251, terms);
  Four q{Enclosure(1), Enclosure(0), Enclosure(0), Enclosure(0)};
  double error = 0;
  for (std::size_t k = 0; k < parts; ++k) {
    const Three w = motion.at(Enclosure(part) * Enclosure(static_cast<double>(k)));
    const Four turn = sum_of(attitude_series(series(factors, w, terms)), Enclosure(part), rest);
    const Four next = product(q, middle_of(turn));
    error = (error * (1 + 0x1p-40) + error_of(turn) + error_of(next)) * (1 + 0x1p-40);
    q = middle_of(next);
  }
  // `part` is rounded, so the parts together differ from the time by an ulp.
  error += 0x1p-50 * std::abs(time) * greatest;
  KnownAttitude result;
  for (std::size_t i = 0; i < 4; ++i) {
    result.value[static_cast<Eigen::Index>(i)] = q[i].middle();
    error += std::abs(q[i].lower_part());
  }
  // A quaternion that is off by e belongs to a rotation that is off by 2 asin(e), to first order 2 e.
  result.bound = 2.1 * error;
  return result;
}

}  // namespace carom::oracles
