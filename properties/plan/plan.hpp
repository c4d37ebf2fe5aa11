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

/// The least that serves: of law, precision, 3×3 solve, frame and batch, for each class of contacts and for the whole.
namespace carom::properties::plan {

/// On how many contacts a lesser law is the law asked for, and why.
struct LawCount {
  Model law;
  EnumArray<Reduction, std::size_t, all_reductions.size()> by_reason{};
  std::size_t served = 0;  // contacts that its best candidate serves: within the accuracy it is that law

  [[nodiscard]] std::size_t exactly() const;
};

/// A candidate on a set of contacts.
struct JudgedCandidate {
  std::size_t candidate;  // its number
  Certificate certificate;
  std::optional<double> nanoseconds;  // for each contact, where it was timed

  /// Also by the law, where that has to be the one asked for.
  bool serves = false;
};

/// What serves a set of contacts.
struct Part {
  std::string name;                   // of the class
  std::vector<std::size_t> contacts;  // their numbers
  std::size_t colliding = 0;
  std::vector<LawCount> laws;
  std::vector<JudgedCandidate> candidates;
  std::optional<double> baseline_nanoseconds;  // of the law asked for, in double, by its default method
  std::size_t timed_contacts = 0;
  std::optional<std::size_t> one_at_a_time;  // the least that serves, as an index of `candidates`
  std::optional<std::size_t> in_batches;

  /// By what factor it is quicker than the baseline. Precondition: it was timed.
  [[nodiscard]] double saving_of(const JudgedCandidate& candidate) const;
  [[nodiscard]] const LawCount& count_of(Model law) const;
};

struct Plan {
  std::vector<Candidate> candidates;  // those whose law may stand in for the one asked for
  std::vector<std::string> places;    // of the contacts that are to be served
  std::vector<Part> classes;          // in the order of their first contacts
  Part whole;
  std::size_t left_out = 0;  // contacts for which no law is defined
  std::vector<LintFinding> findings;

  /// Whether something serves every contact.
  [[nodiscard]] bool serves() const;

  /// By what factor the choices of the classes, each on its own contacts, are together quicker than the baseline; none
  /// where a class has none, or nothing was timed. What it takes to tell the classes apart is not in it.
  [[nodiscard]] std::optional<double> saving_by_class(bool in_batches) const;
};

/// What a clock is to measure: a candidate on these contacts.
struct Timing {
  const Candidate* candidate;
  std::span<const Collision> collisions;  // not empty
};

/// Nanoseconds for each contact, one for each timing, all in one run.
using Clock = std::function<std::vector<double>(std::span<const Timing>)>;

/// How many contacts of a set are timed at most, spread evenly over it.
inline constexpr std::size_t contacts_timed = 64;

/// Times within this factor of the least count as equal: the order of `is_less` then decides.
inline constexpr double times_alike = 1.1;

struct PlanOptions {
  Demand demand;
  Workers workers = {};  // that judge
  Clock clock = {};      // empty: nothing is timed, and `is_less` alone decides
  std::function<void(std::uint64_t done, std::uint64_t all)> progress = {};
  std::stop_token stop = {};
};

/// The plan for these contacts. Throws std::invalid_argument where there are no contacts, where the law is `any`, where
/// no candidate is the baseline (the subject "LAW-double"), or where a collision is neither valid nor only out of range
/// (lint.hpp); std::runtime_error where it was stopped.
[[nodiscard]] Plan make_plan(std::span<const ClassedCollision> contacts, std::span<const Candidate> candidates,
                             const PlanOptions& options);

}  // namespace carom::properties::plan
