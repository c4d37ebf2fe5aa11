// SPDX-License-Identifier: BSL-1.0
// A sound subject with the fault that the first argument names. The subject's name is the second argument, or the
// process id.
#include <csignal>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>
#include <regex>
#include <string>

#include <unistd.h>

#include <carom/collision/json/json.hpp>
#include <carom/collision/validate.hpp>
#include <carom/subjects/catalogue.hpp>
#include <carom/subjects/protocol/hex_lines.hpp>
#include <carom/subjects/protocol/messages.hpp>

namespace carom {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr std::uint64_t faulty_solve = 3;

[[noreturn]] void hang() {
  std::cout.flush();
  for (;;) {
    pause();
  }
}

void write_megabytes(std::ostream& stream, int megabytes, bool with_line_ends) {
  const std::string block = std::string(999, 'x') + (with_line_ends ? '\n' : 'x');
  for (int i = 0; i < 1000 * megabytes; ++i) {
    stream << block;
  }
}

/// Commits the fault, and returns the line to write instead of `reply`.
using Fault = std::function<std::string(std::uint64_t id, std::string reply)>;

// NOLINTNEXTLINE(readability-function-size): a table
const std::map<std::string, Fault>& faults() {
  static const std::map<std::string, Fault> all{
      {"none", [](auto, auto reply) { return reply; }},
      {"signal",
       [](auto, auto) -> std::string {
         std::signal(SIGSEGV, SIG_DFL);
         std::raise(SIGSEGV);
         return {};
       }},
      {"hang", [](auto, auto) -> std::string { hang(); }},
      {"exit-in-the-middle", [](auto, auto) -> std::string { std::_Exit(0); }},
      {"out-of-order",
       [](auto id, auto reply) {
         const std::string number = std::to_string(id);
         return std::string(reply).replace(reply.find(number), number.size(), std::to_string(id + 1));
       }},
      {"twice", [](auto, auto reply) { return reply + reply; }},
      {"not-json", [](auto, auto) { return std::string("velocity = 3\n"); }},
      {"nan-as-text",
       [](auto, auto reply) {
         json outcome = json::parse(reply);
         outcome["a"]["velocity"] = {"nan", "inf", "-inf"};
         return outcome.dump() + '\n';
       }},
      {"leave-group",
       [](auto, auto) -> std::string {
         setpgid(0, getpgid(getppid()));
         hang();
       }},
      {"wide",
       [](auto id, auto) {
         std::string objects = "{}";
         for (int i = 0; i < 300'000; ++i) {
           objects += ",{}";
         }
         return "{\"id\":" + std::to_string(id) + ",\"skipped\":[" + objects + "]}\n";
       }},
      {"deep", [](auto, auto) { return std::string(500'000, '[') + '\n'; }},
      {"gigabyte",
       [](auto, auto) -> std::string {
         write_megabytes(std::cout, 1000, false);
         return "\n";
       }},
      {"flood-of-errors",
       [](auto, auto reply) {
         write_megabytes(std::cerr, 100, true);
         return reply;
       }},
      {"close-output",
       [](auto, auto) -> std::string {
         std::cout.flush();
         close(STDOUT_FILENO);
         hang();
       }},
      {"grandchild",
       [](auto, auto) -> std::string {
         if (fork() == 0) {
           hang();
         }
         hang();
       }},
  };
  return all;
}

/// The reply of a session to a request with hexadecimal numbers.
std::string hex_reply(const std::string& line, const std::string& fault, Session& session) {
  const subjects::protocol::HexRequest request = subjects::protocol::hex_request_from(line);
  std::string reply;
  subjects::protocol::add_hex_reply(reply, request.id, session(std::span(&request.collision, 1)).at(0));
  return request.id == faulty_solve && fault == "hex-wrong-id" ? '4' + reply.substr(1) : reply;
}

using Reader = std::function<ordered_json(const std::string& text)>;

ordered_json with_text(const std::string& text, const char* pattern, const char* replacement) {
  return ordered_json::parse(std::regex_replace(text, std::regex(pattern), replacement));
}

template <class Change>
Reader with_bodies(Change change) {
  return [change](const std::string& text) {
    ordered_json request = ordered_json::parse(text);
    for (const char* name : {"a", "b"}) {
      change(request.at("collision").at(name));
    }
    return request;
  };
}

void make_immovable(ordered_json& body) {
  for (const char* field : {"mass", "principal_inertia", "orientation"}) {
    body.erase(field);
  }
  body["immovable"] = true;
}

/// Readers that misread one spelling that the protocol permits.
const std::map<std::string, Reader>& readers() {
  static const std::map<std::string, Reader> all{
      {"exponent-dropped", [](const auto& text) { return with_text(text, "([0-9])e-?[0-9]+", "$1"); }},
      {"capital-exponent-dropped", [](const auto& text) { return with_text(text, R"(([0-9])E[-+][0-9]+)", "$1"); }},
      {"integer-by-ten",
       [](const auto& text) { return with_text(text, R"(([\[,:]\s*-?[0-9]+)(?=\s*[,\]}]))", "$1e-1"); }},
      {"left-out-is-immovable", with_bodies([](ordered_json& body) {
         if (!body.contains("immovable")) {
           make_immovable(body);
         }
       })},
      {"written-is-immovable", with_bodies([](ordered_json& body) {
         if (body.contains("immovable")) {
           make_immovable(body);
         }
       })},
      {"left-out-orientation", with_bodies([](ordered_json& body) {
         if (body.contains("mass") && !body.contains("orientation")) {
           body["orientation"] = {0.6, 0.8, 0.0, 0.0};
         }
       })},
      {"left-out-friction",
       [](const auto& text) {
         ordered_json request = ordered_json::parse(text);
         (void)request.at("collision").at("friction");
         return request;
       }},
      {"first-is-a",
       [](const auto& text) {
         ordered_json request = ordered_json::parse(text);
         ordered_json& collision = request.at("collision");
         if (text.find("\"b\"") < text.find("\"a\"")) {
           std::swap(collision.at("a"), collision.at("b"));
         }
         return request;
       }},
      {"no-tabs", [](const auto& text) {
         return ordered_json::parse(text.find('\t') == std::string::npos ? text : std::string());
       }}};
  return all;
}

Answer answer_to_misread(const std::string& line, const Reader& reader, Session& session) {
  try {
    const Collision collision = collision_from_json(json(reader(line).at("collision")));
    return session(std::span(&collision, 1)).at(0);
  } catch (const std::exception& error) {
    return Refused{error.what()};
  }
}

/// The reply to `start`. A fault "FIELD=VALUE" sets a field of it, and "idle=VALUE" sets `claims`.
std::string introduction_line(const subjects::protocol::Introduction& introduction, const std::string& fault) {
  json reply = json::parse(subjects::protocol::introduction_reply(introduction));
  if (const std::size_t sign = fault.find('='); sign != std::string::npos) {
    reply[fault.starts_with("idle=") ? "claims" : fault.substr(0, sign)] = json::parse(fault.substr(sign + 1));
  } else if (fault == "protocol-2") {
    reply["protocol"] = 2;
  } else if (fault == "hang-at-start") {
    hang();
  } else if (fault == "markup") {
    reply["name"] = "<script>alert(1)</script>&\"'\x1b[31m";
    std::cerr << "<img src=x onerror=alert(2)>\n";
  }
  return reply.dump();
}

int run(int argc, char** argv) {
  const std::string fault = argc > 1 ? argv[1] : "none";
  if (fault == "exit-at-once") {
    std::cerr << "nothing to do here\n";
    return 7;
  }
  // This subject ignores signals. A gate that is stopped must end it all the same.
  std::signal(SIGTERM, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  subjects::protocol::Introduction introduction{
      argc > 2 ? argv[2] : std::to_string(getpid()), "1", Precision::binary64, Law::frictionless, {}};
  if (fault.starts_with("matrix")) {
    introduction.law = Law::reflection;
    introduction.matrix = true;
  }
  Session session = subjects::subject_named(introduction.matrix ? "reflection-double" : "frictionless-double")->open();
  const auto known = faults().find(fault);
  if (fault.starts_with("hex")) {
    introduction.numbers = subjects::protocol::Numbers::hex;
  }
  for (std::string line; std::getline(std::cin, line);) {
    if (!line.starts_with('{')) {
      std::cout << hex_reply(line, fault, session) << std::flush;
      continue;
    }
    const json request = json::parse(line);
    if (request.at("cmd") == "start") {
      std::cout << introduction_line(introduction, fault) << std::endl;
    } else if (request.at("cmd") == "solve") {
      const auto id = request.at("id").get<std::uint64_t>();
      const Collision collision = collision_from_json(request.at("collision"));
      const bool is_idle = fault.starts_with("idle=") && validate(collision).empty();
      Answer answer;
      if (const auto reader = readers().find(fault); reader != readers().end()) {
        answer = answer_to_misread(line, reader->second, session);
      } else {
        answer = is_idle ? Answer(reported(unchanged(collision))) : session(std::span(&collision, 1)).at(0);
      }
      std::string reply = subjects::protocol::answer_reply(id, answer, introduction.precision);
      if (fault == "crash-where-bouncy" && collision.restitution > 0.7 && collision.restitution < 0.8) {
        std::cerr << "assertion failed: restitution <= 0.7" << std::endl;
        std::abort();
      }
      if (introduction.matrix && fault != "matrix" && reply.find("\"C\"") != std::string::npos) {
        json changed = json::parse(reply);
        if (fault == "matrix-nan") {
          changed["C"][0][0] = "nan";
        } else {
          changed.erase("C");
        }
        reply = changed.dump() + '\n';
      }
      if (fault == "markup" && id >= faulty_solve) {
        reply = json{{"id", id}, {"error", "<b onclick=alert(3)>refused</b>"}}.dump() + '\n';
      } else if (id == faulty_solve && known != faults().end()) {
        reply = known->second(id, reply);
      }
      std::cout << reply << std::flush;
    } else {
      if (fault == "hang-after-stop") {
        hang();
      } else if (fault == "line-after-stop") {
        std::cout << "goodbye" << std::endl;
      }
      return fault == "status-3" ? 3 : 0;
    }
  }
  return 0;
}

}  // namespace
}  // namespace carom

// NOLINTNEXTLINE(bugprone-exception-escape): an uncaught exception is a fault like the others
int main(int argc, char** argv) { return carom::run(argc, argv); }
