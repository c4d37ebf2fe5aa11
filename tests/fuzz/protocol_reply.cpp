// SPDX-License-Identifier: BSL-1.0
// The first byte selects the precision. The rest is a line. The target reads the line as the reply to `start`, and as
// the reply to `solve` number 1, in JSON and in hexadecimal numbers.
#include <array>
#include <optional>
#include <string>

#include <carom/collision/json/json.hpp>
#include <carom/subjects/protocol/hex_lines.hpp>
#include <carom/subjects/protocol/messages.hpp>

#include "target.hpp"

namespace carom::fuzz {
namespace {

namespace protocol = subjects::protocol;

// The reader does not cut texts up to these lengths.
constexpr std::size_t surely_whole_name = 100;
constexpr std::size_t surely_whole_text = 2000;

bool is_whole(const protocol::Introduction& introduction) {
  bool whole = introduction.name.size() <= surely_whole_name && introduction.version.size() <= surely_whole_name;
  for (const std::string& name : introduction.deviates) {
    whole = whole && name.size() <= surely_whole_name;
  }
  return whole;
}

bool same_numbers(const ReportedOutcome& x, const ReportedOutcome& y) {
  bool same = true;
  const auto of_x = vectors(x);
  const auto of_y = vectors(y);
  for (const OutcomeVector k : all_outcome_vectors) {
    for (int i = 0; i < 3; ++i) {
      same &= same_number((*of_x[k])[i], (*of_y[k])[i]);
    }
  }
  if (x.collision_matrix && y.collision_matrix) {
    for (int i = 0; i < 9; ++i) {
      same &= same_number((*x.collision_matrix)(i / 3, i % 3), (*y.collision_matrix)(i / 3, i % 3));
    }
  }
  return same && x.collision_matrix.has_value() == y.collision_matrix.has_value();
}

template <class Told>
bool same_reason(const Told& told, const Answer& again) {
  const auto* retold = std::get_if<Told>(&again);
  return retold != nullptr && (retold->why == told.why || told.why.size() > surely_whole_text);
}

bool same_answer(const Answer& first, const Answer& again) {
  if (const auto* outcome = std::get_if<ReportedOutcome>(&first)) {
    const auto* read = std::get_if<ReportedOutcome>(&again);
    return read != nullptr && same_numbers(*outcome, *read);
  }
  const auto* skipped = std::get_if<Skipped>(&first);
  return skipped != nullptr ? same_reason(*skipped, again) : same_reason(std::get<Refused>(first), again);
}

template <class Read>
auto read_or_none(const Read& read) -> std::optional<decltype(read())> {
  try {
    return read();
  } catch (const FormatError&) {
    return std::nullopt;
  }
}

void read(Bytes bytes) {
  constexpr std::array precisions{Precision::binary32, Precision::binary64, Precision::extended};
  Input input(bytes);
  const Precision precision = precisions.at(input.byte() % precisions.size());
  const std::string_view line = input.text();
  if (const auto introduction = read_or_none([&] { return protocol::introduction_from(line); })) {
    const protocol::Introduction again = protocol::introduction_from(protocol::introduction_reply(*introduction));
    require(again == *introduction || !is_whole(*introduction), "an introduction does not survive being written");
  }
  if (const auto answer = read_or_none([&] { return protocol::answer_from(line, 1, precision, true); })) {
    const Answer again = protocol::answer_from(protocol::answer_reply(1, *answer, precision), 1, precision, true);
    require(same_answer(*answer, again), "an answer does not survive being written");
  }
  if (const auto answer = read_or_none([&] { return protocol::answer_from_hex(line, 1, true); })) {
    std::string reply;
    protocol::add_hex_reply(reply, 1, *answer);
    reply.pop_back();  // the line end
    require(same_answer(*answer, protocol::answer_from_hex(reply, 1, true)),
            "a hexadecimal answer does not survive being written");
  }
}

}  // namespace
}  // namespace carom::fuzz

CAROM_FUZZ_TARGET(protocol_reply) {
  carom::fuzz::read({data, size});
  return 0;
}
