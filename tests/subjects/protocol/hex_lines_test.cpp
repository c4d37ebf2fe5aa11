// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/collision/doubles.hpp>
#include <carom/collision/json/json.hpp>
#include <carom/subjects/protocol/hex_lines.hpp>
#include <carom/subjects/protocol/messages.hpp>

#include "support/cases.hpp"

namespace carom::subjects::protocol {
namespace {

constexpr const char* zero = " 0000000000000000";
constexpr const char* one = " 3ff0000000000000";

std::string times(int count, const std::string& text) {
  std::string result;
  for (int i = 0; i < count; ++i) {
    result += text;
  }
  return result;
}

std::string with_part(std::string text, const std::string& part, const std::string& replacement) {
  return text.replace(text.find(part), part.size(), replacement);
}

std::string error_of(const std::function<void()>& f) {
  try {
    f();
  } catch (const FormatError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

std::string request_text(std::uint64_t id, const Collision& collision) {
  std::string text;
  add_hex_request(text, id, collision);
  return text;
}

std::string reply_text(std::uint64_t id, const Answer& answer) {
  std::string text;
  add_hex_reply(text, id, answer);
  return text;
}

/// The line without its line end.
std::string line_of(const std::string& text) {
  EXPECT_EQ(text.find('\n'), text.size() - 1);
  return text.substr(0, text.size() - 1);
}

TEST(HexRequest, IsWrittenAsTheProtocolHasIt) {
  Collision collision;
  collision.a.velocity = {0.1, -2, 0};
  collision.b.immovable = true;
  const std::string a = zero + times(5, one) + times(6, zero) + " 3fb999999999999a c000000000000000" + times(4, zero);
  const std::string b = one + times(17, zero);
  EXPECT_EQ(request_text(17, collision), "17" + a + b + times(4, zero) + one + zero + one + zero + zero + '\n');
}

TEST(HexRequest, SurvivesBeingWritten) {
  for (const auto& [family, drawn] : unit::valid_cases(10)) {
    const HexRequest read = hex_request_from(line_of(request_text(18446744073709551615U, drawn.collision)));
    EXPECT_EQ(read.id, 18446744073709551615U);
    EXPECT_EQ(doubles_of(read.collision), doubles_of(drawn.collision)) << family;
  }
}

TEST(HexRequest, IsRefusedWithThePlaceWhereItIsWrong) {
  const std::string sound = line_of(request_text(7, Collision{}));
  for (const auto& [text, says] : std::vector<std::array<std::string, 2>>{
           {"x" + sound, "/id: expected an integer from 0 to 2^64 - 1, found x7"},
           {"-" + sound, "/id: expected"},
           {"18446744073709551616" + sound.substr(1), "/id: expected"},
           {"", "/id: expected"},
           {"7", "/a/immovable: is missing; expected 45 numbers, found 0"},
           {sound.substr(0, sound.size() - 17), "/tangential_restitution: is missing; expected 45 numbers, found 44"},
           {sound + one, "expected 45 numbers, found more: 3ff0000000000000"},
           {with_part(sound, one, " 3FF000000000000g"),
            "/a/mass: expected 16 hexadecimal digits, found 3FF000000000000g"},
           {with_part(sound, one, " 3ff"), "/a/mass: expected 16 hexadecimal digits, found 3ff"},
           {with_part(sound, one, "  3ff000000000000"), "/a/mass: expected 16 hexadecimal digits, found "}}) {
    const std::string& line = text;
    EXPECT_EQ(error_of([&] { (void)hex_request_from(line); }).find(says), 0U)
        << error_of([&] { (void)hex_request_from(line); }) << " does not begin with " << says;
  }
}

const std::string outcome_line = "5" + times(3, one) + times(9, zero);
const std::string matrix_line = outcome_line + " 7ff8000000000000 FFF0000000000000" + times(7, one);

TEST(HexReply, IsReadAsTheProtocolHasIt) {
  for (const char* end : {"", "\r", " "}) {
    const auto outcome = std::get<ReportedOutcome>(answer_from_hex(outcome_line + end, 5, true));
    EXPECT_EQ(outcome.a.velocity, Vector3<long double>(1, 1, 1));
    EXPECT_EQ(outcome.b.angular_velocity, Vector3<long double>(0, 0, 0));
    EXPECT_FALSE(outcome.collision_matrix);
  }
  const auto outcome = std::get<ReportedOutcome>(answer_from_hex(matrix_line, 5, true));
  ASSERT_TRUE(outcome.collision_matrix);
  EXPECT_TRUE(std::isnan((*outcome.collision_matrix)(0, 0)));
  EXPECT_EQ((*outcome.collision_matrix)(0, 1), -std::numeric_limits<long double>::infinity());
  EXPECT_EQ((*outcome.collision_matrix)(2, 2), 1);
  EXPECT_EQ(std::get<Skipped>(answer_from_hex("5 skipped too fast", 5, false)).why, "too fast");
  EXPECT_EQ(std::get<Refused>(answer_from_hex("5 error", 5, false)).why, "");
}

TEST(HexReply, SurvivesBeingWritten) {
  ReportedOutcome outcome;
  outcome.a.velocity = {0.1, -0.0, std::numeric_limits<long double>::infinity()};
  outcome.b.angular_velocity = {5e-324, 1, -1.7976931348623157e308};
  outcome.collision_matrix = Matrix3<long double>::Identity();
  (*outcome.collision_matrix)(0, 1) = 2;
  for (const bool with_matrix : {false, true}) {
    ReportedOutcome written = outcome;
    if (!with_matrix) {
      written.collision_matrix.reset();
    }
    const auto read = std::get<ReportedOutcome>(answer_from_hex(line_of(reply_text(5, written)), 5, true));
    EXPECT_EQ(doubles_of<long double>(read), doubles_of<long double>(outcome));
    EXPECT_TRUE(std::signbit(read.a.velocity[1]));
    EXPECT_EQ(read.collision_matrix, written.collision_matrix);
  }
  EXPECT_EQ(std::get<Skipped>(answer_from_hex(line_of(reply_text(5, Skipped{"a\nb"})), 5, true)).why, "a b");
  EXPECT_EQ(std::get<Refused>(answer_from_hex(line_of(reply_text(5, Refused{"c"})), 5, true)).why, "c");
  EXPECT_EQ(std::get<Refused>(answer_from_hex(line_of(reply_text(5, Failed{"d"})), 5, true)).why, "d");
}

TEST(HexReply, IsRefusedWithThePlaceWhereItIsWrong) {
  for (const auto& [text, says] : std::vector<std::array<std::string, 2>>{
           {"6" + outcome_line.substr(1), "/id: expected 5, found 6"},
           {R"({"id":5})", R"(/id: expected 5, found {"id":5})"},
           {"5", "/a/velocity/0: is missing; expected 12 numbers, found 0"},
           {"5 skippedit", "/a/velocity/0: expected 16 hexadecimal digits, found skippedit"},
           {"5" + times(11, zero), "/b/angular_velocity/2: is missing; expected 12 numbers, found 11"},
           {with_part(outcome_line, zero, " 0x00000000000000"),
            "/a/angular_velocity/0: expected 16 hexadecimal digits"},
           {matrix_line, "expected 12 numbers, found more: 7ff8000000000000"},
           {outcome_line + "\t", "/b/angular_velocity/2: expected 16 hexadecimal digits"}}) {
    const std::string& line = text;
    EXPECT_EQ(error_of([&] { (void)answer_from_hex(line, 5, false); }).find(says), 0U)
        << error_of([&] { (void)answer_from_hex(line, 5, false); }) << " does not begin with " << says;
  }
  const std::string short_matrix = matrix_line.substr(0, matrix_line.size() - 17);
  EXPECT_EQ(error_of([&] { (void)answer_from_hex(short_matrix, 5, true); }),
            "/C/2/2: is missing; expected 21 numbers, found 20");
}

}  // namespace
}  // namespace carom::subjects::protocol
