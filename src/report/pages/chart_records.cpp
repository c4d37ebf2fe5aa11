// SPDX-License-Identifier: BSL-1.0
#include <fmt/format.h>

#include <carom/collision/json/json.hpp>
#include <carom/report/pages/chart_records.hpp>
#include <carom/report/pages/document.hpp>
#include <carom/report/pictures/diagrams.hpp>

namespace carom::report {
namespace {

using nlohmann::json;

json quantiles_record(const Quantiles& quantiles) {
  return {{"median", number_to_json(quantiles.median)},
          {"of_99_percent", number_to_json(quantiles.of_99_percent)},
          {"worst", number_to_json(quantiles.worst)}};
}

json spread_record(const Spread& spread) {
  return {{"median", spread.median}, {"lowest", spread.lowest}, {"highest", spread.highest}};
}

json exactness_record(const Exactness& exactness) {
  return {{"cases", exactness.cases},
          {"failures", exactness.failures},
          {"undetermined", exactness.undetermined},
          {"digits", exactness.has_digits ? quantiles_record(exactness.digits) : json()},
          {"backward_error_ulps", exactness.has_backward_error ? quantiles_record(exactness.backward_error) : json()}};
}

/// The text as a field of a CSV file (RFC 4180).
std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) {
    return text;
  }
  std::string field = "\"";
  for (const char letter : text) {
    field += letter == '"' ? "\"\"" : std::string(1, letter);
  }
  return field + '"';
}

std::string csv_of(const Quantiles& quantiles) {
  return fmt::format("{:.4g},{:.4g},{:.4g}", quantiles.median, quantiles.of_99_percent, quantiles.worst);
}

std::string csv_of_backward_error(const Exactness& exactness) {
  return exactness.has_backward_error ? csv_of(exactness.backward_error) : ",,";
}

std::string failing_families(const MethodMeasurement& method) {
  std::string text;
  for (const FamilyMeasurement& family : method.families) {
    if (family.exactness.failures > 0) {
      text += (text.empty() ? "" : ", ") + family.family;
    }
  }
  return text.empty() ? "–" : text;
}

Table methods_table(std::span<const MethodMeasurement> methods) {
  Table table{"",
              {{"", true},
               {"method"},
               {"precision"},
               {"ns a contact", true},
               {"digits: median / 99 % / worst"},
               {"backward error [ulps]: median / worst"},
               {"fails in"}},
              {}};
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const Exactness all = methods[i].over_all_families();
    table.rows.push_back(
        {{std::to_string(i + 1), methods[i].name, std::string(name_of(methods[i].precision)),
          in_three_digits(methods[i].nanoseconds_over_all_families().median),
          fmt::format("{:.1f} / {:.1f} / {:.1f}", all.digits.median, all.digits.of_99_percent, all.digits.worst),
          all.has_backward_error ? fmt::format("{:.2g} / {:.3g}", all.backward_error.median, all.backward_error.worst)
                                 : no_number,
          failing_families(methods[i])}});
  }
  return table;
}

