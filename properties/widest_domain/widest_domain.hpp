// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <carom/collision/subject.hpp>
#include <carom/properties/cases/domain.hpp>
#include <carom/properties/gate/gate_report.hpp>

namespace carom::properties {

/// Keeps the sessions of a program from one run of the gate to the next, because a program may take a second to start.
/// The sessions end with this object. Only the thread that made this object may use its subject.
class KeptSessions {
 public:
  explicit KeptSessions(const Subject& subject);
  KeptSessions(const KeptSessions&) = delete;  // the subject refers to this object
  KeptSessions& operator=(const KeptSessions&) = delete;

  /// The subject with other sessions: `open` takes a session that is not in use, and `close` gives it back. Two
  /// sessions take turns, so a session and the next one are not the same.
  [[nodiscard]] const Subject& subject() const { return subject_; }

 private:
  struct Kept {
    Session session;
    bool has_failed = false;
  };

  Session take();

  Subject subject_;
  std::function<Session()> open_;
  std::shared_ptr<std::deque<std::shared_ptr<Kept>>> idle_;
};

/// Measures the widest domain in which a subject holds.
struct WidestDomainOptions {
  std::uint64_t seed = 1;
  oracles::Limits limits = {};
  /// Limits that permit less rounding. If given, the ends are searched with it, too.
  std::optional<oracles::Limits> stricter = {};
  Workers workers = {};
  Domain core;                       // the subject must hold here; `default_core` is a choice
  std::uint64_t cases_of_slab = 10;  // of each family, times its weight, for each step of a search
  std::uint64_t cases_of_box = 200;  // the same, for the domain that results: 10,000 cases or more
  std::stop_token stop;
};

/// Ordinary numbers: sizes of 1 m, masses of 1 kg, speeds of 8 m/s, and ratios of at most 2.
[[nodiscard]] Domain default_core();

/// One end of a quantity's range.
struct Face {
  LimitedQuantity quantity;
  bool is_upper;
  double end = 0;  // the last value up to which the subject holds, if only this quantity leaves the core
  /// A violation just beyond the end. None if the subject holds up to the end of the search.
  std::optional<Witness> beyond = {};
  std::string error = {};  // why the subject could not be judged beyond the end; empty if it could
};

/// The ends of the ranges with one set of limits.
struct Ends {
  /// A violation in the core, an error of the subject there, or a stop. Then nothing else is known.
  std::optional<Witness> in_core = {};
  std::string error = {};
  std::vector<Face> faces = {};
  std::uint64_t cases_of_core = 0;
  UnjudgedCounts unjudged_of_core{};
};

struct WidestDomain {
  Ends ends = {};
  /// The ends with the stricter limits. None if the options have none, or if nothing is known of `ends`.
  std::optional<Ends> stricter = {};
  /// The domain that results from all faces together. If it had a violation, its ranges were narrowed towards the core,
  /// all in one proportion.
  Domain domain = {};
  double share = 1;           // of the way from the core to the faces, on the scale of the search
  std::uint64_t cases = 0;    // fresh cases in the domain, without a violation
  UnjudgedCounts unjudged{};  // those of them that were not judged
};

/// Whether the quantity is searched in equal steps, as the coefficients ε and e_t are. All others are searched in equal
/// ratios.
[[nodiscard]] bool is_linear(LimitedQuantity quantity);

/// The ends of a search: sizes, masses and speeds from 10⁻⁹ to 10⁹, and ratios of moments up to 10⁸. The gate's
/// families do not claim more slender bodies.
[[nodiscard]] Range searched_range(LimitedQuantity quantity);

/// The range in which the subject holds if only this quantity leaves the core.
[[nodiscard]] Range range_of(const Ends& ends, const Domain& core, LimitedQuantity quantity);

/// Searches the end of one quantity after the other, and then judges fresh cases of all quantities together. Each step
/// of a search judges cases in a slab: the quantity lies within a twentieth of the tried value, and the others in the
/// core. Quantities without which the value is impossible are widened, but not beyond the ends that are known. The
/// result depends on the options alone. Precondition: `generic` has cases in the core.
[[nodiscard]] WidestDomain measured_widest_domain(const Subject& subject, const WidestDomainOptions& options);

}  // namespace carom::properties
