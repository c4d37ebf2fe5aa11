// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <carom/collision/expects.hpp>
#include <carom/subjects/protocol/spelling.hpp>

namespace carom::subjects::protocol {
namespace {

/// SplitMix64 (G. Steele, D. Lea, C. Flood, OOPSLA 2014).
std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31U);
}

/// ± 0.DIGITS × 10^exponent, with the shortest digits that identify the number.
struct Decimal {
  bool is_negative;
  std::string digits;  // no zeros at either end, except for zero itself
  int exponent;
};

/// Precondition: the number is finite.
Decimal shortest_decimal(double number) {
  CAROM_EXPECTS(std::isfinite(number), number);
  std::string shortest = fmt::format("{}", std::abs(number));  // "0.0015", "1500.0" or "1.5e-30"
  int exponent = 0;
  if (const std::size_t e = shortest.find('e'); e != std::string::npos) {
    exponent = std::atoi(shortest.c_str() + e + 1);
    shortest.resize(e);
  }
  const std::size_t point = std::min(shortest.find('.'), shortest.size());
  exponent += static_cast<int>(point);
  shortest.erase(std::remove(shortest.begin(), shortest.end(), '.'), shortest.end());
  const std::size_t first = std::min(shortest.find_first_not_of('0'), shortest.size() - 1);
  exponent -= static_cast<int>(first);
  shortest.erase(0, first);
  shortest.resize(std::max<std::size_t>(shortest.find_last_not_of('0') + 1, 1));
  return {std::signbit(number), shortest, number == 0 ? 1 : exponent};
}

/// The number without an exponent. A whole number ends in ".0" if `with_fraction`.
std::string positional(const Decimal& decimal, bool with_fraction) {
  const auto count = static_cast<int>(decimal.digits.size());
  if (decimal.exponent <= 0) {
    return "0." + std::string(static_cast<std::size_t>(-decimal.exponent), '0') + decimal.digits;
  }
  if (decimal.exponent >= count) {
    return decimal.digits + std::string(static_cast<std::size_t>(decimal.exponent - count), '0') +
           (with_fraction ? ".0" : "");
  }
  return std::string(decimal.digits).insert(static_cast<std::size_t>(decimal.exponent), ".");
}

/// The "1.5" of 1.5e-3.
std::string significand(const Decimal& decimal) {
  return decimal.digits.size() == 1 ? decimal.digits : std::string(decimal.digits).insert(1, ".");
}

}  // namespace

std::vector<std::string> spellings_of(double number) {
  if (!std::isfinite(number)) {
    return {std::isnan(number) ? R"("nan")" : number > 0 ? R"("inf")" : R"("-inf")"};
  }
  constexpr int longest = 21;  // JavaScript's limits of positional notation
  constexpr int smallest = -6;
  const Decimal decimal = shortest_decimal(number);
  const int exponent = decimal.exponent - 1;
  std::vector<std::string> ways;
  if (decimal.exponent > smallest && decimal.exponent <= longest) {
    ways.push_back(positional(decimal, true));
    const bool is_small_integer = number == std::trunc(number) && std::abs(number) < 0x1p53;
    if (is_small_integer && !(number == 0 && decimal.is_negative)) {
      ways.push_back(positional(decimal, false));
    }
  }
  ways.push_back(fmt::format("{}e{}", significand(decimal), exponent));
  ways.push_back(fmt::format("{}E{}{:02}", significand(decimal), exponent < 0 ? '-' : '+', std::abs(exponent)));
  ways.push_back(fmt::format("{}e{}", decimal.digits, decimal.exponent - static_cast<int>(decimal.digits.size())));
  for (std::string& way : ways) {
    way.insert(0, decimal.is_negative ? "-" : "");
  }
  return ways;
}

namespace {

class Writer {
 public:
  Writer(std::uint64_t choices, bool is_plain) : state_(choices), is_plain_(is_plain) {}

  std::string collision(const Collision& c) {
    Fields fields{{"a", body(c.a)},
                  {"b", body(c.b)},
                  {"point", vector(c.point)},
                  {"normal", vector(c.normal)},
                  {"restitution", number(c.restitution)}};
    add_unless_left_out(fields, "friction", is_zero(c.friction), [&] { return number(c.friction); });
    add_unless_left_out(fields, "tangential_restitution", is_zero(c.tangential_restitution),
                        [&] { return number(c.tangential_restitution); });
    return object(std::move(fields));
  }

