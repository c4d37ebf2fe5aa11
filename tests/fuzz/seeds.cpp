// SPDX-License-Identifier: BSL-1.0
// seeds DIRECTORY CORPUS…: writes inputs as DIRECTORY/TARGET/NAME. For each target, it makes a few from the families. A
// file TARGET.txt of corpora has one input a line, in which %41 is the byte 0x41.
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <carom/collision/json/json.hpp>
#include <carom/properties/gate/answers.hpp>
#include <carom/subjects/catalogue.hpp>
#include <carom/subjects/protocol/hex_lines.hpp>
#include <carom/subjects/protocol/messages.hpp>

#include "case_bytes.hpp"

namespace carom::fuzz {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
namespace protocol = subjects::protocol;

void write(const fs::path& directory, std::string_view target, const std::string& name, std::string_view bytes) {
  fs::create_directories(directory / target);
  std::ofstream stream(directory / target / name, std::ios::binary);
  stream.exceptions(std::ios::failbit | std::ios::badbit);
  stream << bytes;
}

std::string with_head(std::initializer_list<std::size_t> head, const std::vector<std::uint8_t>& bytes) {
  std::string text;
  for (const std::size_t number : head) {
    text += static_cast<char>(static_cast<std::uint8_t>(number));
  }
  return text + std::string(bytes.begin(), bytes.end());
}

/// Writes the case in both forms. Each byte before the case is `number` in the drawn form, and `number + 1` in the
/// plain form.
void write_cases(const fs::path& directory, std::size_t number, std::string_view family,
                 const std::vector<std::uint8_t>& drawn, const Collision& collision) {
  const std::string name(family);
  const std::vector<std::uint8_t> as_it_stands = bytes_of(collision);
  for (const char* law : {"law_frictionless", "law_reflection", "law_sticking", "law_rough", "law_coulomb"}) {
    write(directory, law, name + "-drawn", with_head({number}, drawn));
    write(directory, law, name, with_head({number + 1}, as_it_stands));
  }
  write(directory, "judge", name + "-drawn", with_head({number, number}, drawn));
  write(directory, "judge", name, with_head({number + 1, number + 1}, as_it_stands));
}

void write_texts(const fs::path& directory, std::uint8_t number, const std::string& family, const Collision& collision,
                 Session& session) {
  const json record = collision_to_json(collision);
  write(directory, "json_collision", family, record.dump());
  const json witness{{"carom", "0.1.0"},
                     {"subject", {{"name", "reflection-double"}}},
                     {"invariant", family == "invalid" ? "invalid_refused" : "backward_error"},
                     {"family", family},
                     {"convex_uniform", false},
                     {"collision", record}};
  const std::string as_line = witness.dump() + '\n';
  write(directory, "json_witness", family, number % 3 == 0 ? as_line + as_line : witness.dump(2));
  std::string hex_request;
  protocol::add_hex_request(hex_request, number, collision);
  for (const auto& [name, request] :
       {std::pair(family, protocol::solve_request(number, collision)), std::pair(family + "-hex", hex_request)}) {
    write(directory, "protocol_request", name, protocol::start_request() + request + protocol::stop_request());
  }
  const Answer answer = properties::answers_of(session, std::span(&collision, 1)).front();
  for (const Precision precision : {Precision::binary64, Precision::extended}) {
    const char chosen = precision == Precision::binary64 ? '\1' : '\2';
    write(directory, "protocol_reply", family + '-' + std::string(name_of(precision)),
          chosen + protocol::answer_reply(1, answer, precision));
  }
  std::string hex_reply = "\1";
  protocol::add_hex_reply(hex_reply, 1, answer);
  write(directory, "protocol_reply", family + "-hex", hex_reply.substr(0, hex_reply.size() - 1));
}

void write_all(const fs::path& directory) {
  const Subject solver = subjects::subject_named("reflection-double").value();
  Session session = solver.open();
  const auto families = properties::all_families();
  for (std::size_t i = 0; i < families.size(); ++i) {
    const Collision collision = properties::drawn_case(families[i], 1, 0).collision;
    write_cases(directory, i, families[i].name, bytes_of_family(i, 0), collision);
    write_texts(directory, static_cast<std::uint8_t>(i), std::string(families[i].name), collision, session);
  }
  const auto beyond = properties::families_beyond_domain();
  for (std::size_t i = 0; i < beyond.size(); ++i) {
    write_cases(directory, i, beyond[i].name, bytes_beyond_domain(i, 0),
                properties::drawn_case(beyond[i], 1, 0).collision);
  }
  write(directory, "protocol_reply", "introduction",
        '\1' + protocol::introduction_reply({"name", "1.0", Precision::binary64, Law::reflection, {"energy", "swap"}}));
  write(directory, "json_witness", "array", json::array({json::parse("{}"), json::parse("[]")}).dump());
  write(directory, "printed_text", "text", "\x40one\ttwo\n\x1b[31mthree\u202e four \u00e4\u2026\xff");
  write(directory, "printed_text", "words", "\x40program --name 'one two' \"three \\\" $four\" five\\ six");
}

void unpack(const fs::path& corpus, const fs::path& directory) {
  std::ifstream lines(corpus);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    std::string bytes;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line[i] == '%') {
        bytes += static_cast<char>(std::stoi(line.substr(i + 1, 2), nullptr, 16));
        i += 2;
      } else {
        bytes += line[i];
      }
    }
    write(directory, corpus.stem().string(), "corpus-" + std::to_string(++number), bytes);
  }
  if (number == 0) {
    throw std::runtime_error(corpus.string() + " has no input");
  }
}

}  // namespace
}  // namespace carom::fuzz

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: seeds DIRECTORY CORPUS…\n";
    return 2;
  }
  try {
    carom::fuzz::write_all(argv[1]);
    for (int i = 2; i < argc; ++i) {
      carom::fuzz::unpack(argv[i], argv[1]);
    }
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "seeds: " << error.what() << '\n';
    return 1;
  }
}
