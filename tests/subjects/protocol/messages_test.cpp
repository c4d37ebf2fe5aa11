// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include <carom/collision/doubles.hpp>
#include <carom/collision/json/json.hpp>
#include <carom/collision/json/text.hpp>
#include <carom/subjects/catalogue.hpp>
#include <carom/subjects/protocol/hex_lines.hpp>
#include <carom/subjects/protocol/messages.hpp>
#include <carom/subjects/protocol/serve.hpp>

#include "support/cases.hpp"
#include "support/expect_in.hpp"
#include "support/message_of.hpp"

namespace carom::subjects::protocol {
namespace {

constexpr const char* sound =
    R"({"protocol":1,"name":"rapier3d","version":"0.21.0","precision":"binary32","model":"frictionless"})";

std::string with(std::string text, const std::string& part, const std::string& replacement) {
  return text.replace(text.find(part), part.size(), replacement);
}

template <class F>
void expect_format_error(const F& f, const std::string& says) {
  unit::expect_in(unit::message_of<FormatError>(f), {says});
}

TEST(Introduction, IsReadAsTheProtocolHasIt) {
  const Introduction read = introduction_from(sound);
  EXPECT_EQ(read, (Introduction{"rapier3d", "0.21.0", Precision::binary32, Law::frictionless, {}}));
  const Introduction deviating = introduction_from(with(sound, "}", R"(,"deviates":["push"],"more":1})"));
  EXPECT_EQ(deviating.deviates, std::vector<std::string>{"push"});
  EXPECT_EQ(introduction_from(introduction_reply(read)), read);
}

TEST(Introduction, MayShowAMatrixAndDeclareADomainAndEffects) {
  const Introduction plain = introduction_from(with(sound, "}", R"(,"matrix":false})"));
  EXPECT_FALSE(plain.matrix);
  EXPECT_EQ(plain.domain, "");
  EXPECT_EQ(plain.effects, DeclaredEffects{});
  EXPECT_EQ(introduction_from(sound), plain);
  const Introduction declared =
      introduction_from(with(sound, "}",
                             R"(,"matrix":true,"domain":{"size":[0.125,1e6],"mass_ratio":[null,100]},)"
                             R"("claims":{"restitution_threshold":0.5,"max_speed":100}})"));
  EXPECT_TRUE(declared.matrix);
  EXPECT_EQ(declared.domain, "mass_ratio=:100,size=0.125:1000000.0");
  EXPECT_EQ(declared.effects, (DeclaredEffects{{{0.5, 0, 0, 0, 100, 0}}}));
  EXPECT_EQ(introduction_from(introduction_reply(declared)), declared);
}

TEST(Introduction, MayAskForHexadecimalNumbers) {
  EXPECT_EQ(introduction_from(sound).numbers, Numbers::decimal);
  EXPECT_EQ(introduction_from(with(sound, "}", R"(,"numbers":"decimal"})")).numbers, Numbers::decimal);
  const std::string asking = with(sound, "}", R"(,"numbers":"hex"})");
  const Introduction read = introduction_from(asking);
  EXPECT_EQ(read.numbers, Numbers::hex);
  EXPECT_EQ(introduction_from(introduction_reply(read)), read);
  expect_format_error([&] { return introduction_from(with(asking, "binary32", "extended")); },
                      "/numbers: hex has the bits of binary64, but the precision is extended; expected decimal");
  for (const char* other : {"\"octal\"", "16", "true"}) {
    expect_format_error([&] { return introduction_from(with(asking, "\"hex\"", other)); },
                        std::string("/numbers: expected decimal or hex, found ") + other);
  }
}

TEST(Introduction, MayClaimEveryLaw) {
  for (const Law law : all_laws) {
    EXPECT_EQ(introduction_from(with(sound, "frictionless", std::string(name_of(law)))).law, law);
  }
}

TEST(Introduction, IsRefusedWithThePlaceWhereItIsWrong) {
  for (const auto& [part, replacement, says] :
       std::vector<std::array<std::string, 3>>{{"\"protocol\":1", "\"protocol\":2", "/protocol: expected 1, found 2"},
                                               {"\"protocol\":1,", "", "/protocol: is missing"},
                                               {"rapier3d", "", "/name"},
                                               {"\"rapier3d\"", "7", "/name"},
                                               {"binary32", "binary16", "/precision"},
                                               {"frictionless", "sticky", "/model"},
                                               {"}", R"(,"deviates":"push"})", "/deviates"},
                                               {"}", R"(,"matrix":1})", "/matrix: expected true or false, found 1"},
                                               {"}", R"(,"domain":[1,2]})", "/domain: expected an object"},
                                               {"}", R"(,"domain":{"size":[1]}})", "/domain/size: expected two"},
                                               {"}", R"(,"domain":{"size":["a",1]}})", "/domain/size: expected two"},
                                               {"}", R"(,"claims":[1]})", "/claims: expected an object"},
                                               {"}", R"(,"claims":{"slop":"a"}})", "/claims/slop: expected a positive"},
                                               {"}", R"(,"claims":{"linear_damping":1}})", "below 1, found 1"},
                                               {"}", R"(,"claims":{"slip":1}})", "/claims/slip: is not an effect"},
                                               {"}", R"(,"name":"twice"})", "twice"},
                                               {"{", "", "not JSON"}}) {
    const std::string text = with(sound, part, replacement);
    expect_format_error([&] { return introduction_from(text); }, says);
  }
}

const std::string reply = R"({"id":5,"a":{"velocity":[1,2.5,-3e-5],"angular_velocity":[0,0,0]},)"
                          R"("b":{"velocity":["nan","inf","-inf"],"angular_velocity":[0.1,0,0]}})";

TEST(Reply, IsReadAsTheProtocolHasIt) {
  const auto outcome = std::get<ReportedOutcome>(answer_from(reply, 5, Precision::binary64));
  EXPECT_EQ(outcome.a.velocity, (Vector3<long double>{1, 2.5, -3e-5}));
  EXPECT_TRUE(std::isnan(outcome.b.velocity[0]));
  EXPECT_EQ(outcome.b.velocity[1], std::numeric_limits<long double>::infinity());
  EXPECT_EQ(outcome.b.velocity[2], -std::numeric_limits<long double>::infinity());
  EXPECT_EQ(outcome.b.angular_velocity[0], 0.1);
  EXPECT_EQ(std::get<Skipped>(answer_from(R"({"id":5,"skipped":"why"})", 5, Precision::binary64)).why, "why");
  EXPECT_EQ(std::get<Refused>(answer_from(R"({"id":5,"error":"why"})", 5, Precision::binary64)).why, "why");
}

TEST(Reply, HasTheBitsOfTheSubjectsPrecision) {
  const long double third = 1.0L / 3;
  ReportedOutcome outcome;
  outcome.a.velocity[0] = third;
  const std::string text = answer_reply(5, outcome, Precision::extended);
  EXPECT_EQ(std::get<ReportedOutcome>(answer_from(text, 5, Precision::extended)).a.velocity[0], third);
  EXPECT_EQ(std::get<ReportedOutcome>(answer_from(text, 5, Precision::binary64)).a.velocity[0],
            static_cast<long double>(static_cast<double>(third)));
}

/// Each decimal is close to the midpoint of two binary64 numbers. A reader that first rounds the decimal to the
/// extended format gets the midpoint. Then it rounds the midpoint to the wrong neighbour.
TEST(Reply, RoundsADecimalOnce) {
  for (const auto& [decimal, nearest, other] : std::vector<std::tuple<std::string, double, double>>{
           {"8.68411587126273421", 0x1.15e446f7b7ef9p+3, 0x1.15e446f7b7ef8p+3},
           {"6.1663421746479492034", 0x1.8aa559a603bddp+2, 0x1.8aa559a603bdep+2},
           {"-4.0889836479615406793", -0x1.05b1e87877e8fp+2, -0x1.05b1e87877e90p+2},
           {"3.168124975937861576e0", 0x1.95851e84a59e9p+1, 0x1.95851e84a59eap+1},
           {"298043343876542.699E-14", 0x1.7d7ed7c9b37f7p+1, 0x1.7d7ed7c9b37f8p+1}}) {
    if constexpr (std::numeric_limits<long double>::digits == 64) {
      EXPECT_EQ(static_cast<double>(std::strtold(decimal.c_str(), nullptr)), other) << decimal << " tells nothing";
    }
    const std::string text = with(reply, "2.5", decimal);
    for (const Precision precision : {Precision::binary32, Precision::binary64}) {
      EXPECT_EQ(std::get<ReportedOutcome>(answer_from(text, 5, precision)).a.velocity[1], nearest) << decimal;
    }
    EXPECT_EQ(std::get<ReportedOutcome>(answer_from(text, 5, Precision::extended)).a.velocity[1],
              std::strtold(decimal.c_str(), nullptr));
  }
}

/// 2⁵³ + 1 is the midpoint of two binary64 numbers. The last integer exceeds 64 bits.
TEST(Reply, RoundsIntegersAndNumbersBeyondTheRangeOfBinary64) {
  for (const auto& [number, nearest] : std::vector<std::pair<std::string, double>>{{"9007199254740993", 0x1p53},
                                                                                   {"-9007199254740993", -0x1p53},
                                                                                   {"36893488147419103233", 0x1p65},
                                                                                   {"1e999", HUGE_VAL},
                                                                                   {"-1e999", -HUGE_VAL},
                                                                                   {"1e-999", 0}}) {
    const auto answer = answer_from(with(reply, "2.5", number), 5, Precision::binary64);
    EXPECT_EQ(std::get<ReportedOutcome>(answer).a.velocity[1], nearest) << number;
  }
}

/// A binary64 number such as 0.1 needs more digits in the extended format than in binary64.
TEST(Reply, LosesNoBitOfABinary64NumberReadAsExtended) {
  ReportedOutcome outcome;
  outcome.a.velocity = {0.1, 1.0 / 3, 0.006120156079754623772160027};
  const auto read =
      std::get<ReportedOutcome>(answer_from(answer_reply(5, outcome, Precision::extended), 5, Precision::extended));
  EXPECT_EQ(read.a.velocity, outcome.a.velocity);
}

TEST(Reply, IsRefusedWithThePlaceWhereItIsWrong) {
  for (const auto& [part, replacement, says] : std::vector<std::array<std::string, 3>>{
           {"\"id\":5", "\"id\":6", "/id: expected 5, found 6"},
           {"\"id\":5", "\"id\":\"5\"", "/id"},
           {"\"id\":5,", "", "/id: is missing"},
           {"\"angular_velocity\":[0,0,0]", "\"spin\":[0,0,0]", "/a/angular_velocity: is missing"},
           {"[1,2.5,-3e-5]", "[1,2.5]", "/a/velocity: expected an array of 3 numbers, found [1,2.5]"},
           {"2.5", "\"fast\"", "/a/velocity/1: expected a number, found \"fast\""},
           {"2.5", "NaN", "not JSON"},
           {"\"id\":5", "\"id\":5,\"error\":\"both\"", "expected exactly one of"},
           {"\"a\":{\"velocity\":[1,2.5,-3e-5],\"angular_velocity\":[0,0,0]},", "", "/a: is missing"}}) {
    const std::string text = with(reply, part, replacement);
    expect_format_error([&] { return answer_from(text, 5, Precision::binary64); }, says);
  }
  expect_format_error([] { return answer_from(R"({"id":5})", 5, Precision::binary64); }, "expected exactly one of");
  expect_format_error([] { return answer_from(reply + std::string(1, '\0') + "more", 5, Precision::binary64); },
                      "zero byte");
  expect_format_error([] { return answer_from("[]", 5, Precision::binary64); }, "expected an object");
  expect_format_error([] { return answer_from(std::string(1000, '['), 5, Precision::binary64); }, "nested levels");
}

const std::string matrix_reply = with(reply, R"({"id":5)", R"({"id":5,"C":[[1,2,3],[4,"nan",6],[7,8,"-inf"]])");

TEST(Reply, HasItsMatrixByRows) {
  const auto outcome = std::get<ReportedOutcome>(answer_from(matrix_reply, 5, Precision::binary64, true));
  ASSERT_TRUE(outcome.collision_matrix);
  EXPECT_EQ((*outcome.collision_matrix)(0, 2), 3);
  EXPECT_EQ((*outcome.collision_matrix)(2, 0), 7);
  EXPECT_TRUE(std::isnan((*outcome.collision_matrix)(1, 1)));
  EXPECT_EQ((*outcome.collision_matrix)(2, 2), -std::numeric_limits<long double>::infinity());
  EXPECT_FALSE(std::get<ReportedOutcome>(answer_from(reply, 5, Precision::binary64, true)).collision_matrix);
  EXPECT_FALSE(std::get<ReportedOutcome>(answer_from(matrix_reply, 5, Precision::binary64)).collision_matrix)
      << "who does not say that it shows one may write what it likes";
  ReportedOutcome written;
  written.collision_matrix = Matrix3<long double>::Identity() / 3;
  (*written.collision_matrix)(0, 1) = 2;
  const std::string text = answer_reply(5, written, Precision::extended);
  const auto read = std::get<ReportedOutcome>(answer_from(text, 5, Precision::extended, true));
  EXPECT_EQ(read.collision_matrix, written.collision_matrix);
}

TEST(Reply, IsRefusedWithThePlaceWhereItsMatrixIsWrong) {
  for (const auto& [part, replacement, says] : std::vector<std::array<std::string, 3>>{
           {R"([[1,2,3],[4,"nan",6],[7,8,"-inf"]])", "7", "/C: expected an array of 3 rows, found 7"},
           {R"(,[7,8,"-inf"])", "", "/C: expected an array of 3 rows, found [[1,2,3],[4,\"nan\",6]]"},
           {"[1,2,3]", "[1,2]", "/C/0: expected an array of 3 numbers, found [1,2]"},
           {"\"nan\"", "\"none\"", "/C/1/1: expected a number, found \"none\""},
           {"\"nan\"", "null", "/C/1/1: expected a number, found null"}}) {
    const std::string text = with(matrix_reply, part, replacement);
    expect_format_error([&] { return answer_from(text, 5, Precision::binary64, true); }, says);
  }
}

TEST(Matrix, IsOwedWhereTheContactCollides) {
  Collision hit;
  hit.a.position = {0, 1, 0};
  hit.a.velocity = {0, -0.1, 0};
  hit.b.immovable = true;
  hit.normal = {0, 1, 0};
  Outcome<long double> outcome{{{0, 0.1L, 0}, {0, 0, 0}}, {}};
  EXPECT_TRUE(owes_matrix(hit, outcome, Precision::binary64));

  EXPECT_FALSE(owes_matrix(hit, reported(unchanged(hit)), Precision::binary64))
      << "it took the contact for one that does not";
  const Outcome<long double> rounded = map_outcome<long double>(
      unchanged(hit), [](double x) { return static_cast<long double>(static_cast<float>(x)); });
  EXPECT_FALSE(owes_matrix(hit, rounded, Precision::binary32));
  EXPECT_TRUE(owes_matrix(hit, rounded, Precision::binary64));

  Collision part = hit;
  part.a.velocity[1] = 0.1;
  EXPECT_FALSE(owes_matrix(part, outcome, Precision::binary64));
  Collision inert = hit;
  inert.a.immovable = true;
  EXPECT_FALSE(owes_matrix(inert, outcome, Precision::binary64));
  Collision invalid = hit;
  invalid.a.mass = 0;
  EXPECT_FALSE(owes_matrix(invalid, outcome, Precision::binary64));
}

constexpr const char* zero = " 0000000000000000";
constexpr const char* one = " 3ff0000000000000";

std::string times(int count, const std::string& text) {
  std::string result;
  for (int i = 0; i < count; ++i) {
    result += text;
  }
  return result;
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
  const std::string request = line_of(request_text(7, Collision{}));
  for (const auto& [text, says] : std::vector<std::array<std::string, 2>>{
           {"x" + request, "/id: expected an integer from 0 to 2^64 - 1, found x7"},
           {"-" + request, "/id: expected"},
           {"18446744073709551616" + request.substr(1), "/id: expected"},
           {"", "/id: expected"},
           {"7", "/a/immovable: is missing; expected 45 numbers, found 0"},
           {request.substr(0, request.size() - 17),
            "/tangential_restitution: is missing; expected 45 numbers, found 44"},
           {request + one, "expected 45 numbers, found more: 3ff0000000000000"},
           {with(request, one, " 3FF000000000000g"), "/a/mass: expected 16 hexadecimal digits, found 3FF000000000000g"},
           {with(request, one, " 3ff"), "/a/mass: expected 16 hexadecimal digits, found 3ff"},
           {with(request, one, "  3ff000000000000"), "/a/mass: expected 16 hexadecimal digits, found "}}) {
    const std::string& line = text;
    expect_format_error([&] { return hex_request_from(line); }, says);
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
           {with(outcome_line, zero, " 0x00000000000000"), "/a/angular_velocity/0: expected 16 hexadecimal digits"},
           {matrix_line, "expected 12 numbers, found more: 7ff8000000000000"},
           {outcome_line + "\t", "/b/angular_velocity/2: expected 16 hexadecimal digits"}}) {
    const std::string& line = text;
    expect_format_error([&] { return answer_from_hex(line, 5, false); }, says);
  }
  const std::string short_matrix = matrix_line.substr(0, matrix_line.size() - 17);
  expect_format_error([&] { return answer_from_hex(short_matrix, 5, true); },
                      "/C/2/2: is missing; expected 21 numbers, found 20");
}

TEST(ForeignText, IsMadePrintable) {
  EXPECT_EQ(printable("plain\tand\nlines", 100), "plain\tand\nlines");
  EXPECT_EQ(printable("\x1b[31mred\r", 100), "?[31mred?");
  EXPECT_EQ(printable("a\xff"
                      "b",
                      100),
            "a\xef\xbf\xbd"
            "b");
  EXPECT_EQ(printable("abcdef", 3), "abc…");
  EXPECT_EQ(printable("\xc2\x9b"
                      "31m",
                      100),
            "?31m");  // C1: controls terminals as ESC [ does
  EXPECT_EQ(printable("a\xe2\x80\xae"
                      "b",
                      100),
            "a?b");  // reverses the writing direction
  for (const char* control :
       {"\u061c", "\u200e", "\u200f", "\u2028", "\u202a", "\u202c", "\u2066", "\u2069", "\u0080"}) {
    EXPECT_EQ(printable(control, 100), "?");
  }
  EXPECT_EQ(printable("\u2027 \u202f \u2065 \u00a0", 100), "\u2027 \u202f \u2065 \u00a0");
  EXPECT_EQ(printable_line("a\nb\tc", 100), "a b c");
  EXPECT_EQ(printable("ü", 1), "\xef\xbf\xbd…");
}

struct Served {
  int status;
  std::string replies;
};

Served served(const std::string& requests, Numbers numbers = Numbers::decimal) {
  std::istringstream input(requests);
  std::ostringstream output;
  const int status = serve(subject_named("reflection-double").value(), input, output, numbers);
  return {status, output.str()};
}

std::string with_id(const std::string& id) {
  std::string request = solve_request(7, Collision{});
  return request.replace(request.find("\"id\":7") + 5, 1, id);
}

TEST(Serve, AnswersByTheNumberOfTheRequest) {
  for (const char* id : {"0", "7", "18446744073709551615"}) {
    const Served answer = served(with_id(id));
    EXPECT_EQ(answer.status, 0) << id;
    EXPECT_EQ(answer.replies.find(std::string("{\"id\":") + id + ','), 0U) << answer.replies;
  }
}

/// Counts how often it is flushed.
class CountingBuffer : public std::stringbuf {
 public:
  int flushes = 0;

