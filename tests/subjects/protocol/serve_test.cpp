// SPDX-License-Identifier: BSL-1.0
#include <cstddef>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include <carom/subjects/catalogue.hpp>
#include <carom/subjects/protocol/messages.hpp>
#include <carom/subjects/protocol/serve.hpp>

namespace carom::subjects::protocol {
namespace {

struct Served {
  int status;
  std::string replies;
};

Served served(const std::string& requests) {
  std::istringstream input(requests);
  std::ostringstream output;
  const int status = serve(subject_named("reflection-double").value(), input, output);
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

TEST(Serve, RefusesANumberThatIsNone) {
  for (const char* id : {"-1", "1.5", "1e300", "18446744073709551616", "\"1\"", "null"}) {
    const Served answer = served(with_id(id));
    EXPECT_EQ(answer.status, 2) << id;
    EXPECT_EQ(answer.replies, "") << id;
  }
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
