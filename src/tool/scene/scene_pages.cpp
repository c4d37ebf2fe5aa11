// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include <carom/report/pages/document.hpp>
#include <carom/report/results/version.hpp>

#include "io/this_environment.hpp"
#include "scene/scene_records.hpp"

namespace carom::tool {
namespace {

using properties::Cause;
using report::Cell;
using report::Document;
using report::Facts;
using report::List;
using report::Paragraph;
using report::Row;
using report::Section;
using report::Table;

std::string joules(long double energy) { return fmt::format("{:.9g} J", static_cast<double>(energy)); }

Row number_row(std::string_view name, const std::string& value) { return {{std::string(name), Cell(value, "number")}}; }

Document ledger_part(const SceneRun& run) {
  const properties::Ledger& ledger = run.ledger();
  Table table{"Energy by cause", {{""}, {"", true}}, {}, "ledger"};
  table.rows.push_back(number_row("at first", joules(ledger.initial().total())));
  for (const Cause cause : properties::all_causes) {
    table.rows.push_back(number_row(name_of(cause), joules(ledger.energy(cause))));
  }
  table.rows.push_back(number_row("at last", joules(ledger.present().total())));
  table.rows.push_back(
      number_row("rounding relative to the scale of the energy",
                 fmt::format("{:.2g}, allowed {:.2g}", ledger.relative_rounding(), ledger.rounding_limit())));
  table.rows.push_back(number_row("greatest rounding relative to the bound of its event or arc",
                                  fmt::format("{:.2g}, allowed 1", ledger.worst_rounding())));
  table.rows.push_back(number_row(
      "sum of the magnitudes of all roundings",
      fmt::format("{:.2g}", static_cast<double>(ledger.rounding_without_signs() / std::max(ledger.scale(), 1e-300L)))));
  return {Paragraph{"The table shows the causes of all changes of energy. The amount of each cause comes from its "
                    "closed form. The remaining difference of the stored states is rounding."},
          std::move(table)};
}

Document impulses_part(const SceneRun& run) {
  const properties::ImpulseJudge& judge = run.judge();
  std::string text = fmt::format("{} of {} judged, {} violated.", judge.judged(), judge.impulses(), judge.violated());
  if (const auto& bad = judge.first_bad()) {
    text +=
        fmt::format(" The first at t = {} s violates {}; its collision is in scene.json.", bad->time, bad->invariant);
  }
  Document document{Paragraph{text}};
  if (!judge.times_held().empty()) {
    Table table{"Number of impulses for which each invariant holds", {{""}, {"", true}}, {}, "impulses"};
    for (const auto& [name, count] : judge.times_held()) {
      table.rows.push_back(number_row(name, std::to_string(count)));
    }
    document.emplace_back(std::move(table));
  }
  return document;
}

Document order_part(const SceneRun& run) {
  const scene::Counts& counts = run.simulation().counts();
  Facts facts{{{"events", std::to_string(counts.events)},
               {"impacts of bodies", std::to_string(counts.impacts)},
               {"impacts with planes", std::to_string(counts.plane_impacts)},
               {"captures by level planes", std::to_string(counts.captures)},
               {"changes of phase", std::to_string(counts.phases)},
               {"slow contacts", std::to_string(counts.slow)},
               {"largest number of events at one instant", std::to_string(counts.at_one_instant)},
               {"orders decided exactly", std::to_string(counts.exact.orders)},
               {"ties", std::to_string(counts.exact.ties)},
               {"contacts decided exactly", std::to_string(counts.exact.predictions)},
               {"gaps decided exactly", std::to_string(counts.exact.gaps)},
               {"gaps computed by conservative advancement", std::to_string(counts.advances)},
               {"positions moved to remove an overlap", std::to_string(counts.moved_clear)}}};
  if (const auto& validity = run.validity()) {
    facts.pairs.emplace_back("invalid states", std::to_string(validity->count));
    facts.pairs.emplace_back("pairs of paths checked",
                             fmt::format("{}, {} of them exactly", validity->pairs, validity->exact_pairs));
    facts.pairs.emplace_back("largest jump of a stored position", fmt::format("{:.2g} m", validity->largest_jump));
    facts.pairs.emplace_back("deepest overlap that the check may miss", fmt::format("{:.2g} m", validity->unseen));
  } else {
    facts.pairs.emplace_back("invalid states", "not checked");
  }
  return {std::move(facts)};
}

List files_beside(bool has_replay) {
  List list;
  for (const char* file :
       {"replay.html", "energy.svg", "momentum.svg", "spin.svg", "events.csv", "series.csv", "scene.json"}) {
    if (file != std::string_view("replay.html") || has_replay) {
      list.items.emplace_back(file);
      list.items.back().link = file;
    }
  }
  return list;
}

using report::Label;
using report::Plot;
using Quantity = std::function<double(const Sample&)>;

constexpr std::array<std::string_view, 6> colours{report::blue,   report::vermillion, report::green,
                                                  report::purple, report::orange,     report::sky_blue};

struct Line {
  std::string name;
  const std::vector<Sample>* samples;
  Quantity quantity;
};

Plot lines_over_time(const std::string& name, const std::string& title, const std::string& y_name,
                     const std::vector<Line>& lines) {
  double low = 0;
  double high = 0;
  double last = 0;
  for (const Line& line : lines) {
    for (const Sample& sample : *line.samples) {
      low = std::min(low, line.quantity(sample));
      high = std::max(high, line.quantity(sample));
      last = std::max(last, sample.time);
    }
  }
  const double margin = high > low ? 0.05 * (high - low) : 1;
  Plot picture(name, 1000, 520, 16);
  const report::Panel panel{{0, last > 0 ? last : 1, false, 110, 800},
                            {low - (low < 0 ? margin : 0), high + margin, false, 75, 470}};
  picture.begin(panel, title, "time [s]", y_name);
  std::vector<Label> names;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const std::string_view colour = colours[k % colours.size()];
    std::vector<std::vector<double>> points;
    for (const Sample& sample : *lines[k].samples) {
      points.push_back({sample.time, lines[k].quantity(sample)});
    }
    picture.curve(points, fmt::format("using 1:2 with lines lw 2 dt {} lc rgb '{}'", k % 3 + 1, colour));
    if (!points.empty()) {
      names.push_back({lines[k].name, panel.place_of(points.back()[0], points.back()[1]), std::string(colour)});
    }
  }
  picture.name_ends(names, panel);
  picture.end();
  return picture;
}

std::vector<Line> one_line_a_law(std::span<const SampledLaw> laws, const Quantity& quantity) {
  std::vector<Line> lines;
  for (const SampledLaw& law : laws) {
    lines.push_back({law.law, &law.samples, quantity});
  }
  return lines;
}

}  // namespace

