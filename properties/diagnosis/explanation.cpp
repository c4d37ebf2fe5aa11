// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include <carom/oracles/laws/mechanics.hpp>
#include <carom/properties/diagnosis/explanation.hpp>
#include <carom/properties/diagnosis/fits.hpp>
#include <carom/properties/diagnosis/where.hpp>

namespace carom::properties::diagnosis {
namespace {

using Together = std::vector<const Hypothesis*>;

constexpr std::size_t most_found = 5;

/// A replaced hypothesis may explain what is left, so it may be found again. After so many replacements it is not.
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
  HypothesisSearch(std::span<const KnownCase> wrong, double unit_roundoff, std::vector<Hypothesis> known)
      : wrong_(wrong.begin(), wrong.end()), unit_roundoff_(unit_roundoff), rest_(wrong.size()), known_(known.size()) {
    std::iota(rest_.begin(), rest_.end(), std::size_t{0});
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
      if (!next) {
        break;
      }
      take_out(std::move(*next));
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
    }
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
                                   const KnownCase& one) const {
    const auto found = std::find_if(subsets.begin(), subsets.end(), [&](const std::vector<std::size_t>& subset) {
      return explains(joined(explanation_.found, subset, &hypothesis), one);
    });
    return found == subsets.end() ? 0 : 1 + found->size();
  }

  /// For each case of `looked_at`, how many hypotheses explain it, this one among them.
  [[nodiscard]] std::vector<Fewest> fitting(const Hypothesis& hypothesis,
                                            const std::vector<std::vector<std::size_t>>& subsets,
                                            const std::vector<std::size_t>& looked_at) const {
    // A hypothesis that is right for a fifth misses 24 once in 211.
    const std::size_t most_missed_at_first = looked_at.size() / 2;
    std::vector<Fewest> fitted(looked_at.size());
    bool is_any = false;
    for (std::size_t i = 0; i < looked_at.size() && (is_any || i < most_missed_at_first); ++i) {
      fitted[i] = fewest_with(hypothesis, subsets, wrong_[looked_at[i]]);
      is_any = is_any || fitted[i] > 0;
    }
    return fitted;
  }

  /// The hypothesis with the fitted number that most of the cases show. None if no case shows one.
  [[nodiscard]] std::optional<Hypothesis> most_frequent(Fit fit, const std::vector<std::vector<std::size_t>>& subsets,
                                                        const std::vector<std::size_t>& looked_at) const {
    std::vector<double> values;
    for (const std::size_t number : looked_at) {
      for (const std::vector<std::size_t>& subset : subsets) {
        Steps steps = right_steps(wrong_[number]);
        const bool applies = std::ranges::all_of(subset, [&](std::size_t i) {
          const Hypothesis& hypothesis = explanation_.found[i];
          return hypothesis.mistakes.empty() || hypothesis.mistakes.front()(steps, wrong_[number]);
        });
        if (const auto value = applies ? fitted(fit, steps, wrong_[number]) : std::nullopt; value && *value != 0) {
          values.push_back(*value);
        }
      }
    }
    std::vector<double> most;
    for (const double value : values) {
      std::vector<double> alike;
      std::ranges::copy_if(values, std::back_inserter(alike), [&](double other) { return agree(value, other); });
      most = alike.size() > most.size() ? alike : most;
    }
    if (most.empty() || (fit == Fit::length_of_impulse && is_exceeded(most.front(), most.size()))) {
      return std::nullopt;
    }
    std::ranges::sort(most);
    return with_number(fit, most[most.size() / 2]);
  }

  /// Whether more answers than `most` have longer impulses, so that the length is no limit.
  [[nodiscard]] bool is_exceeded(double length, std::size_t most) const {
    constexpr double clearly = 1.01;
    const auto longer = std::ranges::count_if(wrong_, [&](const KnownCase& one) {
      const Collision& c = one.collision;
      return has_movable_body(c) &&
             oracles::impulse_on_a(c, one.answered, oracles::reads_impulse_off_a(c)).stableNorm() > clearly * length;
    });
    return static_cast<std::size_t>(longer) > most;
  }

