// SPDX-License-Identifier: BSL-1.0
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <carom/collision/json/json.hpp>
#include <carom/properties/cases/family.hpp>
#include <carom/subjects/protocol/messages.hpp>
#include <carom/subjects/protocol/spelling.hpp>

namespace carom::subjects::protocol {
namespace {

using nlohmann::json;

std::uint64_t bits_of(double number) { return std::bit_cast<std::uint64_t>(number); }

/// Every spelling of a number is valid JSON, and three decimal readers read the same bits from it.
void expect_same_bits(double number) {
  const std::vector<std::string> ways = spellings_of(number);
  EXPECT_GE(ways.size(), 3U) << number;
  for (const std::string& way : ways) {
    double read = 0;
    const auto [end, error] = std::from_chars(way.data(), way.data() + way.size(), read);
    EXPECT_EQ(error, std::errc()) << way;
    EXPECT_EQ(end, way.data() + way.size()) << way;
    EXPECT_EQ(bits_of(read), bits_of(number)) << way;
    EXPECT_EQ(bits_of(std::strtod(way.c_str(), nullptr)), bits_of(number)) << way;
    EXPECT_EQ(bits_of(json::parse(way).get<double>()), bits_of(number)) << way;
  }
}

TEST(NumberSpelling, HasTheSameBitsForEveryNumber) {
  properties::Stream stream = properties::stream_from(1);
  for (int i = 0; i < 200000; ++i) {
    const auto number = std::bit_cast<double>(stream.bits());
    if (std::isfinite(number)) {
      expect_same_bits(number);
    }
  }
  for (int i = 0; i < 20000; ++i) {
    expect_same_bits(std::ldexp(static_cast<double>(stream.bits() >> 40U), -1074));  // subnormal
    expect_same_bits(static_cast<double>(stream.integer(-100000, 100000)));
    expect_same_bits(stream.signed_unit());
    expect_same_bits(stream.integer(-999, 999) / 1000.0);
  }
  using Limits = std::numeric_limits<double>;
  for (const double number : {0.0, 1.0, 0.1, 1e300, 1e-300, 1e21, 1e22, 1e23, 1e-6, 1e-7, 0x1p53, 0x1p53 - 1, 0x1p64,
                              123456789012345680.0, Limits::max(), Limits::min(), Limits::denorm_min(), 5e-324}) {
    expect_same_bits(number);
    expect_same_bits(-number);
  }
}

TEST(NumberSpelling, HasEveryFormThatJsonAdmits) {
  const auto ways_of = [](double number) {
    const std::vector<std::string> ways = spellings_of(number);
    return std::set<std::string>(ways.begin(), ways.end());
  };
  EXPECT_EQ(ways_of(2), (std::set<std::string>{"2.0", "2", "2e0", "2E+00"}));
  EXPECT_EQ(ways_of(-1500), (std::set<std::string>{"-1500.0", "-1500", "-1.5e3", "-1.5E+03", "-15e2"}));
  EXPECT_EQ(ways_of(0.0015), (std::set<std::string>{"0.0015", "1.5e-3", "1.5E-03", "15e-4"}));
  EXPECT_EQ(ways_of(0), (std::set<std::string>{"0.0", "0", "0e0", "0E+00"}));
  EXPECT_EQ(ways_of(-0.0), (std::set<std::string>{"-0.0", "-0e0", "-0E+00"})) << "an integer −0 has no sign to many";
  EXPECT_EQ(ways_of(1e300), (std::set<std::string>{"1e300", "1E+300"}));
  EXPECT_EQ(ways_of(std::nan("")), std::set<std::string>{"\"nan\""});
  EXPECT_EQ(ways_of(-std::numeric_limits<double>::infinity()), std::set<std::string>{"\"-inf\""});
}

std::vector<Collision> many_collisions() {
  std::vector<Collision> collisions;
  for (const properties::Family& family : properties::all_families()) {
    for (std::uint64_t i = 0; i < 40; ++i) {
      collisions.push_back(properties::drawn_case(family, 1, i).collision);
    }
  }
  return collisions;
}

TEST(Spelling, IsTheSameCollisionInEachOfTheWays) {
  for (const Collision& collision : many_collisions()) {
    std::set<std::string> spellings;
    for (unsigned spelling = 0; spelling < spelling_count; ++spelling) {
      const std::string text = spelt(collision, spelling);
      EXPECT_EQ(text.find_first_of("\n\r"), std::string::npos) << "a request is one line";
      EXPECT_EQ(hash_of(collision_from_json(json::parse(text))), hash_of(collision)) << text;
      EXPECT_EQ(spelt(collision, spelling), text);
      spellings.insert(text);
    }
    EXPECT_EQ(spellings.size(), spelling_count);
  }
}

/// Each alternative spelling occurs in a tenth to nine tenths of all requests. Only blanks may occur in all requests.
TEST(Spelling, UsesEachFreedomOfTheProtocolOften) {
  std::map<std::string, int> seen;
  int all = 0;
  for (const Collision& collision : many_collisions()) {
    if (collision.a.immovable || collision.b.immovable) {
      continue;
    }
    Collision plain = collision;
    plain.a.orientation = {1, 0, 0, 0};
    plain.friction = 0;
    plain.tangential_restitution = 0;
    plain.restitution = 1;
    for (unsigned spelling = 1; spelling < spelling_count; ++spelling) {
      const std::string text = spelt(plain, spelling);
      const auto ordered = nlohmann::ordered_json::parse(text);
      ++all;
      seen["immovable"] += ordered.at("a").contains("immovable") ? 1 : 0;
      seen["orientation"] += ordered.at("a").contains("orientation") ? 1 : 0;
      seen["friction"] += ordered.contains("friction") ? 1 : 0;
      seen["tangential_restitution"] += ordered.contains("tangential_restitution") ? 1 : 0;
      seen["a first"] += ordered.begin().key() == "a" ? 1 : 0;
      seen["position before velocity"] += text.find("\"position\"") < text.find("\"velocity\"") ? 1 : 0;
      seen["1 as an integer"] += ordered.at("restitution").is_number_integer() ? 1 : 0;
      seen["blanks"] += text.find_first_of(" \t") != std::string::npos ? 0 : 1;
    }
  }
  for (const auto& [what, count] : seen) {
    EXPECT_GT(count, what == "blanks" ? -1 : all / 10) << what;
    EXPECT_LT(count, 9 * all / 10) << what;
  }
}

TEST(Spelling, OfARequestIsReadAsTheSameRequest) {
  const Collision collision = many_collisions().front();
  for (unsigned spelling = 0; spelling < spelling_count; ++spelling) {
    const std::string line = solve_request(17, collision, spelling);
    EXPECT_EQ(line.find('\n'), line.size() - 1);
    const json request = json::parse(line);
    EXPECT_EQ(request.at("cmd"), "solve");
    EXPECT_EQ(request.at("id"), 17);
    EXPECT_EQ(request.size(), 3U);
    EXPECT_EQ(hash_of(collision_from_json(request.at("collision"))), hash_of(collision));
  }
}

}  // namespace
}  // namespace carom::subjects::protocol