/// The subjects of the law. Empty if there are none.
Table leaving_table(const Measurements& measurements, Law law) {
  Table table{"", {{"method"}}, {}};
  for (const SweepMeasurement& sweep : measurements.sweeps) {
    table.columns.push_back({sweep.label});
  }
  const std::size_t subjects = measurements.sweeps.empty() ? 0 : measurements.sweeps.front().lines.size();
  for (std::size_t s = 0; s < subjects; ++s) {
    const SweepLine& of_first = measurements.sweeps.front().lines[s];
    if (of_first.law != law) {
      continue;
    }
    Row row{{of_first.method}};
    for (const SweepMeasurement& sweep : measurements.sweeps) {
      const std::optional<double> at = sweep.lines[s].leaves_limit_at();
      row.cells.emplace_back(at ? fmt::format("{:.0e}", *at) : no_number);
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

std::string work_precision_csv(const Measurements& measurements) {
  std::string text =
      "model,method,precision,family,ns_median,ns_lowest,ns_highest,cases,failures,digits_median,digits_99_percent,"
      "digits_worst,backward_error_median,backward_error_99_percent,backward_error_worst\n";
  for (const MethodMeasurement& method : measurements.methods) {
    for (const FamilyMeasurement& family : method.families) {
      text +=
          fmt::format("{},{},{},{},{:.4g},{:.4g},{:.4g},{},{},{},{}\n", name_of(method.law), method.name,
                      name_of(method.precision), family.family, family.nanoseconds.median, family.nanoseconds.lowest,
                      family.nanoseconds.highest, family.exactness.cases, family.exactness.failures,
                      csv_of(family.exactness.digits), csv_of_backward_error(family.exactness));
    }
  }
  return text;
}

std::string stability_csv(const Measurements& measurements) {
  std::string text =
      "sweep,quantity,model,method,cases,failures,undetermined,backward_error_median,backward_error_99_percent,"
      "backward_error_worst\n";
  for (const SweepMeasurement& sweep : measurements.sweeps) {
    for (const SweepLine& line : sweep.lines) {
      for (std::size_t i = 0; i < line.quantity.size(); ++i) {
        text += fmt::format("{},{:g},{},{},{},{},{},{}\n", sweep.name, line.quantity[i], name_of(line.law),
                            csv_text(line.method), line.exactness[i].cases, line.exactness[i].failures,
                            line.exactness[i].undetermined, csv_of_backward_error(line.exactness[i]));
      }
    }
  }
  return text;
}

std::string deadline_csv(const Measurements& measurements) {
  std::string text = "model,digits,ns,share,method\n";
  for (const Law law : charted_laws()) {
    const std::vector<MethodMeasurement> methods = of_law(measurements.methods, law);
    for (const int digits : deadline_digits) {
      for (const DeadlineStep& step : deadline_steps(methods, digits)) {
        text +=
            fmt::format("{},{},{:.4g},{:.4f},{}\n", name_of(law), digits, step.nanoseconds, step.share, step.method);
      }
    }
  }
  return text;
}

json chart_record(const Measurements& measurements) {
  json record{{"environment", environment_record(measurements.environment)},
              {"seed", measurements.seed},
              {"cases", measurements.cases},
              {"repetitions", measurements.repetitions},
              {"limit_ulps", measurements.limit_ulps},
              {"methods", json::array()},
              {"sweeps", json::array()}};
  for (const MethodMeasurement& method : measurements.methods) {
    json families;
    for (const FamilyMeasurement& family : method.families) {
      families[family.family] = exactness_record(family.exactness);
      families[family.family]["nanoseconds"] = spread_record(family.nanoseconds);
    }
    record["methods"].push_back({{"name", method.name},
                                 {"summary", method.summary},
                                 {"model", name_of(method.law)},
                                 {"precision", name_of(method.precision)},
                                 {"families", families}});
  }
  for (const SweepMeasurement& sweep : measurements.sweeps) {
    json lines = json::array();
    for (const SweepLine& line : sweep.lines) {
      json points = json::array();
      for (std::size_t i = 0; i < line.quantity.size(); ++i) {
        points.push_back(exactness_record(line.exactness[i]));
        points.back()["quantity"] = line.quantity[i];
      }
      const std::optional<double> at = line.leaves_limit_at();
      lines.push_back({{"method", line.method},
                       {"model", name_of(line.law)},
                       {"leaves_limit_at", at ? json(*at) : json()},
                       {"points", points}});
    }
    record["sweeps"].push_back(
        {{"name", sweep.name}, {"quantity", sweep.label}, {"summary", sweep.summary}, {"lines", lines}});
  }
  return record;
}

std::string tables_markdown(const Measurements& measurements) {
  std::string text;
  const auto add = [&](const std::string& title, const Table& table) {
    text += (text.empty() ? "## " : "\n## ") + title + "\n\n" + markdown_table(table);
  };
  for (const Law law : charted_laws()) {
    const std::vector<MethodMeasurement> methods = of_law(measurements.methods, law);
    if (!methods.empty()) {
      add(fmt::format("{}: all families", name_of(law)), methods_table(methods));
    }
    if (const Table leaving = leaving_table(measurements, law); !leaving.rows.empty()) {
      add(fmt::format("{}: where each method leaves the limit of {:g} ulps", name_of(law), measurements.limit_ulps),
          leaving);
    }
  }
  return text;
}

}  // namespace carom::report
