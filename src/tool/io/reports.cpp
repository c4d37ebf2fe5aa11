// SPDX-License-Identifier: BSL-1.0
#include "io/reports.hpp"

#include <exception>
#include <filesystem>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <carom/properties/invariants/invariant.hpp>
#include <carom/report/pages/pages.hpp>
#include <carom/report/results/words.hpp>

#include "io/input_file.hpp"
#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

namespace fs = std::filesystem;

/// The result of `read` for the content of the file. An error message about the format starts with the file's name and
/// `is_no`.
template <class Read>
auto read_from(const std::string& file, const char* is_no, const Read& read) {
  const std::string content = content_of_file(file);
  nlohmann::json record;
  try {
    record = parse_json(content);
  } catch (const FormatError& error) {
    throw UsageError(fmt::format("{}: {}", report::shown(file), report::shown(error.what())));
  }
  try {
    return read(record);
  } catch (const FormatError& error) {
    throw UsageError(fmt::format("{}: {}{}", report::shown(file), is_no, report::shown(error.what())));
  }
}

std::string in_json(const nlohmann::json& record, int indent) {
  return record.dump(indent, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

fs::file_type type_of(const fs::path& path) {
  std::error_code ignored;
  return fs::symlink_status(path, ignored).type();
}

/// The witnesses of the report in the directory. None if there is no report of this program. A path is made of names,
/// because a text of the report could lead to any file.
std::vector<fs::path> witnesses_in(const fs::path& directory) {
  std::vector<fs::path> witnesses;
  const fs::path folder = directory / "witnesses";
  const fs::path report_file = directory / "report.json";
  if (type_of(report_file) != fs::file_type::regular || type_of(folder) != fs::file_type::directory) {
    return witnesses;
  }
  try {
    for (const report::RecordedSubject& subject : read_report(report_file.string()).subjects) {
      for (const std::string& invariant : subject.violated) {
        const fs::path file = folder / fmt::format("{}.{}.json", report::file_name_of(subject.name), invariant);
        if (properties::invariant_named(invariant) != nullptr && type_of(file) == fs::file_type::regular) {
          witnesses.push_back(file);
        }
      }
    }
  } catch (const UsageError&) {
    witnesses.clear();
  }
  return witnesses;
}

/// Puts all reports in place, or none. At every moment, the directory contains the witnesses that its report lists.
void write_reports(const report::Run& run, const std::string& out, StagedOutput& staged) {
  const fs::path& stage = staged.stage();
  make_directories(stage / "witnesses");
  for (const properties::SubjectResult& result : run.results) {
    for (const properties::Witness& witness : result.witnesses) {
      const fs::path place = report::witness_path(out, result.subject, *witness.invariant);
      write_file(report::witness_path(stage, result.subject, *witness.invariant),
                 in_json(report::witness_record(witness, result.subject, run.options, place), 2));
    }
  }
  write_file(stage / "junit.xml", report::junit_xml(run));
  write_file(stage / "report.html", report::run_html(run, out));
  write_file(stage / "report.json", in_json(report::report_record(run), 2));
  std::vector<fs::path> old = witnesses_in(out);
  std::erase_if(old, [&](const fs::path& file) { return fs::exists(stage / "witnesses" / file.filename()); });
  staged.put_in_place("report.json");
  for (const fs::path& file : old) {
    std::error_code error;
    fs::remove(file, error);
    if (error) {
      throw UsageError(fmt::format("--out: {} cannot be removed: {}", file.string(), error.message()));
    }
  }
}

void print_run(const report::Run& run, const Presentation& presentation) {
  write_output(presentation.format == "json" ? in_json(report::report_record(run), 2)
                                             : report::run_text(run, presentation.out, presentation.has_coverage));
  if (presentation.has_annotations) {
    presentation.annotate();
    write_output(report::github_annotations(run, presentation.out));
  }
}

}  // namespace

report::RecordedRun read_report(const std::string& file_or_directory) {
  std::error_code ignored;
  const std::string file = fs::is_directory(file_or_directory, ignored)
                               ? (fs::path(file_or_directory) / "report.json").string()
                               : file_or_directory;
  return read_from(file, "this is not a report.json of `carom gate --out`: ", [&](const nlohmann::json& record) {
    return report::recorded_run(record, file);
  });
}

report::ReadShard read_shard(const std::string& directory) {
  const std::string file = (fs::path(directory) / "report.json").string();
  report::ReadShard shard =
      read_from(file, "", [&](const nlohmann::json& record) { return report::shard_from(record, file); });
  for (properties::SubjectResult& result : shard.run.results) {
    for (properties::Witness& witness : result.witnesses) {
      // The path in the report is not used, because it could lead to any file.
      const fs::path path = report::witness_path(directory, result.subject, *witness.invariant);
      witness = read_from(path.string(), "", [&](const nlohmann::json& record) {
        return report::witness_from(record, *witness.invariant);
      });
    }
  }
  return shard;
}

int present_run(report::Run run, const std::optional<report::RecordedRun>& baseline, const Presentation& presentation,
                std::optional<StagedOutput>& staged) {
  if (baseline) {
    run.baseline = report::compare_runs(*baseline, report::recorded_run(report::report_record(run), "this run"));
  }
  // If the files cannot be written, the results are still printed.
  std::exception_ptr unwritten;
  try {
    if (staged) {
      write_reports(run, presentation.out, *staged);
    }
    if (!presentation.summary.empty()) {
      append_to_file("--summary", presentation.summary, report::run_markdown(run, presentation.out));
    }
  } catch (...) {
    unwritten = std::current_exception();
  }
  staged.reset();
  try {
    print_run(run, presentation);
  } catch (const std::exception&) {
    if (!unwritten) {
      throw;
    }
  }
  if (unwritten) {
    std::rethrow_exception(unwritten);
  }
  return run.exit_status();
}

}  // namespace carom::tool
