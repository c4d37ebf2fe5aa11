// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include <carom/properties/gate/workers.hpp>
#include <carom/properties/plan/certificate.hpp>
#include <carom/properties/plan/classed_collision.hpp>
#include <carom/properties/plan/lint_finding.hpp>
#include <carom/properties/plan/reduction.hpp>

/// The cheapest law, precision, 3×3 solve, frame and batch that serve each class of contacts, and all contacts.
namespace carom::properties::plan {

/// The number of contacts on which a lesser (cheaper) law equals the law asked for, by reason.
struct LawCount {
  Law law;
  EnumArray<Reduction, std::size_t, all_reductions.size()> by_reason{};
  /// Contacts that the best candidate of `law` serves. There the candidate agrees with the law asked for, within the
  /// accuracy.
  std::size_t served = 0;

  [[nodiscard]] std::size_t exactly() const;
};

/// A candidate on a set of contacts.
struct JudgedCandidate {
  std::size_t candidate;  // index in Plan::candidates
  Certificate certificate;
  std::optional<double> nanoseconds;  // per contact, if it was timed

  /// Whether the candidate serves every contact, and its law is exactly the one asked for if the demand requires that.
  bool serves = false;
};

/// A set of contacts, and the candidates that serve it.
struct Part {
  std::string name;                   // name of the class
  std::vector<std::size_t> contacts;  // indices of the contacts that are served
  std::size_t colliding = 0;
  std::vector<LawCount> laws;
  std::vector<JudgedCandidate> candidates;
  std::optional<double> baseline_nanoseconds;  // per contact, for the law asked for in double by its default method
  std::size_t timed_contacts = 0;
  std::optional<std::size_t> one_at_a_time;  // the best that serves, as an index of `candidates`
  std::optional<std::size_t> in_batches;

  /// The time of the baseline over the time of the candidate. Precondition: both were timed.
  [[nodiscard]] double saving_of(const JudgedCandidate& candidate) const;
  [[nodiscard]] const LawCount& count_of(Law law) const;
};

struct Plan {
  std::vector<Candidate> candidates;  // the candidates whose law may stand in for the one asked for
  std::vector<std::string> places;    // of the contacts that are served
  std::vector<Part> classes;          // in the order of each class's first contact
  Part whole;
  std::size_t left_out = 0;  // contacts for which no law is defined
  std::vector<LintFinding> findings;

  /// Whether a candidate serves every contact.
  [[nodiscard]] bool serves() const;

  /// The time of the baseline over the time of the choices of the classes, each on its own contacts. None if a class
  /// has no choice, or if nothing was timed. The time to determine a contact's class is not included.
  [[nodiscard]] std::optional<double> saving_by_class(bool in_batches) const;
};

/// A measurement for a clock: a candidate on these contacts.
struct Timing {
  const Candidate* candidate;
  std::span<const Collision> collisions;  // not empty
};

/// Measures all timings in one run. Returns nanoseconds per contact, one number for each timing.
using Clock = std::function<std::vector<double>(std::span<const Timing>)>;

/// The largest number of contacts of a set that are timed, spread evenly over it.
inline constexpr std::size_t contacts_timed = 64;

/// Times within this factor of the least count as equal. The order of `is_less` then decides.
inline constexpr double times_alike = 1.1;

struct PlanOptions {
  Demand demand;
  Workers workers = {};  // the threads that judge
  Clock clock = {};      // if empty, nothing is timed and `is_less` alone decides
  std::function<void(std::uint64_t done, std::uint64_t all)> progress = {};
  std::stop_token stop = {};
};

/// The plan for these contacts.
///
/// Throws std::invalid_argument if there is no contact, if the law is `any`, or if no candidate is the baseline (the
/// subject "LAW-double"). Throws std::invalid_argument if a collision is neither valid nor `is_out_of_range`
/// (lint.hpp). Throws std::runtime_error if it was stopped.
[[nodiscard]] Plan make_plan(std::span<const ClassedCollision> contacts, std::span<const Candidate> candidates,
                             const PlanOptions& options);

}  // namespace carom::properties::plan