 private:
  using Fields = std::vector<std::pair<std::string_view, std::string>>;

  static bool is_zero(double x) { return x == 0 && !std::signbit(x); }

  /// A number from 0 to count − 1; always 0 in spelling 0.
  std::size_t choice(std::size_t count) {
    if (is_plain_) {
      return 0;
    }
    state_ += 0x9e3779b97f4a7c15U;
    return static_cast<std::size_t>(mixed(state_) % count);
  }

  /// Leaves out a default value in spelling 0, and in about half of the others.
  template <class Value>
  void add_unless_left_out(Fields& fields, std::string_view name, bool is_default, const Value& value) {
    if (!is_default || choice(2) == 1) {
      fields.emplace_back(name, value());
    }
  }

  std::string number(double x) {
    const std::vector<std::string> ways = spellings_of(x);
    return ways[choice(ways.size())];
  }

  template <class Vector>
  std::string vector(const Vector& v) {
    std::string text;
    for (Eigen::Index i = 0; i < v.size(); ++i) {
      text += (i == 0 ? std::string() : ',' + blank()) + number(v[i]);
    }
    return '[' + text + ']';
  }

  std::string body(const Body& body) {
    Fields fields;
    add_unless_left_out(fields, "immovable", !body.immovable,
                        [&] { return std::string(body.immovable ? "true" : "false"); });
    if (!body.immovable) {
      const Quaternion<double>& q = body.orientation;
      const bool is_identity = q[0] == 1 && is_zero(q[1]) && is_zero(q[2]) && is_zero(q[3]);
      fields.emplace_back("mass", number(body.mass));
      fields.emplace_back("principal_inertia", vector(body.principal_inertia));
      add_unless_left_out(fields, "orientation", is_identity, [&] { return vector(q); });
    }
    fields.emplace_back("position", vector(body.position));
    fields.emplace_back("velocity", vector(body.velocity));
    fields.emplace_back("angular_velocity", vector(body.angular_velocity));
    return object(std::move(fields));
  }

  std::string object(Fields fields) {
    if (choice(2) == 1) {
      for (std::size_t i = fields.size(); i > 1; --i) {
        std::swap(fields[i - 1], fields[choice(i)]);
      }
    }
    std::string text;
    for (const auto& [name, value] : fields) {
      text += fmt::format("{}\"{}\":{}{}", text.empty() ? std::string() : ',' + blank(), name, blank(), value);
    }
    return '{' + text + '}';
  }

  /// Blanks between two tokens of one line.
  std::string blank() {
    constexpr std::array<std::string_view, 4> blanks{"", "", " ", "\t"};
    return std::string(blanks[choice(blanks.size())]);
  }

  std::uint64_t state_;
  bool is_plain_;
};

void add(std::uint64_t& hash, double number) { hash = mixed(hash + std::bit_cast<std::uint64_t>(number)); }

}  // namespace

std::uint64_t hash_of(const Collision& collision) {
  std::uint64_t hash = 0;
  const auto add_all = [&](const auto& vector) {
    for (Eigen::Index i = 0; i < vector.size(); ++i) {
      add(hash, vector[i]);
    }
  };
  for (const Body* body : {&collision.a, &collision.b}) {
    add(hash, body->immovable ? 1 : 0);
    if (!body->immovable) {  // the mass and moments of an immovable body are not written
      add(hash, body->mass);
      add_all(body->principal_inertia);
      add_all(body->orientation);
    }
    add_all(body->position);
    add_all(body->velocity);
    add_all(body->angular_velocity);
  }
  add_all(collision.point);
  add_all(collision.normal);
  add(hash, collision.restitution);
  add(hash, collision.friction);
  add(hash, collision.tangential_restitution);
  return hash;
}

std::string spelt(const Collision& collision, unsigned spelling) {
  CAROM_EXPECTS(spelling < spelling_count, spelling);
  return Writer(hash_of(collision) + spelling, spelling == 0).collision(collision);
}

}  // namespace carom::subjects::protocol
