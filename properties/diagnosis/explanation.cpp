// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include <carom/properties/diagnosis/explanation.hpp>
#include <carom/properties/diagnosis/fits.hpp>
#include <carom/properties/diagnosis/where.hpp>

namespace carom::properties::diagnosis {
namespace {

using Together = std::vector<const Hypothesis*>;

constexpr std::size_t most_found = 5;

/// A replaced hypothesis may explain the remaining answers, so it may be found again. After so many replacements, it is
/// not.
constexpr std::size_t most_left_out = 2;

/// A hypothesis that explains fewer than one in so many wrong answers is an exception of another fault. If a subject
/// keeps state, some of its answers look like another fault by chance.
constexpr std::size_t least_explained_share = 150;
constexpr std::size_t least_explained_share_with_state = 50;

/// The numbers of answers that are examined for the next hypothesis. The second applies if the first shows none.
constexpr std::array examined_counts{std::size_t{48}, std::size_t{192}};

/// All subsets of the first `size` hypotheses, the smaller ones first.
std::vector<std::vector<std::size_t>> subsets_of(std::size_t size) {
  std::vector<std::vector<std::size_t>> all;
  for (std::size_t bits = 0; bits < std::size_t{1} << size; ++bits) {
    std::vector<std::size_t>& subset = all.emplace_back();
    for (std::size_t i = 0; i < size; ++i) {
      if ((bits >> i & 1) != 0) {
        subset.push_back(i);
      }
    }
  }
  std::ranges::stable_sort(all, {}, [](const std::vector<std::size_t>& subset) { return subset.size(); });
  return all;
}

Together joined(const std::vector<Hypothesis>& found, const std::vector<std::size_t>& subset,
                const Hypothesis* further) {
  Together together;
  for (const std::size_t i : subset) {
    together.push_back(&found[i]);
  }
  if (further != nullptr) {
    together.push_back(further);
  }
  return together;
}

Hypothesis any_impulses() {
  return {"the impulse were another",
          "the computation of the impulse",
          {with_steps([](Steps& steps, const KnownCase&) { steps.freedom = Freedom::whole; })}};
}

/// At most `count` of the numbers, at equal distances.
std::vector<std::size_t> spread(const std::vector<std::size_t>& numbers, std::size_t count) {
  std::vector<std::size_t> chosen;
  const std::size_t size = std::min(count, numbers.size());
  for (std::size_t i = 0; i < size; ++i) {
    chosen.push_back(numbers[i * numbers.size() / size]);
  }
  return chosen;
}

class HypothesisSearch {
 public:
  HypothesisSearch(std::span<const KnownCase> wrong, double unit_roundoff, std::vector<Hypothesis> known,
                   std::span<const KnownCase> right)
      : wrong_(wrong.begin(), wrong.end()),
        right_(right),
        unit_roundoff_(unit_roundoff),
        rest_(wrong.size()),
        known_(known.size()),
        applied_right_(wrong.size()) {
    std::iota(rest_.begin(), rest_.end(), std::size_t{0});
    for (KnownCase& one : wrong_) {
      one.tolerance = tolerance_of(one);
    }
    explanation_.found = std::move(known);
    explanation_.by.resize(wrong.size());
  }

  Explanation run() && {
    while (explanation_.found.size() < most_found && rest_.size() >= least_violated) {
      std::optional<Hypothesis> next;
      for (const std::size_t most : examined_counts) {
        next = next ? next : best({{}}, most);
        if (!next && !explanation_.found.empty()) {
          // Among few answers, two others may act together with the next mistake; among many, the search would be slow.
          next = best(subsets_up_to(most == examined_counts.front() ? 2 : 1), most);
        }
      }
      std::vector<Hypothesis> added = next ? std::vector{std::move(*next)} : best_together();
      if (added.empty()) {
        break;
      }
      for (Hypothesis& hypothesis : added) {
        explanation_.found.push_back(std::move(hypothesis));
      }
      take_out(added.size());
      leave_out_redundant();
      demand_agreement_within_rounding();
    }
    for (std::size_t h = explanation_.found.size(); h-- > known_;) {
      const std::size_t share = known_ > 0 ? least_explained_share_with_state : least_explained_share;
      const std::size_t least = explanation_.found[h].has_fitted_number ? least_alike : least_violated;
      if (cases_of(h).size() < std::max<std::size_t>(least, wrong_.size() / share)) {
        leave_out(h);
      }
    }
    if (known_ > 0) {
      explain_by_known();
    }
    find_needed();
    return std::move(explanation_);
  }