 private:
  int sync() override {
    ++flushes;
    return std::stringbuf::sync();
  }
};

/// If the solver crashes or hangs, the gate has the replies to all earlier requests, and knows the request that failed.
TEST(Serve, FlushesEachReply) {
  std::istringstream input(start_request() + with_id("1") + with_id("2") + with_id("3"));
  CountingBuffer buffer;
  std::ostream output(&buffer);
  EXPECT_EQ(serve(subject_named("reflection-double").value(), input, output), 0);
  EXPECT_EQ(buffer.flushes, 4);
}

TEST(Serve, RefusesANumberThatIsNone) {
  for (const char* id : {"-1", "1.5", "1e300", "18446744073709551616", "\"1\"", "null"}) {
    const Served answer = served(with_id(id));
    EXPECT_EQ(answer.status, 2) << id;
    EXPECT_EQ(answer.replies, "") << id;
  }
}

TEST(Serve, AnswersInTheFormOfTheRequest) {
  std::string request;
  add_hex_request(request, 7, Collision{});
  const Served answer = served(start_request() + request + with_id("8") + stop_request(), Numbers::hex);
  EXPECT_EQ(answer.status, 0);
  std::istringstream replies(answer.replies);
  std::string line;
  std::getline(replies, line);
  EXPECT_EQ(introduction_from(line).numbers, Numbers::hex);
  std::getline(replies, line);
  EXPECT_TRUE(std::holds_alternative<ReportedOutcome>(answer_from_hex(line, 7, true))) << line;
  std::getline(replies, line);
  EXPECT_TRUE(std::holds_alternative<ReportedOutcome>(answer_from(line, 8, Precision::binary64, true))) << line;
  EXPECT_FALSE(std::getline(replies, line));
}

TEST(Serve, RefusesHexadecimalNumbersThatAreMalformedOrNotAskedFor) {
  std::string request;
  add_hex_request(request, 7, Collision{});
  EXPECT_EQ(served(request).status, 2);
  EXPECT_EQ(served(request.substr(0, 100) + '\n', Numbers::hex).status, 2);
  EXPECT_EQ(served(request, Numbers::hex).status, 0);
}

TEST(Serve, RefusesWhatTheGateWouldNotRead) {
  constexpr std::size_t deep = 200000;  // levels: recursion through them would overflow the stack
  const std::string nested = std::string(deep, '[') + std::string(deep, ']');
  for (const std::string& request :
       {std::string(R"({"cmd":"stop","cmd":"start"})"), R"({"cmd":"solve","id":1,"collision":)" + nested + '}'}) {
    const Served answer = served(request + '\n');
    EXPECT_EQ(answer.status, 2);
    EXPECT_EQ(answer.replies, "");
  }
}

}  // namespace
}  // namespace carom::subjects::protocol
