// SPDX-License-Identifier: BSL-1.0
#include <cstdint>
#include <iostream>
#include <string>

#include <carom/collision/json/json.hpp>
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

}  // namespace

int serve(const Subject& subject, std::istream& input, std::ostream& output) {
  Session session = subject.open();
  for (std::string line; std::getline(input, line);) {
    try {
      const nlohmann::json request = parse_json(line);
      const std::string command = request.value("cmd", "");
      if (command == "start") {
        output << introduction_reply({subject.name, subject.version, subject.precision, subject.law, subject.deviates,
                                      subject.shows_collision_matrix, subject.domain, subject.effects});
      } else if (command == "solve") {
        const Collision collision = collision_from_json(request.at("collision"), "/collision");
        output << answer_reply(id_of(request), session(std::span(&collision, 1)).at(0), subject.precision);
      } else if (command == "stop") {
        break;
      } else {
        throw FormatError("/cmd", "expected start, solve or stop");
      }
    } catch (const std::exception& error) {
      std::cerr << subject.name << ": " << error.what() << '\n';
      return 2;
    }
    if (input.rdbuf()->in_avail() <= 0) {
      output.flush();  // before it waits for input
    }
  }
  output.flush();
  session.close();
  return 0;
}

}  // namespace carom::subjects::protocol
