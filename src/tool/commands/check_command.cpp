// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <carom/collision/json/json.hpp>
#include <carom/collision/validate.hpp>
#include <carom/properties/records/tally.hpp>
#include <carom/report/pages/records_pages.hpp>
#include <carom/report/results/words.hpp>

#include "commands/commands.hpp"
#include "commands/options.hpp"
#include "io/interrupt.hpp"
#include "io/output.hpp"
#include "io/record_file.hpp"
#include "io/threads.hpp"
#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

using properties::records::JudgedRecord;
using properties::records::RecordsReport;
using properties::records::RecordTally;
using properties::records::Resolution;

struct CheckArguments {
  std::string file;
  std::string law;  // empty: every law
  std::optional<int> digits;
  unsigned jobs = 0;
  std::string out;
  std::string format = "text";
};

/// The digits are read off so many first records.
constexpr std::size_t records_for_digits = 1000;
constexpr std::size_t records_of_batch = 4096;
constexpr std::size_t records_of_work = 64;
constexpr std::size_t text_of_batch = std::size_t{32} << 20;  // after which a batch ends [bytes]

struct JudgedText {
  Record record;
  JudgedRecord judged;
  std::string error;  // why there is no record; empty if there is one
};

using Texts = std::vector<RecordFile::Text>;

/// Reads and judges records until the file ends, an error occurs, or a stop is requested.
class Check {
 public:
  Check(const CheckArguments& arguments, RecordFile& file, std::stop_token stop)
      : arguments_(arguments), file_(file), stop_(std::move(stop)), workers_(threads(arguments.jobs)) {
    std::error_code unknown;
    size_ = std::filesystem::file_size(arguments.file, unknown);
    progress_ = unknown || size_ == 0 ? nullptr : progress_line("bytes read");
  }

  [[nodiscard]] RecordsReport run() {
    Texts batch = read(records_for_digits);
    RecordsReport head;
    head.file = arguments_.file;
    head.has_law = !arguments_.law.empty();
    head.law = head.has_law ? *law_named(arguments_.law) : Law::any;
    head.resolution = resolution_of(batch);
    RecordTally tally(head);
    while (!batch.empty()) {
      judge(batch, head, tally);
      if (!error_.empty() || stop_.stop_requested()) {
        break;
      }
      batch = read(records_of_batch);
    }
    RecordsReport report = tally.report();
    report.error = error_.empty() ? unread_ : error_;
    report.interrupted = stop_.stop_requested();
    return report;
  }

 private:
  /// Up to `most` records. Empty at the end of the file, or if it cannot be read.
  [[nodiscard]] Texts read(std::size_t most) {
    Texts batch;
    const std::uint64_t end = read_ + text_of_batch;
    try {
      while (batch.size() < most && read_ < end && unread_.empty()) {
        std::optional<RecordFile::Text> text = file_.next();
        if (!text) {
          break;
        }
        read_ += text->text.size() + 1;
        batch.push_back(*std::move(text));
      }
    } catch (const UsageError& error) {
      unread_ = error.what();
    }
    if (progress_) {
      progress_(std::min(read_, size_), size_);
    }
    return batch;
  }

  /// Leaves out records that are no JSON, which `judge` reports.
  [[nodiscard]] Resolution resolution_of(const Texts& batch) const {
    properties::records::DigitsReader reader;
    for (const RecordFile::Text& text : batch) {
      try {
        reader.add(file_.parsed(text, true));
      } catch (const FormatError&) {
        break;
      }
    }
    return reader.resolution(arguments_.digits);
  }

  [[nodiscard]] JudgedText judged(const RecordFile::Text& text, const RecordsReport& head) const {
    JudgedText one;
    try {
      one.record = record_from_json(file_.parsed(text, false));
      const std::vector<InputError> errors = validate(one.record.collision);
      one.error = errors.empty() ? "" : describe(errors);
    } catch (const FormatError& error) {
      one.error = error.what();
    }
    if (one.error.empty()) {
      one.judged = properties::records::judged(one.record, head.resolution, head.law, !head.has_law);
    }
    return one;
  }

