// SPDX-License-Identifier: BSL-1.0
#include <cstddef>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include <carom/subjects/catalogue.hpp>
#include <carom/subjects/protocol/hex_lines.hpp>
#include <carom/subjects/protocol/messages.hpp>
#include <carom/subjects/protocol/serve.hpp>

namespace carom::subjects::protocol {
namespace {

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
