// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <set>

#include <fmt/format.h>

#include <carom/collision/validate.hpp>
#include <carom/properties/gate/domain_proposals.hpp>

namespace carom::properties {
namespace {

constexpr double nowhere = -std::numeric_limits<double>::infinity();

/// A proposal keeps at least this share of the cases.
constexpr double least_share = 0.1;
/// Without a cause, n violated cases leave a part with the share s free by chance with a probability of e^(−n s). There
/// are about 400 proposals with one condition, and some thousands with two.
constexpr double excluded_by_one = 12;
constexpr double excluded_by_two = 16;
constexpr std::size_t most_in_sample = 8000;

bool is_upper(std::size_t end) { return end < all_limited_quantities.size(); }
LimitedQuantity quantity_at(std::size_t end) { return all_limited_quantities[end % all_limited_quantities.size()]; }

bool is_coefficient_of_restitution(LimitedQuantity quantity) {
  return quantity == LimitedQuantity::restitution || quantity == LimitedQuantity::tangential_restitution;
}

/// The value with two digits, towards the inside. A later attempt keeps a larger distance from the violated cases. No
/// value if zero is violated.
std::optional<double> end_from(std::size_t end, double first_violated, std::size_t attempt) {
  constexpr std::array factors{1.0, 0.8, 0.4};
  constexpr std::array distances{0.0, 0.05, 0.2};
  const double violated = is_upper(end) ? first_violated : -first_violated;
  const double inwards = is_upper(end) ? -1 : 1;
  double value = violated;
  double unit = 0.01;
  if (is_coefficient_of_restitution(quantity_at(end))) {
    value += inwards * distances[attempt];
  } else if (violated > 0) {
    value = is_upper(end) ? violated * factors[attempt] : violated / factors[attempt];
    unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
  } else {
    return std::nullopt;
  }
  double steps = is_upper(end) ? std::floor(value / unit) : std::ceil(value / unit);
  const auto rounded = [&] { return std::strtod(fmt::format("{:.2g}", steps * unit).c_str(), nullptr); };
  if (rounded() == violated) {
    steps += inwards;
  }
  return rounded();
}

}  // namespace

DomainProposals::DomainProposals(const SubjectResult& result, const GateReport& report)
    : within_(report.options.within), traits_(traits_beside(within_)) {
  std::size_t valid = 0;
  for (const std::vector<SampledCase>& of_family : report.sampled) {
    valid += static_cast<std::size_t>(std::ranges::count(of_family, true, &SampledCase::is_valid));
  }
  const std::size_t every = 1 + valid / most_in_sample;
  // A relation may fail because of the answer to another collision, which may lie outside of the right domain.
  const std::vector<const Invariant*> broken = result.violated_invariants();
  const bool by_answers = std::ranges::any_of(broken, [](const Invariant* one) { return one->is_of_one_answer(); });
  const auto counts = [&](const Invariant& invariant) { return !by_answers || invariant.is_of_one_answer(); };
  std::size_t number = 0;
  for (std::size_t f = 0; f < report.sampled.size(); ++f) {
    std::set<std::uint64_t> violated;
    for (const auto& [invariant, cases] : result.families[f].violated_cases) {
      if (counts(*invariant)) {
        violated.insert(cases.begin(), cases.end());
      }
    }
    const bool is_generic = report.options.families[f]->name == "generic";
    for (std::uint64_t index = 0; index < report.sampled[f].size(); ++index) {
      const SampledCase& one = report.sampled[f][index];
      const bool is_violated = violated.contains(index);
      is_hopeless_ = is_hopeless_ || (is_violated && !one.is_valid);
      if (!one.is_valid || std::ranges::binary_search(result.families[f].skipped_cases, index)) {
        continue;
      }
      const bool is_chosen = ++number % every == 0;
      if (!is_violated && !is_generic && !is_chosen) {
        continue;
      }
      const Placed place = placed(one.collision);
      if (is_violated) {
        violated_.push_back(place);
      }
      if (is_generic) {
        generic_.push_back(place);
      }
      if (is_chosen) {
        all_.push_back(place);
      }
    }
    for (const auto& [invariant, worst] : result.families[f].worst) {
      if (counts(*invariant)) {
        add_violation(worst.original.collision);
      }
    }
  }
}

DomainProposals::Placed DomainProposals::placed(const Collision& collision) const {
  Placed place{};
  place.at.fill(nowhere);
  for (const LimitedQuantity quantity : all_limited_quantities) {
    const auto i = static_cast<std::size_t>(quantity);
    for (const double value : values_of(collision, quantity)) {
      place.at[i] = std::max(place.at[i], value);
      place.at[i + all_limited_quantities.size()] = std::max(place.at[i + all_limited_quantities.size()], -value);
    }
  }
  for (std::size_t t = 0; t < traits_.size(); ++t) {
    place.traits |= contains(traits_[t].domain, collision) ? std::uint32_t{1} << t : 0U;
  }
  return place;
}

void DomainProposals::add_violation(const Collision& collision) {
  if (validate(collision).empty()) {
    violated_.push_back(placed(collision));
  } else {
    is_hopeless_ = true;
  }
}

double DomainProposals::share_of(const Proposal& proposal) const {
  const std::vector<Placed>& cases = proposal.traits == 0 && !generic_.empty() ? generic_ : all_;
  std::size_t chosen = 0;
  std::size_t inside = 0;
  for (const Placed& one : cases) {
    const bool has_traits = (one.traits & proposal.traits) == proposal.traits;
    chosen += has_traits || proposal.ends.empty() ? 1 : 0;
    inside += has_traits && std::ranges::all_of(proposal.ends,
                                                [&](const auto& end) { return one.at[end.first] < end.second; })
                  ? 1
                  : 0;
  }
  return chosen == 0 ? 0 : static_cast<double>(inside) / static_cast<double>(chosen);
}

/// `excluded` is the number of violated cases that the last condition excludes. Few known cases have some kinds, but
/// fresh cases are drawn into each kind.
void DomainProposals::add_if_useful(Proposal proposal, std::size_t excluded, std::vector<Proposal>& all) const {
  proposal.share = share_of(proposal);
  const double needed = proposal.conditions == 1 ? excluded_by_one : excluded_by_two;
  const bool is_shown = proposal.share >= (proposal.ends.empty() ? 0 : least_share) &&
                        static_cast<double>(excluded) * proposal.share >= needed;
  proposal.rank = 2 * proposal.conditions + (is_shown ? 0U : 1U);
  if (is_shown || proposal.ends.empty()) {
    all.push_back(std::move(proposal));
  }
}

void DomainProposals::add_traits(std::vector<Proposal>& all) const {
  const auto violated_with = [&](std::uint32_t traits) {
    return static_cast<std::size_t>(
        std::ranges::count_if(violated_, [&](const Placed& one) { return (one.traits & traits) == traits; }));
  };
  for (std::size_t t = 0; t < traits_.size(); ++t) {
    const std::uint32_t first = std::uint32_t{1} << t;
    const std::size_t violated = violated_with(first);
    if (violated == 0) {
      add_if_useful({first, {}, 1}, violated_.size(), all);
      continue;
    }
    for (std::size_t u = t + 1; u < traits_.size(); ++u) {
      const std::uint32_t both = first | std::uint32_t{1} << u;
      if (traits_[u].name != traits_[t].name && violated_with(both) == 0) {
        add_if_useful({both, {}, 2}, violated_.size(), all);
      }
    }
    add_ends_of(first, all);
  }
}

/// One end, beside the traits.
void DomainProposals::add_ends_of(std::uint32_t traits, std::vector<Proposal>& all) const {
  for (std::size_t end = 0; end < ends; ++end) {
    double first = std::numeric_limits<double>::infinity();
    std::size_t excluded = 0;
    for (const Placed& one : violated_) {
      if ((one.traits & traits) == traits) {
        first = std::min(first, one.at[end]);
        ++excluded;
      }
    }
    if (first > nowhere) {
      add_if_useful({traits, {{end, first}}, traits == 0 ? 1U : 2U}, excluded, all);
    }
  }
}

/// The first end excludes some of the violated cases, and the second end the others.
void DomainProposals::add_pairs_of_ends(std::vector<Proposal>& all) const {
  constexpr double steps = 16;
  const std::size_t count = violated_.size();
  std::vector<std::size_t> order(count);
  for (std::size_t i = 0; i < count; ++i) {
    order[i] = i;
  }
  for (std::size_t first = 0; first < ends; ++first) {
    std::sort(order.begin(), order.end(),
              [&](std::size_t x, std::size_t y) { return violated_[x].at[first] < violated_[y].at[first]; });
    for (std::size_t second = 0; second < ends; ++second) {
      if (first == second) {
        continue;
      }
      Proposal best;
      std::size_t place = 0;
      double least = std::numeric_limits<double>::infinity();
      for (double step = 1; step < steps; ++step) {
        const auto next = static_cast<std::size_t>(static_cast<double>(count) * step / steps);
        for (; place < next; ++place) {
          least = std::min(least, violated_[order[place]].at[second]);
        }
        if (next == 0 || least == nowhere) {
          continue;
        }
        Proposal proposal{0, {{first, violated_[order[next]].at[first]}, {second, least}}, 2};
        proposal.share = share_of(proposal);
        best = proposal.share > best.share ? proposal : best;
      }
      best.conditions = quantity_at(first) == quantity_at(second) ? 1 : 2;
      if (!best.ends.empty()) {
        add_if_useful(std::move(best), count, all);
      }
    }
  }
}

std::vector<DomainProposals::Proposal> DomainProposals::proposals() const {
  std::vector<Proposal> all;
  add_ends_of(0, all);
  add_traits(all);
  add_pairs_of_ends(all);
  std::stable_sort(all.begin(), all.end(), [](const Proposal& x, const Proposal& y) {
    return std::pair(x.rank, -x.share) < std::pair(y.rank, -y.share);
  });
  return all;
}

std::optional<Domain> DomainProposals::domain_of(const Proposal& proposal, std::size_t attempt) const {
  Domain domain = within_;
  for (std::size_t t = 0; t < traits_.size(); ++t) {
    if ((proposal.traits >> t & 1U) != 0) {
      domain = narrowed(domain, traits_[t]);
    }
  }
  for (const auto& [end, first_violated] : proposal.ends) {
    const std::optional<double> value = end_from(end, first_violated, attempt);
    if (!value) {
      return std::nullopt;
    }
    Range& range = domain.ranges[quantity_at(end)];
    (is_upper(end) ? range.most : range.least) = *value;
    if (range.least > range.most || range.least < whole_range(quantity_at(end)).least) {
      return std::nullopt;
    }
  }
  return holds_violation(domain, proposal.traits) ? std::nullopt : std::optional(domain);
}

bool DomainProposals::holds_violation(const Domain& domain, std::uint32_t traits) const {
  return std::ranges::any_of(violated_, [&](const Placed& one) {
    bool is_inside = (one.traits & traits) == traits;
    for (std::size_t end = 0; end < ends; ++end) {
      const Range& range = domain.ranges[quantity_at(end)];
      is_inside = is_inside && one.at[end] <= (is_upper(end) ? range.most : -range.least);
    }
    return is_inside;
  });
}

std::optional<Domain> DomainProposals::next() {
  constexpr std::size_t most_attempts = 3;
  if (is_hopeless_ || violated_.empty()) {
    return std::nullopt;
  }
  for (const Proposal& proposal : proposals()) {
    Conditions conditions{proposal.traits, {}};
    for (const auto& [end, first_violated] : proposal.ends) {
      conditions.second.push_back(end);
    }
    std::ranges::sort(conditions.second);
    std::size_t& attempt = attempts_[conditions];
    while (attempt < most_attempts) {
      if (std::optional<Domain> domain = domain_of(proposal, attempt++)) {
        return domain;
      }
    }
  }
  return std::nullopt;
}

}  // namespace carom::properties
