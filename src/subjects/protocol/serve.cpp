// SPDX-License-Identifier: BSL-1.0
#include <cstdint>
#include <iostream>
#include <string>
#include <utility>

#include <carom/collision/json/json.hpp>
#include <carom/subjects/protocol/hex_lines.hpp>
#include <carom/subjects/protocol/messages.hpp>
#include <carom/subjects/protocol/serve.hpp>

namespace carom::subjects::protocol {
namespace {

std::uint64_t id_of(const nlohmann::json& request) {
  const nlohmann::json& id = request.at("id");
  if (!id.is_number_unsigned()) {
    throw FormatError("/id", "expected an integer from 0 to 2^64 - 1");
  }
  return id.get<std::uint64_t>();
}

Answer answer_to(Session& session, const Collision& collision) {
  return std::move(session(std::span(&collision, 1)).at(0));
}

/// The reply to a request; empty for `stop`.
std::string reply_to(const std::string& line, const Introduction& introduction, Session& session) {
  if (introduction.numbers == Numbers::hex && !line.starts_with('{')) {
    const HexRequest request = hex_request_from(line);
    std::string reply;
    add_hex_reply(reply, request.id, answer_to(session, request.collision));
    return reply;
  }
  const nlohmann::json request = parse_json(line);
  const std::string command = request.value("cmd", "");
  if (command == "start") {
    return introduction_reply(introduction);
  }
  if (command == "solve") {
    const Collision collision = collision_from_json(request.at("collision"), "/collision");
    return answer_reply(id_of(request), answer_to(session, collision), introduction.precision);
  }
  if (command == "stop") {
    return {};
  }
  throw FormatError("/cmd", "expected start, solve or stop");
}

}  // namespace

int serve(const Subject& subject, std::istream& input, std::ostream& output, Numbers numbers) {
  const Introduction introduction{subject.name,   subject.version,  subject.precision,
                                  subject.law,    subject.deviates, subject.shows_collision_matrix,
                                  subject.domain, subject.effects,  numbers};
  Session session = subject.open();
  for (std::string line; std::getline(input, line);) {
    try {
      const std::string reply = reply_to(line, introduction, session);
      if (reply.empty()) {
        break;
      }
      output << reply << std::flush;  // so that a crash or hang is found on its own request
    } catch (const std::exception& error) {
      std::cerr << subject.name << ": " << error.what() << '\n';
      return 2;
    }
  }
  session.close();
  return 0;
}

}  // namespace carom::subjects::protocol
