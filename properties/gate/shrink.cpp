// SPDX-License-Identifier: BSL-1.0
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include <carom/collision/expects.hpp>
#include <carom/collision/validate.hpp>
#include <carom/properties/draws/vectors.hpp>
#include <carom/properties/gate/shrink.hpp>

namespace carom::properties {
namespace {

/// 0 for 0, and 1 for −0 and for a number that is not finite. Otherwise 3 times the number of bits of the odd part,
/// plus the size of the exponent, plus 1 for a minus sign.
long complexity(double number) {
  if (!std::isfinite(number)) {
    return 1;
  }
  if (number == 0) {
    return std::signbit(number) ? 1 : 0;
  }
  int exponent = 0;
  constexpr int mantissa_bits = 53;
  const auto mantissa = static_cast<std::uint64_t>(std::ldexp(std::frexp(std::abs(number), &exponent), mantissa_bits));
  const int bits = mantissa_bits - std::countr_zero(mantissa);
  return 3 * bits + std::abs(exponent - 1) + (number < 0 ? 1 : 0);
}

template <class F>
void for_each_body(Collision& collision, F&& f) {
  f(collision.a);
  f(collision.b);
}

void set_to_rest(Body& body) {
  body.velocity.setZero();
  body.angular_velocity.setZero();
}

Body immovable_at(const Vector3<double>& position) {
  Body body;
  body.immovable = true;
  body.position = position;
  return body;
}

/// Rounds the normal to this many bits, stops all motion, and lets one body approach the other along the normal.
void meet_head_on(Collision& c, int bits) {
  for (int i = 0; i < 3; ++i) {
    c.normal[i] = rounded_to_bits(c.normal[i], bits);
  }
  for_each_body(c, set_to_rest);
  if (c.a.immovable) {
    c.b.velocity = c.normal;
  } else {
    c.a.velocity = -c.normal;
  }
}

class Candidates {
 public:
  explicit Candidates(const Collision& collision)
      : collision_(collision), complexity_(properties::complexity(collision)) {}

  template <class Change>
  void add(const Change& change) {
    Collision changed = collision_;
    change(changed);
    if (validate(changed).empty() && properties::complexity(changed) < complexity_) {
      found_.push_back(changed);
    }
  }

  [[nodiscard]] std::vector<Collision> take() { return std::move(found_); }

 private:
  Collision collision_;
  long complexity_;
  std::vector<Collision> found_;
};

}  // namespace

long complexity(const Collision& collision) {
  long sum = 0;
  for_each_number(
      [&](const FieldPath& path, const double& number) {
        // The identity, and a mass or moment of 1, are the simplest and count as 0.
        const bool is_unit = number == 1 && (path.field == "mass" || path.field == "principal_inertia" ||
                                             (path.field == "orientation" && path.component == 0));
        sum += is_unit ? 0 : complexity(number);
      },
      collision);
  return sum;
}

std::vector<Collision> simpler(const Collision& collision) {
  CAROM_EXPECTS(validate(collision).empty(), describe(validate(collision)));
  Candidates candidates(collision);
  candidates.add([](Collision& c) { c.b = immovable_at(c.b.position); });
  candidates.add([](Collision& c) { c.a = immovable_at(c.a.position); });
  candidates.add([](Collision& c) {
    for_each_body(c, [&](Body& body) { body.position -= c.point; });
    c.point.setZero();
  });
  candidates.add([](Collision& c) {
    c.a.velocity -= c.b.velocity;
    set_to_rest(c.b);
  });
  for (Body Collision::*body : {&Collision::b, &Collision::a}) {
    candidates.add([&](Collision& c) { set_to_rest(c.*body); });
    candidates.add([&](Collision& c) { (c.*body).angular_velocity.setZero(); });
    candidates.add([&](Collision& c) { (c.*body).velocity.setZero(); });
    candidates.add([&](Collision& c) { (c.*body).position = c.point; });
    candidates.add([&](Collision& c) { (c.*body).orientation = {1, 0, 0, 0}; });
    candidates.add([&](Collision& c) {
      (c.*body).mass = 1;
      (c.*body).principal_inertia.setOnes();
    });
    candidates.add([&](Collision& c) { (c.*body).principal_inertia.setConstant((c.*body).principal_inertia[0]); });
  }
  // Some failures need a velocity along the normal, so velocity and normal are simplified together.
  for (const bool b_is_fixed : {true, false}) {
    for (const int bits : {1, 2, 3, 4, 5, 53}) {
      candidates.add([&](Collision& c) {
        if (b_is_fixed) {
          c.b = immovable_at(c.b.position);
        }
        meet_head_on(c, bits);
      });
    }
  }
  for (const int bits : {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 44}) {
    candidates.add([&](Collision& c) {
      for_each_number([&](const FieldPath&, double& number) { number = rounded_to_bits(number, bits); }, c);
    });
  }
  int count = 0;
  for_each_number([&](const FieldPath&, const double&) { ++count; }, collision);
  for (int chosen = 0; chosen < count; ++chosen) {
    const auto change_one = [&](const auto& changed) {
      candidates.add([&](Collision& c) {
        int index = 0;
        for_each_number(
            [&](const FieldPath&, double& number) {
              if (index++ == chosen) {
                number = changed(number);
              }
            },
            c);
      });
    };
    change_one([](double) { return 0.0; });
    change_one([](double) { return 1.0; });
    change_one([](double x) { return std::abs(x); });
    for (const int bits : {1, 2, 3, 5, 8, 16, 32}) {
      change_one([&](double x) { return rounded_to_bits(x, bits); });
    }
    change_one([](double x) { return std::round(x); });
    change_one([](double x) {
      int exponent = 0;
      std::frexp(x, &exponent);
      return std::ldexp(x, -exponent / 2);
    });
    change_one([](double x) { return x / 2; });
    change_one([](double x) { return x * 2; });
  }
  return candidates.take();
}

Collision shrink(Collision collision, const std::function<bool(const Collision&)>& still_fails,
                 std::size_t most_calls) {
  std::vector<Collision> candidates = simpler(collision);
  // The search continues after the last success, and ends after a whole round of failures.
  std::size_t next = 0;
  std::size_t failures = 0;
  for (std::size_t calls = 0; calls < most_calls && failures < candidates.size(); ++calls) {
    next %= candidates.size();
    if (still_fails(candidates[next])) {
      collision = candidates[next];
      candidates = simpler(collision);
      failures = 0;
    } else {
      ++next;
      ++failures;
    }
  }
  return collision;
}

}  // namespace carom::properties
