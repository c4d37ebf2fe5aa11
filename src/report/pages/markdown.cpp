// SPDX-License-Identifier: BSL-1.0
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include <carom/collision/json/text.hpp>
#include <carom/report/pages/pages.hpp>
#include <carom/report/pages/parts.hpp>
#include <carom/report/results/words.hpp>

namespace carom::report {
namespace {

constexpr std::size_t longest_page = 1'000'000;

/// Escapes a line, so that it contains no markup and does not end the cell of a table.
std::string escaped(const std::string& text) {
  constexpr std::string_view markup = "\\`*_|~[]#";
  std::string result;
  for (const char letter : printable_line(text, longest_line)) {
    if (letter == '<') {
      result += "&lt;";
    } else if (letter == '&') {
      result += "&amp;";
    } else {
      result += (markup.find(letter) == std::string_view::npos ? "" : "\\") + std::string(1, letter);
    }
  }
  return result;
}

std::string in_code(const std::string& text) {
  std::string code;
  for (const char letter : printable_line(text, longest_line)) {
    code += letter == '|' ? "\\|" : std::string(1, letter == '`' ? '\'' : letter);
  }
  return '`' + code + '`';
}

/// The text as a block of code. Each line is moved in, because no text can end such a block.
std::string code_block(const std::string& text) {
  std::string block = "\n";
  bool begins = true;
  for (const char letter : printable(text, std::numeric_limits<std::size_t>::max())) {
    block += begins && letter != '\n' ? "    " : "";
    block += letter;
    begins = letter == '\n';
  }
  return block + (begins ? "" : "\n");
}

std::string block_of(const Document& document) { return document.empty() ? "" : code_block(in_text(document)); }

std::string opening(const Run& run) {
  const Overall overall = overall_of(run);
  std::string text = fmt::format("## {}\n\n{}\n", escaped("Carom: " + in_words(overall)),
                                 escaped(fmt::format("{} of {} subjects that count are sound; {}, seed {}, limit {}; "
                                                     "Carom {}.",
                                                     overall.sound, overall.subjects, extent_of(run), run.options.seed,
                                                     limit_in_words(run.options.limits), version)));
  if (run.baseline) {
    text += '\n' + escaped(fmt::format("Against the baseline: {}.", baseline_verdict(*run.baseline))) + '\n';
  }
  if (run.interrupted) {
    text += "\n**The run was interrupted. These are the results so far.**\n";
  }
  return text + block_of(judge_error_part(run)) + '\n' + markdown_table(subjects_table(run, Subjects::counting));
}

std::string of_subject(const Run& run, std::size_t s, const std::string& out_directory) {
  const properties::SubjectResult& result = run.results[s];
  const std::string& why = why_not_judged(result);
  Document document;
  if (const auto never = never_judged(run, result); status_of(result) == SubjectStatus::violated && !never.empty()) {
    document.emplace_back(Paragraph{fmt::format("never judged: {}", listed(never))});
  }
  if (!result.witnesses.empty()) {
    document = with(std::move(document), finding_part(run, s, out_directory, Form::summary).content);
  }
  if (!why.empty()) {
    document.emplace_back(Paragraph{"could not be judged: " + why});
  }
  return document.empty() ? "" : fmt::format("\n### {}\n{}", in_code(result.subject.name), block_of(document));
}

}  // namespace

std::string markdown_table(const Table& table) {
  std::string text = "|";
  for (const Column& column : table.columns) {
    text += ' ' + escaped(column.name) + (column.name.empty() ? "|" : " |");
  }
  text += "\n|";
  for (const Column& column : table.columns) {
    text += column.is_number ? " ---: |" : " --- |";
  }
  text += '\n';
  for (const Row& row : table.rows) {
    text += "|";
    for (const Cell& cell : row.cells) {
      text += ' ' + (cell.is_code ? in_code(cell.text) : escaped(cell.text)) + " |";
    }
    text += '\n';
  }
  return text;
}

std::string run_markdown(const Run& run, const std::string& out_directory) {
  std::string text = opening(run);
  std::size_t left_out = 0;
  for (std::size_t s = 0; s < run.results.size(); ++s) {
    const std::string section = run.counts[s] ? of_subject(run, s, out_directory) : "";
    const bool fits = text.size() + section.size() <= longest_page;
    text += fits ? section : "";
    left_out += fits ? 0 : 1;
  }
  text += block_of(beyond_domain_part(run, Subjects::counting));
  if (left_out > 0) {
    text += fmt::format("\nThe report holds the violations of {} more subjects.\n", left_out);
  }
  return text + '\n';
}

}  // namespace carom::report
