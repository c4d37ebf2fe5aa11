// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <carom/collision/enum_array.hpp>
#include <carom/collision/json/record.hpp>
#include <carom/collision/precision.hpp>

namespace carom::properties::records {

/// A kind of number in a record.
enum class RecordedField {
  mass,
  principal_inertia,
  size,  // of a sphere or a box
  orientation,
  position,
  velocity,          // before
  angular_velocity,  // before
  point,
  normal,
  coefficient,  // ε, μ, e_t
  after,        // every velocity after
};
inline constexpr std::array all_recorded_fields{RecordedField::mass,
                                                RecordedField::principal_inertia,
                                                RecordedField::size,
                                                RecordedField::orientation,
                                                RecordedField::position,
                                                RecordedField::velocity,
                                                RecordedField::angular_velocity,
                                                RecordedField::point,
                                                RecordedField::normal,
                                                RecordedField::coefficient,
                                                RecordedField::after};
static_assert(counts_from_zero_to(all_recorded_fields, RecordedField::after));

/// The kind of the number at a path such as "after.a.velocity" or "a.sphere"; none for an unknown field.
[[nodiscard]] std::optional<RecordedField> recorded_field(std::string_view path);

/// How a decimal number is written: "-1.60" has 2 decimals and 3 significant digits.
struct Spelling {
  int decimals = 0;
  int significant = 0;
  char last = '0';  // digit
};
[[nodiscard]] Spelling spelling_of(std::string_view text);

/// How precisely a set of records is written. A number is known to half a unit of its last digit. A field may be
/// written shorter than the velocities after. Then it has their digits, unless it is a vector whose numbers look
/// rounded.
struct Resolution {
  enum class Form {
    exact,        // as the numbers stand
    decimals,     // to this number of decimals
    significant,  // to this number of significant digits
    stated,       // by the user: to this number of significant digits of the vector
  };

  Form form = Form::exact;
  int digits = 0;                             // of the velocities after; unused if `exact`
  Precision precision = Precision::binary64;  // of the arithmetic that the numbers come from
  /// The decimals or significant digits to which each field is known.
  EnumArray<RecordedField, Spelling, all_recorded_fields.size()> known = {};

  /// An upper bound of the length of the error of a scalar or vector with these components.
  [[nodiscard]] double half_unit(RecordedField field, std::span<const double> components) const;

  /// "4 decimals (3 of normal), read off the numbers (--digits N sets it)".
  [[nodiscard]] std::string in_words() const;
};

/// Reads the resolution off the spellings of records.
class DigitsReader {
 public:
  /// Adds a record that parse_spelled has parsed.
  void add(const nlohmann::json& spelled);

  /// `stated` is the number of significant digits that the user states.
  [[nodiscard]] Resolution resolution(std::optional<int> stated) const;

 private:
  /// Velocities after, or numbers of another field that look rounded.
  struct Counts {
    std::array<std::uint64_t, 40> with_decimals{};     // with so many decimals
    std::array<std::uint64_t, 40> with_significant{};  // and with so many significant digits
    std::uint64_t fractions = 0;                       // of all numbers of the field
  };

  EnumArray<RecordedField, Spelling, all_recorded_fields.size()> longest_;
  EnumArray<RecordedField, Counts, all_recorded_fields.size()> counts_;
  bool may_be_binary32_ = true;  // no velocity after tells that it is no binary32 number
};

}  // namespace carom::properties::records
