// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pugixml.hpp>

#include <carom/report/pages/document.hpp>
#include <carom/report/pages/parts.hpp>
#include <carom/report/pages/time_pages.hpp>
#include <carom/report/pictures/markup.hpp>
#include <carom/report/pictures/time_pictures.hpp>

namespace carom::report {
namespace {

using properties::MeasuredReading;
using properties::Measurement;
using properties::Phenomenon;
using properties::Rung;

/// "1/60 s", or "0.0123 s" if the step is no simple fraction.
std::string step_in_words(double step) {
  const double inverse = 1 / step;
  return std::abs(inverse - std::round(inverse)) <= 1e-9 * inverse  // a few roundings of the division
             ? fmt::format("1/{:.0f} s", inverse)
             : fmt::format("{:g} s", step);
}

/// Two digits: "0", "3.1 %", "140 %", "5e+04 %". An error that rounding explains is 0.
std::string percent(double error, double rounding) {
  if (error <= rounding) {
    return "0";
  }
  const double shown = std::stod(fmt::format("{:.2g}", 100 * error));
  return fmt::format("{:.{}g} %", shown, shown < 1e4 ? 4 : 2);
}

/// The error of a phenomenon at one step, as a cell: the greatest median over the readings.
std::string error_cell(const TimedEngine& engine, std::string_view phenomenon, double step) {
  const Measurement* const measurement = measurement_of(engine, phenomenon);
  const MeasuredReading* const worst = measurement == nullptr ? nullptr : worst_reading(*measurement, step);
  if (worst == nullptr) {
    return no_number;
  }
  const Rung& rung = *rung_at(*worst, step);
  return percent(rung.median, rung.rounding);
}

Table summary_table(const TimeRun& run, double step) {
  Table table{"The greatest median error of each phenomenon", {{"engine"}}, {}};
  for (const Phenomenon& phenomenon : properties::all_phenomena()) {
    if (std::any_of(run.engines.begin(), run.engines.end(),
                    [&](const TimedEngine& one) { return measurement_of(one, phenomenon.name) != nullptr; })) {
      table.columns.push_back({std::string(phenomenon.name), true});
    }
  }
  for (const TimedEngine& engine : run.engines) {
    if (engine.absent.empty()) {
      Row& row = table.rows.emplace_back(Row{{name_cell(engine.name)}});
      std::for_each(table.columns.begin() + 1, table.columns.end(), [&](const Column& column) {
        row.cells.emplace_back(error_cell(engine, column.name, step), "number");
      });
    }
  }
  return table;
}

/// "height of bounce 1, ε = 0.5: 12 % too much, 3.4 steps' worth; at 1/3840 s 0.2 %, order 1.0".
std::string reading_in_words(const MeasuredReading& reading, double step) {
  const Rung& rung = *rung_at(reading, step);
  const bool is_one_sided = rung.shift != 0 && std::abs(rung.shift) > 0.9 * rung.median;
  std::string text = fmt::format("{}: {} {}", reading.what, percent(rung.median, rung.rounding),
                                 !is_one_sided    ? "off"
                                 : rung.shift > 0 ? "too much"
                                                  : "too little");
  if (rung.median_in_worths > 0) {
    text += fmt::format(", {:.2g} steps' worth", rung.median_in_worths);
  }
  const Rung& finest = reading.rungs.back();
  if (finest.step != step) {
    text += fmt::format("; at {} {}", step_in_words(finest.step), percent(finest.median, finest.rounding));
  }
  return text + (reading.order ? fmt::format(", order {:.1f}", *reading.order) : "");
}

/// Why runs of a phenomenon, or of all, have no answer: each reason once, with its engines.
List unanswered_list(const TimeRun& run, std::string_view phenomenon = {}) {
  std::map<std::string, std::vector<std::string>> engines;  // of a reason
  for (const TimedEngine& engine : run.engines) {
    for (const Measurement& measurement : engine.measurements) {
      for (const properties::Unanswered& one : measurement.unanswered) {
        if (phenomenon.empty() || phenomenon == measurement.phenomenon) {
          engines[fmt::format("{}, {} of {} runs {}: {}", measurement.phenomenon, one.steps.size(), measurement.runs,
                              one.is_failure ? "failed" : "not posed", one.why)]
              .push_back(engine.name);
        }
      }
    }
  }
  List list;
  for (const auto& [reason, names] : engines) {
    list.items.emplace_back(fmt::format("{} ({})", reason, fmt::join(names, ", ")));
  }
  return list;
}

/// Nothing if the list is empty.
Document titled(const std::string& title, List list) {
  return list.items.empty() ? Document{} : Document{Paragraph{title}, std::move(list)};
}

/// The reading of an engine that is farthest off in each phenomenon, its relations and its claims.
Document engine_part(const TimedEngine& engine, double step) {
  List farthest;
  for (const Measurement& measurement : engine.measurements) {
    if (const MeasuredReading* const worst = worst_reading(measurement, step)) {
      const Rung& rung = *rung_at(*worst, step);
      if (rung.median > rung.rounding) {
        farthest.items.emplace_back(measurement.phenomenon + ": " + reading_in_words(*worst, step));
      }
    }
  }
  List relations;
  for (const properties::RelationResult& one : engine.relations) {
    relations.items.emplace_back(fmt::format("{}: {}", one.change, properties::in_words(one)));
  }
  List claims;
  for (const JudgedClaim& one : engine.claims) {
    claims.items.emplace_back(fmt::format("claims {}: {}{}", one.claim,
                                          !one.is_judged        ? "not judged: "
                                          : one.verdict.is_kept ? "kept"
                                                                : "NOT KEPT: ",
                                          one.verdict.why));
  }
  Document document = titled(fmt::format("Farthest off at {}:", step_in_words(step)), std::move(farthest));
  document = with(std::move(document), titled("Twenty bodies fall into a heap, twice:", std::move(relations)));
  return with(std::move(document), titled("Claims:", std::move(claims)));
}

Document absent_part(const TimeRun& run) {
  List list;
  for (const TimedEngine& engine : run.engines) {
    if (!engine.absent.empty()) {
      list.items.emplace_back(engine.name + ": " + engine.absent);
    }
  }
  return list.items.empty() ? Document{} : Document{Section{"Absent", {std::move(list)}}};
}

std::string caption(double step) {
  return fmt::format("Median error at {}, of the reading that is farthest off. 0: rounding explains it. {}: see below.",
                     step_in_words(step), no_number);
}

/// The table of all phenomena, and why it lacks numbers. Nothing if no phenomenon was measured.
Document summary_part(const TimeRun& run) {
  const double step = compared_step(run.ladder);
  Table table = summary_table(run, step);
  return table.columns.size() == 1
             ? Document{}
             : with({Paragraph{caption(step)}, std::move(table)}, titled("Not answered:", unanswered_list(run)));
}

Document opening_part(const TimeRun& run) {
  std::vector<std::string> steps(run.ladder.steps.size());
  std::transform(run.ladder.steps.begin(), run.ladder.steps.end(), steps.begin(), step_in_words);
  Document document{Paragraph{fmt::format("Carom {}: engines in time, steps {}; {} phases of an impact within a step",
                                          version, fmt::join(steps, ", "), run.ladder.phases)}};
  if (run.interrupted) {
    document.emplace_back(Section{"", {Paragraph{"INTERRUPTED: these are the results so far"}}});
  }
  return document;
}

Document first_part(const TimeRun& run) {
  Document document = opening_part(run);
  if (Document summary = summary_part(run); !summary.empty()) {
    document.emplace_back(Section{"", std::move(summary)});
  }
  return document;
}

/// Why columns of `phenomenon_table` lack numbers.
constexpr const char* missing_numbers =
    "– as an order: fewer than three errors are above rounding. – as steps' worth: no step's worth explains the error.";

/// The errors of one phenomenon: a row for each engine, a column for each step.
Table phenomenon_table(const Phenomenon& phenomenon, const TimeRun& run) {
  Table table{std::string(phenomenon.name), {{"engine"}}, {}};
  for (const double step : run.ladder.steps) {
    table.columns.push_back({step_in_words(step), true});
  }
  const double compared = compared_step(run.ladder);
  table.columns.push_back({"order", true});
  table.columns.push_back({"steps' worth at " + step_in_words(compared), true});
  table.columns.push_back({"farthest off at " + step_in_words(compared)});
  for (const TimedEngine& engine : run.engines) {
    const Measurement* const measurement = measurement_of(engine, phenomenon.name);
    if (measurement == nullptr) {
      continue;
    }
    Row row{{name_cell(engine.name)}};
    for (const double step : run.ladder.steps) {
      row.cells.emplace_back(error_cell(engine, phenomenon.name, step), "number");
    }
    const MeasuredReading* const worst = worst_reading(*measurement, compared);
    const double worths = worst == nullptr ? 0 : rung_at(*worst, compared)->median_in_worths;
    row.cells.emplace_back(worst != nullptr && worst->order ? fmt::format("{:.1f}", *worst->order) : no_number,
                           "number");
    row.cells.emplace_back(worths > 0 ? fmt::format("{:.2g}", worths) : no_number, "number");
    row.cells.emplace_back(worst != nullptr ? worst->what : no_number, "word");
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// The median errors of one phenomenon at the compared step: a row for each reading, a column for each engine.
Table readings_table(const Phenomenon& phenomenon, const TimeRun& run) {
  const double step = compared_step(run.ladder);
  Table table{"Each reading at " + step_in_words(step), {{"reading"}}, {}};
  for (const TimedEngine& engine : run.engines) {
    const Measurement* const measurement = measurement_of(engine, phenomenon.name);
    if (measurement == nullptr || measurement->readings.empty()) {
      continue;
    }
    for (const MeasuredReading& reading : measurement->readings) {
      const auto place = std::find_if(table.rows.begin(), table.rows.end(),
                                      [&](const Row& row) { return row.cells[0].text == reading.what; });
      Row& row = place != table.rows.end() ? *place : table.rows.emplace_back(Row{{Cell(reading.what)}});
      const Rung* const rung = rung_at(reading, step);
      row.cells.resize(table.columns.size(), Cell(no_number, "number"));
      row.cells.emplace_back(rung == nullptr ? no_number : percent(rung->median, rung->rounding), "number");
    }
    table.columns.push_back({engine.name, true});
  }
  for (Row& row : table.rows) {
    row.cells.resize(table.columns.size(), Cell(no_number, "number"));
  }
  return table;
}

Facts facts_of(const Phenomenon& phenomenon) {
  return {{{"set-up", std::string(phenomenon.set_up)},
           {"known answer", std::string(phenomenon.answer)},
           {"measured", std::string(phenomenon.measured)},
           {"yardstick", std::string(phenomenon.yardstick)}}};
}

Block picture_block(const std::string& file, const std::string& text) {
  return Picture{[file, text](pugi::xml_node parent) {
    add(parent, "img", {{"src", file + ".svg"}, {"alt", text}, {"style", "max-width: 100%"}});
  }};
}

}  // namespace

std::string time_summary(const TimeRun& run) { return in_text(first_part(run)); }

std::string time_text(const TimeRun& run) {
  const double step = compared_step(run.ladder);
  Document document = first_part(run);
  for (const TimedEngine& engine : run.engines) {
    if (Document part = engine_part(engine, step); !part.empty()) {
      document.emplace_back(
          Section{engine.name + (engine.version.empty() ? "" : ' ' + engine.version), std::move(part)});
    }
  }
  return in_text(with(std::move(document), absent_part(run)));
}

std::string time_html(const TimeRun& run) {
  const double step = compared_step(run.ladder);
  Page page{"Carom: engines in time", "Carom: engines in time against known answers", {}, {}, {}};
  page.main = opening_part(run);
  const auto add_part = [&](const std::string& anchor, const std::string& heading, Document content) {
    page.contents.emplace_back(anchor, heading);
    page.main.emplace_back(Section{heading, std::move(content), anchor});
  };
  Document summary = summary_part(run);
  for (const Plot& picture : first_bounce_picture(run)) {
    summary.emplace_back(picture_block(picture.name(), "The first bounce of each engine"));
  }
  if (!summary.empty()) {
    add_part("summary", "All phenomena", std::move(summary));
  }
  for (const Phenomenon& phenomenon : properties::all_phenomena()) {
    const std::string name(phenomenon.name);
    Table table = phenomenon_table(phenomenon, run);
    if (table.rows.empty()) {
      continue;
    }
    Document content{Paragraph{std::string(phenomenon.question)}, facts_of(phenomenon)};
    for (const Plot& picture : time_pictures(phenomenon, run)) {
      content.emplace_back(picture_block(picture.name(), name + ": error against step, or against time"));
    }
    content.emplace_back(std::move(table));
    content.emplace_back(Paragraph{missing_numbers});
    content = with(std::move(content), titled("Not answered:", unanswered_list(run, name)));
    add_part(name, fmt::format("{} v{}", name, phenomenon.version), std::move(content));
  }
  for (const TimedEngine& engine : run.engines) {
    if (Document part = engine_part(engine, step); !part.empty()) {
      // Two programs may give themselves one name.
      add_part(fmt::format("engine-{}", page.contents.size()), engine.name + ' ' + engine.version, std::move(part));
    }
  }
  page.main = with(std::move(page.main), absent_part(run));
  return html_page(page);
}

std::string time_junit(const TimeRun& run) {
  pugi::xml_document xml;
  const pugi::xml_node root = add(xml, "testsuites", {{"name", "carom time"}});
  double seconds = 0;
  for (const TimedEngine& engine : run.engines) {
    const pugi::xml_node suite = add(root, "testsuite", {{"name", engine.name}});
    const auto add_test = [&](const std::string& name) {
      return add(suite, "testcase", {{"classname", engine.name}, {"name", name}, {"time", "0"}});
    };
    if (!engine.absent.empty()) {
      add(add_test("start"), run.are_named ? "error" : "skipped", {{"message", engine.absent}});
    }
    for (const Measurement& measurement : engine.measurements) {
      const pugi::xml_node test = add_test(measurement.phenomenon);
      const auto failure = std::find_if(measurement.unanswered.begin(), measurement.unanswered.end(),
                                        [](const properties::Unanswered& one) { return one.is_failure; });
      if (failure != measurement.unanswered.end()) {
        add(test, "error", {{"message", failure->why}});
      } else if (measurement.readings.empty()) {
        add(test, "skipped", {{"message", "not posed"}});
      }
    }
    for (const JudgedClaim& one : engine.claims) {
      const pugi::xml_node test = add_test("claim: " + one.claim);
      if (!one.is_judged) {
        add(test, "skipped", {{"message", one.verdict.why}});
      } else if (!one.verdict.is_kept) {
        add(test, "failure", {{"message", one.verdict.why}, {"type", "violated"}});
      }
    }
    set_totals(suite, engine.seconds);
    seconds += engine.seconds;
  }
  set_totals(root, seconds);
  std::ostringstream text;
  xml.save(text, " ");
  return text.str();
}

std::string phenomenon_page(const Phenomenon& phenomenon, const TimeRun& run) {
  std::string page = fmt::format("# {} v{}\n\n{}\n", phenomenon.name, phenomenon.version, phenomenon.question);
  for (const auto& [name, value] : facts_of(phenomenon).pairs) {
    page += fmt::format("\n**{}.** {}\n", name, value.text);
  }
  for (const Plot& picture : time_pictures(phenomenon, run)) {
    page +=
        fmt::format("\n![{}: the errors of the engines](../../charts/time/{}.svg)\n", phenomenon.name, picture.name());
  }
  Table unanswered{"", {{"not answered"}}, {}};
  for (const Cell& item : unanswered_list(run, phenomenon.name).items) {
    unanswered.rows.push_back({{item}});
  }
  const double step = compared_step(run.ladder);
  return page +
         fmt::format(
             "\n{}\n\n{}\n{}\n\n{}The median error of each reading at {}. –: not answered, left out at this step, or a "
             "reading of planar engines or of the others alone.\n\n{}\n`carom time` wrote this page on {}, on {}.\n",
             caption(step), markdown_table(phenomenon_table(phenomenon, run)), missing_numbers,
             unanswered.rows.empty() ? "" : markdown_table(unanswered) + '\n', step_in_words(step),
             markdown_table(readings_table(phenomenon, run)), run.environment.date.substr(0, 10),
             run.environment.processor);
}

}  // namespace carom::report
