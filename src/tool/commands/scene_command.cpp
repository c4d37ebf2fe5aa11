// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <optional>

#include <fmt/format.h>
#include <unistd.h>

#include <carom/collision/json/text.hpp>
#include <carom/properties/gate/by_name.hpp>

#include "commands/commands.hpp"
#include "commands/options.hpp"
#include "commands/plan.hpp"
#include "io/gnuplot.hpp"
#include "io/input_file.hpp"
#include "io/interrupt.hpp"
#include "io/output.hpp"
#include "io/threads.hpp"
#include "io/usage_error.hpp"
#include "scene/replay_html.hpp"
#include "scene/scene_records.hpp"
#include "scene/scene_run.hpp"

namespace carom::tool {
namespace {

struct SceneArguments {
  std::string file;
  std::vector<std::string> laws;        // names; empty for the scene's own
  std::string out;                      // a directory; empty for none
  std::uint64_t judge_every = 1;        // every Nth impulse is judged; 0: none
  bool check = true;                    // whether to check that nothing overlaps
  std::optional<std::uint64_t> events;  // the most events; the run ends after them
  std::uint64_t most_lines = 100'000;   // of events.csv
  unsigned jobs = 0;                    // laws that run at once; 0: one for each core
  std::string format = "text";
};

namespace fs = std::filesystem;

/// The most bodies of a replay. A browser draws so many bodies several times a second.
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
      fail_to_write(path_, errno);
    }
  }

  fs::path path_;
  std::ofstream stream_;
};

