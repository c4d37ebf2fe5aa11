// SPDX-License-Identifier: BSL-1.0
// A sound subject, except that it misreads one spelling that the protocol permits. The first argument selects the
// spelling.
#include <functional>
#include <iostream>
#include <map>
#include <regex>
#include <string>

#include <nlohmann/json.hpp>

#include <carom/collision/json/json.hpp>
#include <carom/subjects/catalogue.hpp>
#include <carom/subjects/protocol/messages.hpp>

namespace carom {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

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

const std::map<std::string, Reader>& readers() {
  static const std::map<std::string, Reader> all{
      {"none", [](const auto& text) { return ordered_json::parse(text); }},
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

int run(int argc, char** argv) {
  const Reader& reader = readers().at(argc > 1 ? argv[1] : "none");
  Session session = subjects::subject_named("frictionless-double")->open();
  for (std::string line; std::getline(std::cin, line);) {
    const json request = json::parse(line);
    if (request.at("cmd") == "stop") {
      break;
    }
    if (request.at("cmd") == "start") {
      std::cout << subjects::protocol::introduction_reply(
                       {"misreading", "1", Precision::binary64, Law::frictionless, {}})
                << std::flush;
      continue;
    }
    const auto id = request.at("id").get<std::uint64_t>();
    Answer answer;
    try {
      const Collision collision = collision_from_json(json(reader(line).at("collision")));
      answer = session(std::span(&collision, 1)).at(0);
    } catch (const std::exception& error) {
      answer = Refused{error.what()};
    }
    std::cout << subjects::protocol::answer_reply(id, answer, Precision::binary64) << std::flush;
  }
  return 0;
}

}  // namespace
}  // namespace carom

int main(int argc, char** argv) {
  try {
    return carom::run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