 private:
  /// From now on, a hypothesis explains an answer only within rounding. A thousandth of an error leaves room for
  /// coincidences among the answers that the first hypothesis does not explain.
  void demand_agreement_within_rounding() {
    for (KnownCase& one : wrong_) {
      one.most_distant = rounding_distance(one, unit_roundoff_);
      one.near = 0;
      one.tolerance = tolerance_of(one);
    }
  }

  /// Whether some impulse gives the answer.
  [[nodiscard]] bool is_applied_right_in(std::size_t number) {
    std::optional<bool>& known = applied_right_[number];
    if (!known) {
      known = is_applied_right(wrong_[number]);
    }
    return *known;
  }

  [[nodiscard]] bool do_explain(const Together& together, std::size_t number) const {
    return explains(together, wrong_[number]);
  }

  /// The subsets of at most `most` found hypotheses.
  [[nodiscard]] std::vector<std::vector<std::size_t>> subsets_up_to(std::size_t most) const {
    std::vector<std::vector<std::size_t>> subsets = subsets_of(explanation_.found.size());
    std::erase_if(subsets, [&](const std::vector<std::size_t>& subset) { return subset.size() > most; });
    return subsets;
  }

  /// The least number of hypotheses that explain a case; 0 if none do.
  using Fewest = std::size_t;

  /// The number of hypotheses that explain the case: this one and those of the first subset that suffices.
  [[nodiscard]] Fewest fewest_with(const Hypothesis& hypothesis, const std::vector<std::vector<std::size_t>>& subsets,
                                   std::size_t number) {
    const auto found = std::find_if(subsets.begin(), subsets.end(), [&](const std::vector<std::size_t>& subset) {
      return do_explain(joined(explanation_.found, subset, &hypothesis), number);
    });
    return found == subsets.end() ? 0 : 1 + found->size();
  }

  /// For each case of `looked_at`, how many hypotheses explain it, this one among them.
  [[nodiscard]] std::vector<Fewest> fitting(const Hypothesis& hypothesis,
                                            const std::vector<std::vector<std::size_t>>& subsets,
                                            const std::vector<std::size_t>& looked_at) {
    // A hypothesis that is right for a fifth misses 24 once in 211.
    const std::size_t most_missed_at_first = looked_at.size() / 2;
    std::vector<Fewest> fitted(looked_at.size());
    bool is_any = false;
    for (std::size_t i = 0; i < looked_at.size() && (is_any || i < most_missed_at_first); ++i) {
      fitted[i] = fewest_with(hypothesis, subsets, looked_at[i]);
      is_any = is_any || fitted[i] > 0;
    }
    return fitted;
  }

  /// The hypothesis with the fitted number that most of the cases show. None if no two cases show the same.
  [[nodiscard]] std::optional<Hypothesis> most_frequent(const Fit& fit,
                                                        const std::vector<std::vector<std::size_t>>& subsets,
                                                        const std::vector<std::size_t>& looked_at) {
    constexpr std::size_t most_fitted = 16;
    std::vector<double> values;
    for (const std::size_t number : spread(looked_at, most_fitted)) {
      for (const std::vector<std::size_t>& subset : subsets) {
        Steps steps = right_steps(wrong_[number]);
        bool changes_application = fit.changes_application;
        const bool applies = std::ranges::all_of(subset, [&](std::size_t i) {
          changes_application = changes_application || explanation_.found[i].changes_application;
          return explanation_.found[i].mistakes.front()(steps, wrong_[number]);
        });
        if (applies && (changes_application || is_applied_right_in(number))) {
          const std::vector<double> numbers = fitted(fit, steps, wrong_[number]);
          values.insert(values.end(), numbers.begin(), numbers.end());
        }
      }
    }
    const std::optional<double> number = most_alike(values);
    std::optional<Hypothesis> hypothesis = number ? std::optional(with_number(fit, *number)) : std::nullopt;
    constexpr std::size_t least_refuting = 50;  // one in so many
    return hypothesis && hypothesis->is_limit && contradictions(*hypothesis) * least_refuting > right_.size()
               ? std::nullopt
               : hypothesis;
  }

