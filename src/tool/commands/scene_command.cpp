// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "chart/gnuplot.hpp"
#include "commands/commands.hpp"
#include "commands/input_file.hpp"
#include "commands/interrupt.hpp"
#include "commands/output_file.hpp"
#include "commands/progress.hpp"
#include "scene/replay_html.hpp"
#include "scene/scene_file.hpp"
#include "scene/scene_html.hpp"
#include "scene/scene_pictures.hpp"
#include "scene/scene_records.hpp"
#include "scene/scene_run.hpp"

namespace carom::tool {
namespace {

namespace fs = std::filesystem;

/// Of a replay: as many as a browser draws several times a second.
constexpr std::size_t most_bodies_replayed = 20'000;

/// A file that is written line by line while a scene runs.
class LineFile {
 public:
  explicit LineFile(fs::path path) : path_(std::move(path)), stream_(path_, std::ios::binary) { require(); }
  void write(const std::string& line) {
    stream_ << line;
    require();
  }
  void close() {
    stream_.close();
    require();
  }

 private:
  void require() const {
    if (!stream_) {
      throw UsageError(fmt::format("{}: cannot be written", path_.string()));
    }
  }

  fs::path path_;
  std::ofstream stream_;
};

std::vector<Model> laws_of(const SceneArguments& arguments, const scene::Scene& scene) {
  std::vector<Model> laws;
  for (const std::string& name : arguments.laws) {
    const std::optional<Model> law = model_named(name);
    if (!law || *law == Model::any) {
      throw UsageError(fmt::format(
          "--laws: there is no law '{}'; there are frictionless, reflection, sticking, rough, coulomb", name));
    }
    if (std::find(laws.begin(), laws.end(), *law) == laws.end()) {
      laws.push_back(*law);
    }
  }
  return laws.empty() ? std::vector{scene.law} : laws;
}

struct Written {
  SampledLaw sampled;
  nlohmann::json record;
  bool holds = false;
  bool has_failed = false;
};

Written run_one(const scene::Scene& scene, const SceneArguments& arguments, const std::stop_token& stop,
                const std::optional<fs::path>& out) {
  SceneOptions options;
  options.judge_every = arguments.judge_every;
  options.check = arguments.check;
  options.most_events = arguments.events;
  options.stop = stop;
  const bool replays = out && has_replay() && body_count(scene) <= most_bodies_replayed;
  options.most_replayed = replays ? options.most_replayed : 0;
  const auto progress = progress_line("ms of " + scene.title);
  if (progress) {
    options.on_progress = [&](double time) {
      progress(static_cast<std::uint64_t>(1000 * time), static_cast<std::uint64_t>(1000 * scene.duration));
    };
  }
  std::optional<LineFile> events;
  if (out) {
    make_directories(*out);
    events.emplace(*out / "events.csv");
    events->write(events_csv_header(scene));
    options.on_event = [&events, &scene, number = std::uint64_t{0}](const scene::Event& event) mutable {
      events->write(events_csv_line(scene, ++number, event));
    };
  }
  const auto run = [&] {
    try {
      return std::make_unique<SceneRun>(scene, options);
    } catch (const scene::SceneError& error) {
      throw UsageError(fmt::format("{}: {}", arguments.file, error.what()));
    }
  }();
  run->run();
  Written written{
      {std::string(name_of(scene.law)), run->samples()}, scene_record(*run), run->holds(), run->has_failed()};
  if (arguments.format == "text") {
    fmt::print("{}", scene_text(*run));
  }
  if (out) {
    events->close();
    write_file(*out / "series.csv", series_csv(*run));
    write_file(*out / "scene.json", written.record.dump(1) + '\n');
    const bool has_page = run->replayed().has_value();
    if (has_page) {
      write_file(*out / "replay.html", replay_html(scene.title, replay_record(*run)));
    }
    write_file(*out / "report.html", scene_html(*run, has_page));
    const std::vector laws{written.sampled};
    chart::draw(std::vector{energy_picture(laws), momentum_picture(laws), spin_picture(laws)}, *out);
  }
  return written;
}

}  // namespace

int run_scene_file(const SceneArguments& arguments) {
  const std::stop_token stop = stop_on_interrupt();
  scene::Scene scene = scene_of(content_of_file(arguments.file), arguments.file);
  const std::vector<Model> laws = laws_of(arguments, scene);
  std::optional<fs::path> out;
  if (!arguments.out.empty()) {
    out = arguments.out;
    make_directories(*out / "gnuplot");
    if (!has_replay()) {
      fmt::print(
          stderr,
          "carom: no replay.html: this program was built without three.js (`bash src/bootstrap.sh build` with npm)\n");
    }
  }
  std::vector<Written> all;
  for (const Model law : laws) {
    scene.law = law;
    std::optional<fs::path> own = out;
    if (out && laws.size() > 1) {
      own = *out / std::string(name_of(law));
      make_directories(*own / "gnuplot");
    }
    all.push_back(run_one(scene, arguments, stop, own));
  }
  if (arguments.format == "json") {
    nlohmann::json records = nlohmann::json::array();
    for (const Written& written : all) {
      records.push_back(written.record);
    }
    fmt::print("{}\n", laws.size() == 1 ? records[0].dump(1) : records.dump(1));
  }
  if (out && laws.size() > 1) {
    std::vector<SampledLaw> sampled;
    for (const Written& written : all) {
      sampled.push_back(written.sampled);
    }
    chart::draw(std::vector{energy_picture(sampled), momentum_picture(sampled), spin_picture(sampled)}, *out);
  }
  const auto any = [&](bool Written::*fact) {
    return std::any_of(all.begin(), all.end(), [&](const Written& written) { return written.*fact; });
  };
  if (any(&Written::has_failed)) {
    fmt::print(stderr, "carom: {}: {}\n", arguments.file, "the scene could not be run to its end");
    return exit_usage;
  }
  return std::all_of(all.begin(), all.end(), [](const Written& written) { return written.holds; }) ? exit_all_hold
                                                                                                   : exit_violated;
}

}  // namespace carom::tool
