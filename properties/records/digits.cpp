// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include <carom/properties/records/digits.hpp>

namespace carom::properties::records {
namespace {

/// From so many significant digits on, a decimal tells each binary64 number from its neighbours but a few.
constexpr int digits_of_binary64 = 15;
/// A decimal with fewer digits tells nothing: binary32 numbers are at least as dense.
constexpr int digits_beyond_binary32 = 8;
/// Velocities with at most so many digits, such as -1.6, count as short and not as rounded. Half a unit of them would
/// hide faults.
constexpr int few_digits = 2;
/// A vector with fewer digits looks like 0.6 or 0.8, not like rounding.
constexpr int least_decimals_of_rounding = 2;
constexpr int least_significant_of_rounding = 3;

constexpr std::array<std::pair<std::string_view, RecordedField>, 15> field_names{{
    {"mass", RecordedField::mass},
    {"principal_inertia", RecordedField::principal_inertia},
    {"moment", RecordedField::principal_inertia},
    {"disc", RecordedField::size},
    {"sphere", RecordedField::size},
    {"box", RecordedField::size},
    {"orientation", RecordedField::orientation},
    {"position", RecordedField::position},
    {"velocity", RecordedField::velocity},
    {"angular_velocity", RecordedField::angular_velocity},
    {"point", RecordedField::point},
    {"normal", RecordedField::normal},
    {"restitution", RecordedField::coefficient},
    {"friction", RecordedField::coefficient},
    {"tangential_restitution", RecordedField::coefficient},
}};

constexpr std::array vector_fields{RecordedField::orientation,      RecordedField::position, RecordedField::velocity,
                                   RecordedField::angular_velocity, RecordedField::point,    RecordedField::normal};

double number_in(std::string_view text) {
  text.remove_prefix(text.starts_with('+') ? 1 : 0);
  double number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

/// Whether a binary32 number, written with as many digits, gives this number.
bool is_binary32(double number, int significant) {
  const auto narrow = static_cast<double>(static_cast<float>(number));
  return number_in(fmt::format("{:.{}e}", narrow, std::max(significant, 1) - 1)) == number;
}

template <class Histogram>
auto& count_of(Histogram& counts, int digits) {
  return counts[std::min(static_cast<std::size_t>(digits), counts.size() - 1)];
}

double half_of_digit(int decimals) { return 0.5 * std::pow(10.0, -decimals); }

/// Half a unit of the last of `significant` digits.
double half_of_significant(double number, int significant) {
  return number == 0 || !std::isfinite(number)
             ? 0
             : half_of_digit(significant - 1 - static_cast<int>(std::floor(std::log10(std::abs(number)))));
}

double length_of(std::span<const double> components) {
  double squares = 0;
  for (const double x : components) {
    squares += x * x;
  }
  return std::sqrt(squares);
}

}  // namespace

std::optional<RecordedField> recorded_field(std::string_view path) {
  const std::string_view name = path.substr(path.rfind('.') + 1);
  const std::string_view parent = path.substr(0, path.size() - name.size());
  if (parent == "after.a." || parent == "after.b.") {
    return name == "velocity" || name == "angular_velocity" ? std::optional(RecordedField::after) : std::nullopt;
  }
  const auto* const found =
      std::find_if(field_names.begin(), field_names.end(), [&](const auto& one) { return one.first == name; });
  if (found == field_names.end()) {
    return std::nullopt;
  }
  const RecordedField field = found->second;
  const bool is_of_contact =
      field == RecordedField::point || field == RecordedField::normal || field == RecordedField::coefficient;
  const bool has_place = is_of_contact ? parent.empty() : parent == "a." || parent == "b.";
  return has_place ? std::optional(field) : std::nullopt;
}

Spelling spelling_of(std::string_view text) {
  Spelling spelling;
  bool is_after_point = false;
  bool has_begun = false;  // whether a digit other than 0 was seen
  std::size_t i = 0;
  for (; i < text.size() && text[i] != 'e' && text[i] != 'E'; ++i) {
    if (text[i] == '.') {
      is_after_point = true;
    } else if (text[i] >= '0' && text[i] <= '9') {
      has_begun = has_begun || text[i] != '0';
      spelling.last = text[i];
      spelling.significant += has_begun ? 1 : 0;
      spelling.decimals += is_after_point ? 1 : 0;
    }
  }
  if (i < text.size()) {
    const bool has_sign = i + 1 < text.size() && text[i + 1] == '+';
    const std::string_view exponent = text.substr(i + (has_sign ? 2 : 1));
    int shift = 0;
    std::from_chars(exponent.data(), exponent.data() + exponent.size(), shift);
    spelling.decimals = std::max(0, spelling.decimals - std::clamp(shift, -400, 400));
  }
  return spelling;
}

double Resolution::half_unit(RecordedField field, std::span<const double> components) const {
  const auto by_significant = [&] {
    double squares = 0;
    for (const double x : components) {
      const double half = half_of_significant(x, known[field].significant);
      squares += half * half;
    }
    return std::sqrt(squares);
  };
  switch (form) {
    case Form::exact:
      return 0;
    case Form::stated:
      return half_of_digit(digits - 1) * length_of(components);
    case Form::significant:
      return by_significant();
    case Form::decimals:
      break;
  }
  const double all = half_of_digit(known[field].decimals) * std::sqrt(static_cast<double>(components.size()));
  if (components.size() > 1) {
    return all;
  }
  // A mass or a coefficient is often written with fewer decimals than the velocities, and with as many digits.
  const int of_velocities = std::max(known[RecordedField::after].significant, known[field].significant);
  return std::min(all, half_of_significant(components[0], of_velocities));
}

std::string Resolution::in_words() const {
  constexpr const char* remedy = "read off the numbers (--digits N sets it)";
  switch (form) {
    case Form::exact:
      return fmt::format("exact to rounding in {}, {}", name_of(precision), remedy);
    case Form::stated:
      return fmt::format("{} significant digits, by --digits", digits);
    case Form::significant:
    case Form::decimals:
      break;
  }
  std::string fewer;
  for (const RecordedField field : vector_fields) {
    const int own = form == Form::decimals ? known[field].decimals : known[field].significant;
    if (own < digits) {
      const auto* const named =
          std::find_if(field_names.begin(), field_names.end(), [&](const auto& one) { return one.second == field; });
      fewer += fmt::format("{}{} of {}", fewer.empty() ? " (" : ", ", own, named->first);
    }
  }
  fewer += fewer.empty() ? "" : ")";
  const char* const decimals = digits == 1 ? "decimal" : "decimals";
  return fmt::format("{} {}{}, {}", digits, form == Form::decimals ? decimals : "significant digits", fewer, remedy);
}

void DigitsReader::add(const nlohmann::json& spelled) {
  for_each_spelling(spelled, [this](const std::string& path, const std::string& text) {
    const std::optional<RecordedField> field = recorded_field(path);
    if (!field) {
      return;
    }
    const Spelling one = spelling_of(text);
    Spelling& longest = longest_[*field];
    longest.decimals = std::max(longest.decimals, one.decimals);
    longest.significant = std::max(longest.significant, one.significant);
    const double number = number_in(text);
    const bool is_whole = number == std::trunc(number);
    Counts& counts = counts_[*field];
    counts.fractions += is_whole ? 0 : 1;
    // Numbers such as 1.25 are chosen, not rounded.
    const bool counts_here = *field == RecordedField::after || !(is_whole || one.last == '0' || one.last == '5');
    count_of(counts.with_decimals, one.decimals) += counts_here ? 1 : 0;
    count_of(counts.with_significant, one.significant) += counts_here ? 1 : 0;
    if (*field != RecordedField::after) {
      return;
    }
    may_be_binary32_ =
        may_be_binary32_ && (one.significant < digits_beyond_binary32 || is_binary32(number, one.significant));
  });
}

Resolution DigitsReader::resolution(std::optional<int> stated) const {
  const Spelling& longest = longest_[RecordedField::after];
  const Counts& after = counts_[RecordedField::after];
  Resolution resolution;
  resolution.known = longest_;
  resolution.precision = may_be_binary32_ ? Precision::binary32 : Precision::binary64;
  if (stated) {
    resolution.form = Resolution::Form::stated;
    resolution.digits = *stated;
  } else if (longest.significant >= digits_of_binary64) {
    resolution.form = Resolution::Form::exact;
  } else if ((longest.decimals <= 1 && after.fractions == 0) || longest.significant <= few_digits) {
    resolution.form = Resolution::Form::exact;
    resolution.precision = Precision::binary64;
  } else if (count_of(after.with_decimals, longest.decimals) >= count_of(after.with_significant, longest.significant)) {
    resolution.form = Resolution::Form::decimals;
    resolution.digits = longest.decimals;
  } else {
    resolution.form = Resolution::Form::significant;
    resolution.digits = longest.significant;
  }
  for (const RecordedField field : all_recorded_fields) {
    const Counts& counts = counts_[field];
    const bool is_vector = std::find(vector_fields.begin(), vector_fields.end(), field) != vector_fields.end();
    const auto set = [&](int& own, int least, std::uint64_t rounded) {
      const bool is_rounded = is_vector && own >= least && 2 * rounded > counts.fractions;
      own = is_rounded ? own : std::max(own, resolution.digits);
    };
    Spelling& known = resolution.known[field];
    if (resolution.form == Resolution::Form::decimals) {
      set(known.decimals, least_decimals_of_rounding, count_of(counts.with_decimals, known.decimals));
    } else if (resolution.form == Resolution::Form::significant) {
      set(known.significant, least_significant_of_rounding, count_of(counts.with_significant, known.significant));
    }
  }
  return resolution;
}

}  // namespace carom::properties::records