std::string scene_html(const SceneRun& run, bool has_replay_beside) {
  const scene::Scene& scene = run.scene();
  const report::Environment environment = this_environment();
  Document summary{Paragraph{scene_verdict(run), fmt::format("result exit-{}", exit_status(run.verdict()))},
                   Facts{{{"law", std::string(name_of(scene.law))},
                          {"precision of impulses", std::string(name_of(scene.precision))},
                          {"spheres", std::to_string(scene.spheres.size())},
                          {"polyhedra", std::to_string(scene.polyhedra.size())},
                          {"planes", std::to_string(scene.planes.size())},
                          {"simulated", fmt::format("{:g} s of {:g} s", run.simulation().time(), scene.duration)},
                          {"ended early", run.ended_early()},
                          {"bodies whose spin changed", std::to_string(run.spins_changed())}}},
                   files_beside(has_replay_beside)};
  Facts made{{{"Carom", report::version},
              {"date", environment.date},
              {"compiler", environment.compiler},
              {"processor", environment.processor}}};
  return report::html_page(
      {"Carom: " + scene.title,
       scene.title,
       {},
       {Section{"Summary", std::move(summary), "summary"}, Section{"Ledger", ledger_part(run), "ledger"},
        Section{"Impulses", impulses_part(run), "impulses"},
        Section{"Events and their order", order_part(run), "order"},
        Section{"Environment", {std::move(made)}, "environment"}}});
}

Plot energy_plot(std::span<const SampledLaw> laws) {
  if (laws.size() == 1) {
    const std::vector<Sample>& samples = laws.front().samples;
    const double first = samples.empty() ? 0 : samples.front().total();
    return lines_over_time("energy", "Energy and losses", "energy [J]",
                           {{"translation", &samples, [](const Sample& s) { return s.translation; }},
                            {"rotation", &samples, [](const Sample& s) { return s.rotation; }},
                            {"potential", &samples, [](const Sample& s) { return s.potential; }},
                            {"lost", &samples, [first](const Sample& s) { return first - s.total(); }}});
  }
  return lines_over_time("energy", "Mechanical energy under each law", "energy [J]",
                         one_line_a_law(laws, [](const Sample& s) { return s.total(); }));
}

Plot momentum_plot(std::span<const SampledLaw> laws) {
  if (laws.size() == 1) {
    const std::vector<Sample>& samples = laws.front().samples;
    return lines_over_time("momentum", "Momentum", "momentum [N s]",
                           {{"x", &samples, [](const Sample& s) { return s.momentum[0]; }},
                            {"y", &samples, [](const Sample& s) { return s.momentum[1]; }},
                            {"z", &samples, [](const Sample& s) { return s.momentum[2]; }}});
  }
  return lines_over_time("momentum", "Size of the momentum under each law", "momentum [N s]",
                         one_line_a_law(laws, [](const Sample& s) { return s.momentum.norm(); }));
}

Plot spin_plot(std::span<const SampledLaw> laws) {
  return lines_over_time("spin", "Mean of ‖w‖ over the spheres", "‖w‖ [rad/s]",
                         one_line_a_law(laws, [](const Sample& s) { return s.mean_spin; }));
}

}  // namespace carom::tool