  void judge(const Texts& batch, const RecordsReport& head, RecordTally& tally) {
    std::vector<JudgedText> results(batch.size());
    const std::size_t parts = (batch.size() + records_of_work - 1) / records_of_work;
    workers_.run(parts, [&](std::size_t part) {
      const std::size_t end = std::min(batch.size(), (part + 1) * records_of_work);
      for (std::size_t i = part * records_of_work; i < end && !stop_.stop_requested(); ++i) {
        results[i] = judged(batch[i], head);
      }
    });
    if (stop_.stop_requested()) {
      return;  // the batch may be judged in part
    }
    for (std::size_t i = 0; i < batch.size(); ++i) {
      if (!results[i].error.empty()) {
        error_ = report::shown(fmt::format("{}: {}", batch[i].place, results[i].error));
        return;
      }
      tally.add(batch[i].place, std::move(results[i].record), std::move(results[i].judged));
    }
  }

  const CheckArguments& arguments_;
  RecordFile& file_;
  std::stop_token stop_;
  properties::Workers workers_;
  std::function<void(std::uint64_t, std::uint64_t)> progress_;
  std::uint64_t size_ = 0;  // of the file [bytes]
  std::uint64_t read_ = 0;
  std::string error_;   // of a record
  std::string unread_;  // why the file cannot be read on
};

std::string in_json(const RecordsReport& found) {
  return report::records_record(found).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

std::string in_format(const RecordsReport& found, const std::string& format) {
  if (format == "json") {
    return in_json(found);
  }
  return format == "junit" ? report::records_junit(found) : report::records_text(found);
}

int check(const CheckArguments& arguments) {
  const std::stop_token stop = stop_on_interrupt();
  RecordFile file(arguments.file, stop);
  std::optional<StagedOutput> staged;
  if (!arguments.out.empty()) {
    staged.emplace(arguments.out);
  }
  const RecordsReport found = Check(arguments, file, stop).run();
  fmt::print("{}", in_format(found, arguments.format));
  flush_output();
  if (staged) {
    write_file(staged->stage() / "junit.xml", report::records_junit(found));
    write_file(staged->stage() / "report.html", report::records_html(found));
    write_file(staged->stage() / "report.json", in_json(found));
    staged->put_in_place("report.json");
  }
  if (!found.error.empty()) {
    throw UsageError(found.error);
  }
  return report::exit_status_of(found);
}

}  // namespace

void add_check(CLI::App& app, Chosen& chosen) {
  const auto arguments = std::make_shared<CheckArguments>();
  CLI::App* command = app.add_subcommand("check",
                                         "Judge recorded collisions: velocities before and after; exit status 0 all "
                                         "records hold, 1 a record is violated, 2 "
                                         "the file cannot be read, or more than a tenth is not judged");
  command
      ->add_option("FILE", arguments->file,
                   "Records as JSON Lines, an array or one object; or as CSV, in a file whose name ends with .csv")
      ->required();
  std::vector<std::string> laws;
  for (const Law law : all_laws) {
    laws.emplace_back(name_of(law));
  }
  command
      ->add_option("--law", arguments->law,
                   "The law of the records (default: what holds for every law; a table shows the laws that they "
                   "satisfy)")
      ->check(CLI::IsMember(laws));
  constexpr int most_digits = 17;
  command
      ->add_option("--digits", arguments->digits,
                   "The numbers are right to N significant digits of their vector (default: to half a unit of the "
                   "last digit that is written)")
      ->check(CLI::Range(1, most_digits));
  command->add_option("--out", arguments->out, "Directory for report.json, report.html and junit.xml");
  add_jobs(*command, arguments->jobs, "Number of threads");
  add_format(*command, arguments->format, {"text", "json", "junit"});
  command->callback([&chosen, arguments] { chosen = [arguments] { return check(*arguments); }; });
}

}  // namespace carom::tool
