// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <set>
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
  Candidates(const Collision& collision, const Kinds& kinds)
      : collision_(collision), complexity_(properties::complexity(collision)), kinds_(kinds) {}

  template <class Change>
  void add(const Change& change) {
    Collision changed = collision_;
    change(changed);
    if (!validate(changed).empty()) {
      return;
    }
    Stream simplest([](const StreamQuestion& question) { return question.simplest; });
    put_into(kinds_, simplest, changed);
    if (validate(changed).empty() && properties::complexity(changed) < complexity_) {
      found_.push_back(changed);
    }
  }

  [[nodiscard]] std::vector<Collision> take() { return std::move(found_); }

 private:
  Collision collision_;
  long complexity_;
  Kinds kinds_;
  std::vector<Collision> found_;
};

constexpr std::array<std::uint64_t, 8> fewer_bits{0, 1, 2, 3, 5, 8, 16, 32};

/// The largest multiple of 2^−bits that is at most this fraction, both in units of 2⁻⁵³.
std::uint64_t shortened(std::uint64_t fraction, std::uint64_t bits) {
  const std::uint64_t unit = fractions >> bits;
  return fraction / unit * unit;
}

/// Other answers to a question, roughly from the simplest on.
std::vector<std::uint64_t> other_answers(const Choice& choice) {
  const std::uint64_t count = choice.question.count;
  const std::uint64_t simplest = choice.question.simplest;
  std::vector<std::uint64_t> answers{simplest};
  constexpr std::uint64_t few = 8;
  if (count == fractions) {
    for (const std::uint64_t bits : fewer_bits) {
      answers.push_back(shortened(choice.answer, bits));
    }
    answers.push_back(fractions / 2);
  } else if (count <= few) {
    for (std::uint64_t answer = 0; answer < count; ++answer) {
      answers.push_back(answer);
    }
  } else if (choice.answer != simplest) {
    const bool is_above = choice.answer > simplest;
    const std::uint64_t distance = is_above ? choice.answer - simplest : simplest - choice.answer;
    const std::uint64_t room_above = count - 1 - simplest;
    for (const std::uint64_t closer : {std::uint64_t{1}, distance / 2, std::bit_floor(distance), distance - 1}) {
      answers.push_back(is_above ? simplest + closer : simplest - closer);
    }
    if (!is_above && distance <= room_above) {
      answers.push_back(simplest + distance);
    }
  }
  std::set<std::uint64_t> seen{choice.answer};
  std::erase_if(answers, [&](std::uint64_t answer) { return !seen.insert(answer).second; });
  return answers;
}

std::vector<Edit> edits_of(const std::vector<Choice>& choices) {
  const std::size_t count = choices.size();
  std::vector<Edit> edits;
  // The first choice may choose the family. Another family asks other questions, which the later choices do not fit. So
  // edits of every length remove some of the later choices.
  for (std::size_t length = 1; length <= count; ++length) {
    edits.push_back({Edit::Kind::answer, 0, length, choices[0].question.simplest});
  }
  for (const std::uint64_t bits : fewer_bits) {
    edits.push_back({Edit::Kind::shorten, 0, count, bits});
  }
  for (std::size_t length = count; length > 1; length /= 2) {
    for (std::size_t first = 0; first < count; first += length) {
      edits.push_back({Edit::Kind::simplify, first, std::min(first + length, count)});
    }
  }
  for (std::size_t place = 0; place < count; ++place) {
    for (const std::uint64_t answer : other_answers(choices[place])) {
      for (const std::size_t length : {1U, 2U, 3U}) {
        edits.push_back({Edit::Kind::answer, place, std::min(place + length, count), answer});
      }
    }
  }
  for (const std::size_t length : {16U, 8U, 4U, 3U, 2U, 1U}) {
    for (std::size_t first = 0; first + length <= count; ++first) {
      edits.push_back({Edit::Kind::remove, first, first + length});
    }
  }
  return edits;
}

std::vector<Choice> edited(std::vector<Choice> choices, const Edit& edit) {
  const auto begin = choices.begin() + static_cast<std::ptrdiff_t>(edit.first);
  const auto end = choices.begin() + static_cast<std::ptrdiff_t>(edit.last);
  switch (edit.kind) {
    case Edit::Kind::simplify:
      std::for_each(begin, end, [](Choice& choice) { choice.answer = choice.question.simplest; });
      break;
    case Edit::Kind::remove:
      choices.erase(begin, end);
      break;
    case Edit::Kind::answer:
      begin->answer = edit.value;
      choices.erase(begin + 1, end);
      break;
    case Edit::Kind::shorten:
      std::for_each(begin, end, [&](Choice& choice) {
        choice.answer = choice.question.count == fractions ? shortened(choice.answer, edit.value) : choice.answer;
      });
      break;
  }
  return choices;
}

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

std::vector<Collision> simpler(const Collision& collision, const Kinds& kinds) {
  CAROM_EXPECTS(validate(collision).empty(), describe(validate(collision)));
  Candidates candidates(collision, kinds);
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

Collision shrink(Collision collision, const std::function<bool(const Collision&)>& still_fails, std::size_t most_calls,
                 const Kinds& kinds) {
  std::vector<Collision> candidates = simpler(collision, kinds);
  // The search continues after the last success, and ends after a whole round of failures.
  std::size_t next = 0;
  std::size_t failures = 0;
  for (std::size_t calls = 0; calls < most_calls && failures < candidates.size(); ++calls) {
    next %= candidates.size();
    if (still_fails(candidates[next])) {
      collision = candidates[next];
      candidates = simpler(collision, kinds);
      failures = 0;
    } else {
      ++next;
      ++failures;
    }
  }
  return collision;
}

SimplerCases::SimplerCases(Draw draw, ChosenCase from, std::size_t first)
    : draw_(std::move(draw)),
      from_(std::move(from)),
      edits_(edits_of(from_.choices)),
      first_(first % edits_.size()),
      complexity_(complexity(from_.one.collision)) {}

std::optional<ChosenCase> SimplerCases::next() {
  while (tried_ < edits_.size()) {
    const Edit& edit = edits_[(first_ + tried_++) % edits_.size()];
    ChosenCase changed = replayed_case(draw_, edited(from_.choices, edit));
    if (complexity(changed.one.collision) < complexity_) {
      return changed;
    }
  }
  return std::nullopt;
}

}  // namespace carom::properties