std::vector<Law> laws_of(const SceneArguments& arguments, const scene::Scene& scene) {
  const std::vector<std::string> known{"frictionless", "reflection", "sticking", "rough", "coulomb"};
  std::vector<Law> laws;
  for (const std::string& name : arguments.laws) {
    const std::optional<Law> law = law_named(name);
    if (!law || *law == Law::any) {
      throw UsageError(fmt::format("--laws: there is no law '{}'; expected one of {}{}", name, fmt::join(known, ", "),
                                   properties::did_you_mean(name, known)));
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
  std::string text;  // empty unless the format is text
  std::exception_ptr undrawn;
  SceneVerdict verdict = SceneVerdict::holds;
  bool ended_early = false;
};

/// Shows the progress of all laws together on one line of standard error, at most once a second. Their threads report
/// it. Nothing is shown if standard error is not a terminal.
class Progress {
 public:
  Progress(const scene::Scene& scene, std::size_t laws)
      : title_(shown_title(scene)), duration_(scene.duration * static_cast<double>(laws)), laws_(laws) {}
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  Progress(Progress&&) = delete;
  Progress& operator=(Progress&&) = delete;
  ~Progress() {
    if (has_shown_) {
      std::fputs("\n", stderr);
    }
  }

  [[nodiscard]] bool is_shown() const { return isatty(STDERR_FILENO) != 0; }
  void report(std::size_t law, double time, std::uint64_t events) {
    const std::scoped_lock lock(mutex_);
    laws_[law] = {time, events};
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::seconds(1)) {
      return;
    }
    last_ = now;
    has_shown_ = true;
    double sum = 0;
    for (const State& one : laws_) {
      sum += one.time;
      events += &one == &laws_[law] ? 0 : one.events;
    }
    std::fputs(fmt::format("\r{}: {:.6g} s of {:g} s, {} events", title_, sum, duration_, events).c_str(), stderr);
    std::fflush(stderr);
  }

 private:
  struct State {
    double time = 0;
    std::uint64_t events = 0;
  };

  std::string title_;
  double duration_;
  std::mutex mutex_;
  std::vector<State> laws_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  bool has_shown_ = false;
};

/// The scene under one law. The object must not move, because callbacks refer to it.
class LawRun {
 public:
  LawRun(scene::Scene scene, std::optional<fs::path> out) : scene_(std::move(scene)), out_(std::move(out)) {}

  /// Runs the scene, on any thread, and writes the events as they happen.
  void run(const SceneArguments& arguments, const std::stop_token& stop, std::size_t number, Progress& progress) {
    SceneOptions options;
    options.judge_every = arguments.judge_every;
    options.check = arguments.check;
    options.most_events = arguments.events;
    options.stop = stop;
    const bool replays = out_ && has_replay() && body_count(scene_) <= most_bodies_replayed;
    options.most_replayed = replays ? options.most_replayed : 0;
    if (progress.is_shown()) {
      options.on_progress = [&progress, number](double time, std::uint64_t events) {
        progress.report(number, time, events);
      };
    }
    if (out_) {
      make_directories(*out_);
      events_.emplace(*out_ / "events.csv");
      events_->write(events_csv_header(scene_));
      options.on_event = [this, most = arguments.most_lines](const scene::Event& event) {
        if (lines_ < most) {
          events_->write(events_csv_line(scene_, ++lines_, event));
        }
      };
    }
    try {
      run_ = std::make_unique<SceneRun>(scene_, options);
    } catch (const scene::SceneError& error) {
      throw UsageError(fmt::format("{}: {}", arguments.file, error.what()));
    }
    run_->run();
  }

  /// Writes all files except events.csv. The function starts programs, so call it for one law after the other.
  /// Precondition: run() has returned.
  [[nodiscard]] Written write(const SceneArguments& arguments) {
    Written written{{std::string(name_of(scene_.law)), run_->samples()},
                    scene_record(*run_),
                    arguments.format == "text" ? scene_text(*run_) : std::string(),
                    nullptr,
                    run_->verdict(),
                    !run_->ended_early().empty()};
    if (out_) {
      if (lines_ < run_->simulation().counts().events) {
        written.record["events"]["lines"] = lines_;
        if (!written.text.empty()) {
          // The last line is the verdict.
          written.text.insert(written.text.rfind('\n', written.text.size() - 2) + 1,
                              fmt::format("files     events.csv has the first {} events (--csv-lines)\n", lines_));
        }
      }
      events_->close();
      write_file(*out_ / "series.csv", series_csv(*run_));
      write_file(*out_ / "scene.json",
                 written.record.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n');
      const bool has_page = run_->replayed().has_value();
      if (has_page) {
        write_file(*out_ / "replay.html", replay_html(scene_.title, replay_record(*run_)));
      }
      write_file(*out_ / "report.html", scene_html(*run_, has_page));
      const std::vector laws{written.sampled};
      written.undrawn = try_to_draw(std::vector{energy_plot(laws), momentum_plot(laws), spin_plot(laws)}, *out_);
    }
    return written;
  }

 private:
  scene::Scene scene_;
  std::optional<fs::path> out_;
  std::optional<LineFile> events_;
  std::uint64_t lines_ = 0;  // of events_
  std::unique_ptr<SceneRun> run_;
};

/// Runs `jobs` laws at once, on threads. If several laws throw, rethrows the exception of the first.
void run_all(std::vector<std::unique_ptr<LawRun>>& runs, const SceneArguments& arguments, const std::stop_token& stop,
             Progress& progress) {
  std::vector<std::exception_ptr> errors(runs.size());
  threads(arguments.jobs).run(runs.size(), [&](std::size_t k) {
    try {
      runs[k]->run(arguments, stop, k, progress);
    } catch (...) {
      errors[k] = std::current_exception();
    }
  });
  for (const std::exception_ptr& error : errors) {
    if (error) {
      std::rethrow_exception(error);
    }
  }
}

/// Draws the pictures that compare the laws, and puts the files of all laws in place.
void put_in_place(StagedOutput& staged, std::vector<Written>& all) {
  if (all.size() > 1) {
    std::vector<SampledLaw> sampled;
    for (const Written& written : all) {
      sampled.push_back(written.sampled);
    }
    const std::exception_ptr undrawn =
        try_to_draw(std::vector{energy_plot(sampled), momentum_plot(sampled), spin_plot(sampled)}, staged.stage());
    all.front().undrawn = all.front().undrawn ? all.front().undrawn : undrawn;
  }
  staged.put_in_place("scene.json");
}

void print_laws(const SceneArguments& arguments, const std::vector<Written>& all) {
  if (arguments.format == "json") {
    nlohmann::json records = nlohmann::json::array();
    for (const Written& written : all) {
      records.push_back(written.record);
    }
    const nlohmann::json& record = all.size() == 1 ? records[0] : records;
    fmt::print("{}\n", record.dump(1, ' ', false, nlohmann::json::error_handler_t::replace));
  }
  for (const Written& written : all) {
    fmt::print("{}", carom::printable(written.text, written.text.size()));
  }
}

int run_scene_file(const SceneArguments& arguments) {
  const std::stop_token stop = stop_on_interrupt();
  scene::Scene scene = scene_of(content_of_file(arguments.file, stop), arguments.file);
  const std::vector<Law> laws = laws_of(arguments, scene);
  std::optional<StagedOutput> staged;
  std::optional<fs::path> out;
  if (!arguments.out.empty()) {
    out = staged.emplace(arguments.out).stage();
    if (!has_replay()) {
      fmt::print(stderr,
                 "carom: replay.html is not written, because this program was built without three.js; to get it, "
                 "install npm and run `bash src/bootstrap.sh build`\n");
    }
  }
  std::vector<std::unique_ptr<LawRun>> runs;
  for (const Law law : laws) {
    scene.law = law;
    std::optional<fs::path> own = out;
    if (out && laws.size() > 1) {
      own = *out / std::string(name_of(law));
    }
    runs.push_back(std::make_unique<LawRun>(scene, own));
  }
  Progress progress(scene, laws.size());
  run_all(runs, arguments, stop, progress);
  std::vector<Written> all;
  for (std::unique_ptr<LawRun>& run : runs) {
    all.push_back(run->write(arguments));
    run.reset();
  }
  if (staged) {
    put_in_place(*staged, all);
  }
  print_laws(arguments, all);
  for (const Written& written : all) {
    if (written.undrawn) {
      std::fflush(stdout);
      std::rethrow_exception(written.undrawn);
    }
  }
  if (std::any_of(all.begin(), all.end(), [](const Written& written) { return written.ended_early; })) {
    fmt::print(
        stderr, "carom: {}: {}\n", arguments.file,
        "the simulation stopped before the end of the scene; the line `ended early` of the report gives the reason");
  }
  int status = exit_all_hold;
  for (const Written& written : all) {
    const int own = exit_status(written.verdict);
    // One violated law matters more than one that was not run to its end.
    status = status == exit_violated || own == exit_violated ? exit_violated : std::max(status, own);
  }
  return status;
}

}  // namespace

void add_scene(CLI::App& app, Chosen& chosen) {
  const auto arguments = std::make_shared<SceneArguments>();
  CLI::App* command = app.add_subcommand(
      "scene", "Simulate a scene: certify the order of its events, judge its impulses, and account for its energy");
  command->add_option("FILE", arguments->file, "The scene file (docs/reference/schemas/scene.schema.json)")->required();
  command
      ->add_option("--laws", arguments->laws,
                   "Laws of the simulation, separated by commas (default: the law of the scene)")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--out", arguments->out, "Directory for events, time series, pictures, report and replay");
  command->add_option("--judge-every", arguments->judge_every, "Judge every Nth impulse; 0 judges none")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{1'000'000'000}))
      ->capture_default_str();
  command->add_flag("!--no-check", arguments->check, "Skip the check for overlaps");
  command->add_option("--events", arguments->events, "Largest number of events; the simulation ends after it")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1'000'000'000'000}));
  command->add_option("--csv-lines", arguments->most_lines, "Largest number of lines of events.csv")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1'000'000'000'000}))
      ->capture_default_str();
  add_jobs(*command, arguments->jobs, "Number of laws that run at the same time");
  add_format(*command, arguments->format, {"text", "json"});
  command->callback([&chosen, arguments] { chosen = [arguments] { return run_scene_file(*arguments); }; });
}

void add_plan_of_scenes(CLI::App& app, Chosen& chosen) { add_plan_with(app, chosen, plan::contacts_of_scene); }

}  // namespace carom::tool