  /// The number that most of the values share, to as many digits as they do. None if no two are alike.
  static std::optional<double> most_alike(const std::vector<double>& values) {
    std::vector<double> most;
    for (const double value : values) {
      std::vector<double> alike;
      std::ranges::copy_if(values, std::back_inserter(alike), [&](double other) { return agree(value, other); });
      most = alike.size() > most.size() ? alike : most;
    }
    if (most.size() < 2) {
      return std::nullopt;
    }
    // Two neighbours that are nearest to each other have lost the fewest digits.
    std::ranges::sort(most);
    double best = most[most.size() / 2];
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < most.size(); ++i) {
      if (most[i] - most[i - 1] < least) {
        least = most[i] - most[i - 1];
        best = most[i];
      }
    }
    return best;
  }

  /// The number of right answers to which the hypothesis gives a wrong one.
  [[nodiscard]] std::size_t contradictions(const Hypothesis& hypothesis) const {
    const auto gives_right = [&](const KnownCase& one) {
      return std::ranges::any_of(hypothesis.mistakes, [&](const Mistake& mistake) {
        KnownCase answered = one;
        Steps steps = right_steps(one);
        const auto outcome = mistake(steps, one) ? outcome_of(steps, one) : std::optional(one.truth);
        answered.answered = outcome.value_or(one.truth);
        return !is_visibly_off(answered, unit_roundoff_);
      });
    };
    return right_.size() - static_cast<std::size_t>(std::ranges::count_if(right_, gives_right));
  }

  /// The number of the cases in which the hypothesis gives an answer other than the law's.
  [[nodiscard]] std::size_t touched(const Hypothesis& hypothesis, const std::vector<std::size_t>& numbers) const {
    return static_cast<std::size_t>(std::ranges::count_if(
        numbers, [&](std::size_t number) { return is_touched(hypothesis.mistakes.front(), number); }));
  }

  [[nodiscard]] bool is_touched(const Mistake& mistake, std::size_t number) const {
    const KnownCase& one = wrong_[number];
    Steps steps = right_steps(one);
    const auto outcome = mistake(steps, one) ? outcome_of(steps, one) : std::nullopt;
    return outcome && energy_distance(one.collision, *outcome, one.truth) > *one.tolerance;
  }

