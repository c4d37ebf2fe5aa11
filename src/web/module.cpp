// SPDX-License-Identifier: BSL-1.0
#include <exception>
#include <string>

#include <emscripten/emscripten.h>
#include <nlohmann/json.hpp>

#include <carom/collision/json/json.hpp>
#include <carom/properties/gate/in_words.hpp>
#include <carom/web/commands.hpp>

/// Answers one request. Both are JSON texts. The answer is valid until the next call. An error is {"error": "…"}.
extern "C" EMSCRIPTEN_KEEPALIVE const char* carom_call(const char* request) {
  static std::string answer;
  nlohmann::json record;
  try {
    record = carom::web::answer_to(carom::parse_json(request));
  } catch (const carom::oracles::JudgeError& error) {
    record = {{"error", carom::properties::in_words(error)}};
  } catch (const std::exception& error) {
    record = {{"error", error.what()}};
  }
  answer = record.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return answer.c_str();
}
