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
/// Fewer nonzero velocities with at most so many digits, such as -1.6, are not rounded but short.
constexpr std::uint64_t few_numbers = 10;
constexpr int few_digits = 2;

double number_in(std::string_view text) {
  double number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

/// Whether a binary32 number, written with as many digits, gives this number.
bool is_binary32(double number, int significant) {
  const auto narrow = static_cast<double>(static_cast<float>(number));
  return number_in(fmt::format("{:.{}e}", narrow, std::max(significant, 1) - 1)) == number;
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
  if (path.starts_with("after.")) {
    return path.ends_with("velocity") ? std::optional(RecordedField::after) : std::nullopt;
  }
  const std::string_view name = path.substr(path.rfind('.') + 1);
  constexpr std::array<std::pair<std::string_view, RecordedField>, 14> names{{
      {"mass", RecordedField::mass},
      {"principal_inertia", RecordedField::principal_inertia},
      {"moment", RecordedField::principal_inertia},
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
  const auto* const found =
      std::find_if(names.begin(), names.end(), [&](const auto& one) { return one.first == name; });
  return found != names.end() ? std::optional(found->second) : std::nullopt;
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
  const int significant = std::max(digits, longest[field].significant);
  const auto by_significant = [&] {
    double squares = 0;
    for (const double x : components) {
      const double half = half_of_significant(x, significant);
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
  const double all =
      half_of_digit(std::max(digits, longest[field].decimals)) * std::sqrt(static_cast<double>(components.size()));
  if (components.size() > 1) {
    return all;
  }
  // A mass or a coefficient is often written with fewer decimals than the velocities, and with as many digits.
  const int of_velocities = std::max(longest[RecordedField::after].significant, longest[field].significant);
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
      return fmt::format("{} significant digits, {}", digits, remedy);
    case Form::decimals:
      break;
  }
  return fmt::format("{} decimal{}, {}", digits, digits == 1 ? "" : "s", remedy);
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
    if (*field != RecordedField::after) {
      return;
    }
    const auto counted = [](auto& counts, int digits) {
      ++counts[std::min(static_cast<std::size_t>(digits), counts.size() - 1)];
    };
    counted(with_decimals_, one.decimals);
    counted(with_significant_, one.significant);
    const double number = number_in(text);
    count_ += number != 0 ? 1 : 0;
    may_be_binary32_ =
        may_be_binary32_ && (one.significant < digits_beyond_binary32 || is_binary32(number, one.significant));
  });
}

Resolution DigitsReader::resolution(std::optional<int> stated) const {
  const Spelling& longest = longest_[RecordedField::after];
  Resolution resolution;
  resolution.longest = longest_;
  resolution.precision = may_be_binary32_ ? Precision::binary32 : Precision::binary64;
  const auto count_of = [](const auto& counts, int digits) {
    return counts[std::min(static_cast<std::size_t>(digits), counts.size() - 1)];
  };
  if (stated) {
    resolution.form = Resolution::Form::stated;
    resolution.digits = *stated;
  } else if (longest.significant >= digits_of_binary64) {
    resolution.form = Resolution::Form::exact;
  } else if (longest.significant <= few_digits && count_ < few_numbers) {
    resolution.form = Resolution::Form::exact;
    resolution.precision = Precision::binary64;
  } else if (count_of(with_decimals_, longest.decimals) >= count_of(with_significant_, longest.significant)) {
    resolution.form = Resolution::Form::decimals;
    resolution.digits = longest.decimals;
  } else {
    resolution.form = Resolution::Form::significant;
    resolution.digits = longest.significant;
  }
  return resolution;
}

}  // namespace carom::properties::records
