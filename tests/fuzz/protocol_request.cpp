// SPDX-License-Identifier: BSL-1.0
#include <iostream>
#include <sstream>
#include <string>

#include <carom/collision/json/json.hpp>
#include <carom/subjects/catalogue.hpp>
#include <carom/subjects/protocol/hex_lines.hpp>
#include <carom/subjects/protocol/messages.hpp>
#include <carom/subjects/protocol/serve.hpp>

#include "target.hpp"

namespace carom::fuzz {
namespace {

namespace protocol = subjects::protocol;

/// Discards std::cerr, so that only the fuzzer writes to standard error.
class Silence {
 public:
  Silence() : kept_(std::cerr.rdbuf(dropped_.rdbuf())) {}
  ~Silence() { std::cerr.rdbuf(kept_); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  std::ostringstream dropped_;
  std::streambuf* kept_;
};

void require_right_replies(const std::string& requests, const std::string& replies, Precision precision) {
  std::istringstream asked(requests);
  std::istringstream answered(replies);
  std::string request;
  for (std::string reply; std::getline(answered, reply);) {
    require(static_cast<bool>(std::getline(asked, request)), "more replies than requests");
    if (!reply.starts_with('{')) {
      (void)protocol::answer_from_hex(reply, protocol::hex_request_from(request).id, true);
      continue;
    }
    const nlohmann::json read = parse_json(request);
    if (read.at("cmd") == "start") {
      (void)protocol::introduction_from(reply);
    } else {
      require(read.at("id").is_number_unsigned(), "a request is answered that has no number");
      (void)protocol::answer_from(reply, read.at("id").get<std::uint64_t>(), precision);
    }
  }
}

void answer(const std::string& requests, protocol::Numbers numbers) {
  static const Subject subject = subjects::subject_named("reflection-double").value();
  std::istringstream input(requests);
  std::ostringstream output;
  int status = 0;
  {
    const Silence silence;
    status = protocol::serve(subject, input, output, numbers);
  }
  require(status == 0 || status == 2, "the exit status is neither 0 nor 2");
  require_right_replies(requests, output.str(), subject.precision);
}

}  // namespace
}  // namespace carom::fuzz

CAROM_FUZZ_TARGET(protocol_request) {
  using carom::subjects::protocol::Numbers;
  const std::string requests(carom::fuzz::Input({data, size}).text());
  for (const Numbers numbers : {Numbers::decimal, Numbers::hex}) {
    carom::fuzz::answer(requests, numbers);
  }
  return 0;
}