  /// The hypothesis that explains most of the remaining cases, alone or with one of the subsets of the found ones. Of
  /// two that explain as many, the one that needs fewer others.
  [[nodiscard]] std::optional<Hypothesis> best(const std::vector<std::vector<std::size_t>>& subsets,
                                               std::size_t most_looked_at) {
    const std::vector<std::size_t> looked_at = of_every_approach(most_looked_at);
    std::optional<Hypothesis> best;
    std::pair most{static_cast<double>(least_violated) - 0.5, 0.0};
    const auto compare = [&](const Hypothesis& hypothesis, const std::vector<Fewest>& fitted) {
      if (left_out_.count(hypothesis.as_if) >= most_left_out) {
        return;
      }
      const auto count = static_cast<double>(fitted.size()) - static_cast<double>(std::ranges::count(fitted, 0U));
      // One mistake explains better than a choice of several.
      constexpr double worth_of_choice = 0.75;
      const std::pair worth{hypothesis.is_choice ? worth_of_choice * count : count,
                            -static_cast<double>(std::accumulate(fitted.begin(), fitted.end(), Fewest{0}))};
      // A few contradictions more are chance: right answers in which a constant happens to be the right one. If right
      // answers contradict both hypotheses often, both need a condition, and the contradictions say nothing. Of two
      // that remain alike, the first in the list is preferred.
      const auto is_better = [&](const Hypothesis& one, const Hypothesis& other) {
        const std::size_t of_one = contradictions(one);
        const std::size_t of_other = contradictions(other);
        const bool is_rare = 4 * std::min(of_one, of_other) < right_.size();
        if (is_rare && (2 * of_one < of_other || 2 * of_other < of_one)) {
          return of_one < of_other;
        }
        return 4 * touched(one, looked_at) > 5 * touched(other, looked_at);
      };
      if (worth > most || (worth == most && is_better(hypothesis, *best))) {
        best = hypothesis;
        most = worth;
      }
    };
    std::vector<std::vector<Fewest>> all;
    for (const Hypothesis& hypothesis : all_hypotheses()) {
      std::vector<Fewest>& fitted = all.emplace_back(looked_at.size());
      if (hypothesis.is_choice) {
        for (std::size_t k = 1; k <= hypothesis.mistakes.size(); ++k) {
          const std::vector<Fewest>& of_one = all[all.size() - 1 - k];
          for (std::size_t i = 0; i < looked_at.size(); ++i) {
            fitted[i] =
                fitted[i] == 0 || of_one[i] == 0 ? std::max(fitted[i], of_one[i]) : std::min(fitted[i], of_one[i]);
          }
        }
      } else {
        fitted = fitting(hypothesis, subsets, looked_at);
      }
      compare(hypothesis, fitted);
    }
    for (const Fit& fit : all_fits()) {
      if (const std::optional<Hypothesis> hypothesis = most_frequent(fit, subsets, looked_at)) {
        compare(*hypothesis, fitting(*hypothesis, subsets, looked_at));
      }
    }
    return best;
  }

  /// The sets of found hypotheses without `without`, the smaller ones first, and not the empty set.
  [[nodiscard]] std::vector<std::vector<std::size_t>> subsets_without(std::optional<std::size_t> without) const {
    std::vector<std::vector<std::size_t>> subsets = subsets_of(explanation_.found.size());
    std::erase_if(subsets, [&](const std::vector<std::size_t>& subset) {
      return subset.empty() || (without && std::ranges::find(subset, *without) != subset.end());
    });
    return subsets;
  }

  /// The first of the subsets that explains the case. Empty if none does.
  [[nodiscard]] std::vector<std::size_t> first_explaining(const std::vector<std::vector<std::size_t>>& subsets,
                                                          std::size_t number) {
    for (const std::vector<std::size_t>& subset : subsets) {
      if (do_explain(joined(explanation_.found, subset, nullptr), number)) {
        return subset;
      }
    }
    return {};
  }

  [[nodiscard]] std::vector<std::size_t> cases_of(std::size_t hypothesis) const {
    std::vector<std::size_t> cases;
    for (std::size_t i = 0; i < wrong_.size(); ++i) {
      if (std::ranges::find(explanation_.by[i], hypothesis) != explanation_.by[i].end()) {
        cases.push_back(i);
      }
    }
    return cases;
  }

  /// Takes out the cases that the last `added` hypotheses explain, alone or with others.
  void take_out(std::size_t added) {
    const std::size_t size = explanation_.found.size();
    std::vector<std::vector<std::size_t>> subsets = subsets_of(size);
    std::erase_if(subsets, [&](const std::vector<std::size_t>& subset) {
      return subset.empty() || subset.back() + added < size;
    });
    std::erase_if(rest_, [&](std::size_t number) {
      explanation_.by[number] = first_explaining(subsets, number);
      return !explanation_.by[number].empty();
    });
  }

