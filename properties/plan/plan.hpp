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
#include <carom/properties/plan/contact_class.hpp>
#include <carom/properties/plan/lint.hpp>
#include <carom/properties/plan/reduction.hpp>

/// The cheapest law, precision, 3×3 solve and frame for each class of contacts, and for all contacts.
namespace carom::properties::plan {

/// The number of contacts on which a cheaper law equals the law asked for, by reason.
struct LawCount {
  Law law;
  EnumArray<Reduction, std::size_t, all_reductions.size()> by_reason{};
  /// Contacts that the best candidate of `law` serves: its outcomes pass as outcomes of the law asked for.
  std::size_t served = 0;

  [[nodiscard]] std::size_t exactly() const;
};

struct JudgedCandidate {
  std::size_t candidate;  // index in Plan::candidates
  Certificate certificate;
  std::optional<double> nanoseconds;  // per contact, if it was timed

  /// Whether the candidate serves every contact. With `Demand::exact_law`, its law must also have exactly the same
  /// outcomes as the law asked for.
  bool serves = false;
};

/// A set of contacts, with the candidates that were judged on it.
struct Part {
  std::string name;                                                            // name of the class
  std::vector<std::size_t> contacts;                                           // indices of the contacts
  EnumArray<TorqueForm, std::size_t, all_torque_forms.size()> torque_forms{};  // number of contacts for each form
  std::size_t colliding = 0;
  std::vector<LawCount> laws;
  std::vector<JudgedCandidate> candidates;
  std::optional<double> baseline_nanoseconds;  // per contact, of the baseline (see `make_plan`)
  std::size_t timed_contacts = 0;
  std::optional<std::size_t> one_at_a_time;  // index in `candidates` of the best one that serves
  std::optional<std::size_t> in_batches;

  /// The time of the baseline divided by that of the candidate. Precondition: both were timed.
  [[nodiscard]] double saving_of(const JudgedCandidate& candidate) const;
  [[nodiscard]] const LawCount& count_of(Law law) const;
};

struct Plan {
  std::vector<Candidate> candidates;  // those whose law may replace the law asked for
  std::vector<std::string> places;    // of the contacts that are served
  std::vector<Part> classes;          // in the order of each class's first contact
  Part whole;
  std::size_t left_out = 0;  // contacts for which no law is defined
  std::vector<LintFinding> findings;

  /// Whether a candidate serves every contact.
  [[nodiscard]] bool serves() const;

  /// The time of the baseline divided by the time of the methods chosen for the classes, each on the contacts of its
  /// class. The time to find the class of a contact does not count. None if a class has no choice, or if nothing was
  /// timed.
  [[nodiscard]] std::optional<double> saving_by_class(bool in_batches) const;
};

/// A request to time a candidate on these contacts.
struct Timing {
  const Candidate* candidate;
  std::span<const Collision> collisions;  // not empty
};

/// Measures all timings in one run: nanoseconds per contact, one number for each timing.
using Clock = std::function<std::vector<double>(std::span<const Timing>)>;

/// At most this many contacts of a set are timed.
inline constexpr std::size_t contacts_timed = 64;

/// Times within this factor of the least time count as equal. Then `is_less` decides.
inline constexpr double times_alike = 1.1;

struct PlanOptions {
  Demand demand;
  Workers workers = {};  // the threads that judge
  Clock clock = {};      // if empty, nothing is timed and `is_less` alone decides
  std::function<void(std::uint64_t done, std::uint64_t all)> progress = {};
  std::stop_token stop = {};
};

/// Chooses methods for these contacts. Throws std::invalid_argument if there is no contact, if the law is `any`, or if
/// no candidate is the baseline (the subject "LAW-double"). Throws it also if a collision is neither valid nor
/// `is_out_of_range` (lint.hpp). Throws std::runtime_error if it is stopped.
[[nodiscard]] Plan make_plan(std::span<const ClassedCollision> contacts, std::span<const Candidate> candidates,
                             const PlanOptions& options);

}  // namespace carom::properties::plan