  /// The hypothesis that explains most of the remaining cases, alone or with one of the subsets of the found ones. Of
  /// two that explain as many, the one that needs fewer others.
  [[nodiscard]] std::optional<Hypothesis> best(const std::vector<std::vector<std::size_t>>& subsets,
                                               std::size_t most_looked_at) const {
    const std::vector<std::size_t> looked_at = spread(rest_, most_looked_at);
    std::optional<Hypothesis> best;
    std::pair most{static_cast<double>(least_violated) - 0.5, 0.0};
    const auto compare = [&](const Hypothesis& hypothesis, const std::vector<Fewest>& fitted) {
      if (left_out_.count(hypothesis.as_if) >= most_left_out) {
        return;
      }
      const auto count = static_cast<double>(fitted.size()) - static_cast<double>(std::ranges::count(fitted, 0U));
      // One mistake explains better than a choice of several.
      constexpr double worth_of_choice = 0.9;
      const std::pair worth{hypothesis.is_choice ? worth_of_choice * count : count,
                            -static_cast<double>(std::accumulate(fitted.begin(), fitted.end(), Fewest{0}))};
      if (worth > most) {
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
    for (const Fit fit : all_fits) {
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
                                                          const KnownCase& one) const {
    for (const std::vector<std::size_t>& subset : subsets) {
      if (explains(joined(explanation_.found, subset, nullptr), one)) {
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

  /// Adds the hypothesis, and takes out the cases that it explains alone or with others.
  void take_out(Hypothesis next) {
    const std::vector<std::vector<std::size_t>> subsets = subsets_of(explanation_.found.size());
    explanation_.found.push_back(std::move(next));
    std::erase_if(rest_, [&](std::size_t number) {
      for (const std::vector<std::size_t>& subset : subsets) {
        if (explains(joined(explanation_.found, subset, &explanation_.found.back()), wrong_[number])) {
          explanation_.by[number] = subset;
          explanation_.by[number].push_back(explanation_.found.size() - 1);
          return true;
        }
      }
      return false;
    });
  }

  /// Leaves out a hypothesis if the others explain nearly all of its cases. An answer "as if the contact were ignored"
  /// may be that of two mistakes, by which the contact does not collide.
  void leave_out_redundant() {
    constexpr std::size_t most_examined = 40;
    for (std::size_t h = explanation_.found.size(); h-- > known_;) {
      const std::vector<std::size_t> examined = spread(cases_of(h), most_examined);
      const std::vector<std::vector<std::size_t>> others = subsets_without(h);
      const auto explained = static_cast<std::size_t>(std::ranges::count_if(
          examined, [&](std::size_t number) { return !first_explaining(others, wrong_[number]).empty(); }));
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
      explanation_.by[number] = first_explaining(others, wrong_[number]);
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
      explanation_.by[number] = first_explaining(all, wrong_[number]);
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
            explains(joined(explanation_.found, other, nullptr), wrong_[i])) {
          std::erase_if(needed, is_missing);
        }
      }
      explanation_.needed.push_back(std::move(needed));
    }
  }

  std::vector<KnownCase> wrong_;
  double unit_roundoff_;                 // of the subject
  std::vector<std::size_t> rest_;        // the numbers of the cases that are not explained
  std::size_t known_;                    // so many of the found hypotheses were given
  std::multiset<std::string> left_out_;  // hypotheses that others replaced
  Explanation explanation_;
};

}  // namespace

Explanation explanation_of(std::span<const KnownCase> wrong, double unit_roundoff, std::vector<Hypothesis> known) {
  return HypothesisSearch(wrong, unit_roundoff, std::move(known)).run();
}

Hypothesis impulses_of_any_size() {
  return {"the impulse had another size", "what the impulse depends on", {}, FittedLength{}};
}

}  // namespace carom::properties::diagnosis