  /// At most `count` of the remaining cases. A quarter does not collide, if there are so many.
  [[nodiscard]] std::vector<std::size_t> of_every_approach(std::size_t count) const {
    std::vector<std::size_t> colliding;
    std::vector<std::size_t> others;
    for (const std::size_t number : rest_) {
      (wrong_[number].approach == oracles::ContactState::colliding ? colliding : others).push_back(number);
    }
    std::vector<std::size_t> chosen = spread(others, std::max(count / 4, count - std::min(count, colliding.size())));
    const std::vector<std::size_t> of_colliding = spread(colliding, count - chosen.size());
    chosen.insert(chosen.end(), of_colliding.begin(), of_colliding.end());
    std::ranges::sort(chosen);
    return chosen;
  }

  /// Two hypotheses that explain many of the remaining cases only together. Empty if there are none.
  [[nodiscard]] std::vector<Hypothesis> best_together() {
    if (known_ > 0 || explanation_.found.size() + 2 > most_found || 5 * rest_.size() < wrong_.size()) {
      return {};
    }
    std::vector<Hypothesis> both = with_wrong_application();
    return both.empty() ? of_computation() : both;
  }

  /// A mistake in the application of impulses shows whatever the impulses are. The other mistake computes them.
  [[nodiscard]] std::vector<Hypothesis> with_wrong_application() {
    std::vector<std::size_t> applied_wrong;
    for (const std::size_t number : of_every_approach(examined_counts.back())) {
      if (!is_applied_right_in(number)) {
        applied_wrong.push_back(number);
      }
    }
    if (applied_wrong.size() < least_violated) {
      return {};
    }
    explanation_.found.push_back(any_impulses());
    std::vector<std::size_t> kept = std::exchange(rest_, applied_wrong);
    const std::vector<std::vector<std::size_t>> with_any{{explanation_.found.size() - 1}};
    std::optional<Hypothesis> applied = best(with_any, examined_counts.front());
    explanation_.found.pop_back();
    std::optional<Hypothesis> computed;
    if (applied) {
      explanation_.found.push_back(*applied);
      computed = best({{explanation_.found.size() - 1}}, examined_counts.front());
      explanation_.found.pop_back();
    }
    rest_ = std::move(kept);
    return computed ? std::vector{*applied, *computed} : std::vector<Hypothesis>();
  }

  /// Two mistakes in the computation of the impulse. All pairs of hypotheses are tried on a few cases.
  [[nodiscard]] std::vector<Hypothesis> of_computation() {
    constexpr std::size_t most_probes = 3;
    std::vector<std::size_t> applied_right;
    for (const std::size_t number : of_every_approach(examined_counts.back())) {
      if (is_applied_right_in(number)) {
        applied_right.push_back(number);
      }
    }
    const std::vector<std::size_t> looked_at = spread(applied_right, examined_counts.front());
    std::vector<Hypothesis> best;
    std::size_t most = std::max(least_alike, looked_at.size() / 4);
    const auto compare = [&](const Hypothesis& first, const Hypothesis& second) {
      const Together together{&first, &second};
      std::size_t count = 0;
      for (std::size_t i = 0; i < looked_at.size() && count + looked_at.size() - i > most; ++i) {
        count += explains(together, wrong_[looked_at[i]]) ? 1 : 0;
      }
      if (count > most) {
        most = count;
        best = {first, second};
      }
    };
    for (const std::size_t probe : spread(looked_at, most_probes)) {
      std::vector<const Hypothesis*> touching;
      for (const Hypothesis& hypothesis : all_hypotheses()) {
        if (!hypothesis.is_choice && !hypothesis.changes_application &&
            is_touched(hypothesis.mistakes.front(), probe)) {
          touching.push_back(&hypothesis);
        }
      }
      for (std::size_t i = 0; i < touching.size(); ++i) {
        for (std::size_t j = i + 1; j < touching.size(); ++j) {
          if (explains(Together{touching[i], touching[j]}, wrong_[probe])) {
            compare(*touching[i], *touching[j]);
          }
        }
        for (const Fit& fit : all_fits()) {
          Steps steps = right_steps(wrong_[probe]);
          if (!fit.changes_application && touching[i]->mistakes.front()(steps, wrong_[probe])) {
            for (const double number : fitted(fit, steps, wrong_[probe])) {
              compare(*touching[i], with_number(fit, number));
            }
          }
        }
      }
    }
    return best;
  }

  /// Leaves out a hypothesis if the others explain nearly all of its cases. An answer "as if the contact were ignored"
  /// may be that of two mistakes, by which the contact does not collide.
  void leave_out_redundant() {
    constexpr std::size_t most_examined = 40;
    for (std::size_t h = explanation_.found.size(); h-- > known_;) {
      const std::vector<std::size_t> examined = spread(cases_of(h), most_examined);
      const std::vector<std::vector<std::size_t>> others = subsets_without(h);
      const auto explained = static_cast<std::size_t>(std::ranges::count_if(
          examined, [&](std::size_t number) { return !first_explaining(others, number).empty(); }));
      if (10 * explained >= 9 * examined.size()) {
        leave_out(h);
        return;
      }
    }
  }

  void leave_out(std::size_t hypothesis) {
    left_out_.insert(explanation_.found[hypothesis].as_if);
    const std::vector<std::vector<std::size_t>> others = subsets_without(hypothesis);
    for (const std::size_t number : cases_of(hypothesis)) {
      explanation_.by[number] = first_explaining(others, number);
      if (explanation_.by[number].empty()) {
        rest_.push_back(number);
      }
    }
    std::ranges::sort(rest_);
    explanation_.found.erase(explanation_.found.begin() + static_cast<std::ptrdiff_t>(hypothesis));
    for (std::vector<std::size_t>& by : explanation_.by) {
      for (std::size_t& h : by) {
        h -= h > hypothesis ? 1 : 0;
      }
    }
  }

  /// Explains the remaining cases by the given hypotheses, alone or with found ones.
  void explain_by_known() {
    const std::vector<std::vector<std::size_t>> all = subsets_without(std::nullopt);
    for (const std::size_t number : rest_) {
      explanation_.by[number] = first_explaining(all, number);
    }
  }

  /// Fills `Explanation::needed`: what all explanations of a case with as few hypotheses share.
  void find_needed() {
    const std::vector<std::vector<std::size_t>> all = subsets_without(std::nullopt);
    for (std::size_t i = 0; i < wrong_.size(); ++i) {
      std::vector<std::size_t> needed = explanation_.by[i];
      for (const std::vector<std::size_t>& other : all) {
        const auto is_missing = [&](std::size_t h) { return std::ranges::find(other, h) == other.end(); };
        if (other.size() == explanation_.by[i].size() && std::ranges::any_of(needed, is_missing) &&
            do_explain(joined(explanation_.found, other, nullptr), i)) {
          std::erase_if(needed, is_missing);
        }
      }
      explanation_.needed.push_back(std::move(needed));
    }
  }

  std::vector<KnownCase> wrong_;
  std::span<const KnownCase> right_;
  double unit_roundoff_;                 // of the subject
  std::vector<std::size_t> rest_;        // the numbers of the cases that are not explained
  std::size_t known_;                    // so many of the found hypotheses were given
  std::multiset<std::string> left_out_;  // hypotheses that others replaced
  std::vector<std::optional<bool>> applied_right_;
  Explanation explanation_;
};

}  // namespace

Explanation explanation_of(std::span<const KnownCase> wrong, double unit_roundoff, std::vector<Hypothesis> known,
                           std::span<const KnownCase> right) {
  return HypothesisSearch(wrong, unit_roundoff, std::move(known), right).run();
}

Hypothesis impulses_of_any_size() {
  return {"the impulse had another size",
          "what the impulse depends on",
          {with_steps([](Steps& steps, const KnownCase&) { steps.freedom = Freedom::length; })}};
}

}  // namespace carom::properties::diagnosis
