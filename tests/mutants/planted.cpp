// SPDX-License-Identifier: BSL-1.0
#include "planted.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include <carom/properties/families/family.hpp>
#include <carom/properties/invariants/invariant.hpp>

namespace carom::mutants {
namespace {

constexpr std::string_view by_the_truth = "backward_error";

/// "`x`, `y`".
std::string names(const std::vector<std::string_view>& all) {
  std::string text;
  for (const std::string_view name : all) {
    text += fmt::format("{}`{}`", text.empty() ? "" : ", ", name);
  }
  return all.empty() ? "–" : text;
}

std::string names_of_few(const std::vector<std::string_view>& all) {
  constexpr std::size_t few = 8;
  return all.size() > few ? std::to_string(all.size()) : names(all);
}

}  // namespace

std::vector<Rejected> rejected_mutants(std::uint64_t seed, std::uint64_t cases, unsigned jobs) {
  std::vector<Rejected> rejected;
  for (const Mutant& mutant : all_mutants()) {
    rejected.push_back({&mutant, {}});
  }
  const auto judge = [&](std::span<Rejected> mutants) {
    std::vector<Subject> subjects;
    for (const Rejected& one : mutants) {
      subjects.push_back(subject_of(*one.mutant));
    }
    auto by = rejecting_invariants(subjects, properties::all_families(), seed, cases);
    for (std::size_t i = 0; i < mutants.size(); ++i) {
      mutants[i].by = std::move(by[i]);
    }
  };
  const std::size_t share = (rejected.size() + jobs - 1) / jobs;
  std::vector<std::jthread> threads;
  for (std::size_t first = 0; first < rejected.size(); first += share) {
    threads.emplace_back(judge, std::span(rejected).subspan(first, std::min(share, rejected.size() - first)));
  }
  threads.clear();
  return rejected;
}

std::vector<Share> shares_of(const std::vector<Rejected>& rejected) {
  std::vector<Share> shares;
  for (const properties::Invariant& invariant : properties::all_invariants()) {
    Share share{invariant.name, 0, {}, {}, {}};
    for (const auto& [mutant, by] : rejected) {
      if (!invariant.claimed_for(mutant->law)) {
        continue;
      }
      if (!by.contains(invariant.name)) {
        share.misses.push_back(mutant->name);
        continue;
      }
      ++share.rejects;
      if (by.size() == 1) {
        share.alone.push_back(mutant->name);
      }
      if (by.size() == 2 && by.contains(by_the_truth) && invariant.name != by_the_truth) {
        share.alone_without_truth.push_back(mutant->name);
      }
    }
    shares.push_back(std::move(share));
  }
  return shares;
}

std::vector<std::string_view> sufficient_invariants(std::vector<Rejected> rejected) {
  std::vector<std::string_view> chosen;
  for (;;) {
    std::erase_if(rejected, [&](const Rejected& one) {
      return one.by.empty() || (!chosen.empty() && one.by.contains(chosen.back()));
    });
    if (rejected.empty()) {
      return chosen;
    }
    const std::vector<Share> shares = shares_of(rejected);
    chosen.push_back(std::max_element(shares.begin(), shares.end(), [](const Share& x, const Share& y) {
                       return x.rejects < y.rejects;
                     })->invariant);
  }
}

std::vector<Rejected> without_truth(std::vector<Rejected> rejected) {
  for (Rejected& one : rejected) {
    one.by.erase(by_the_truth);
  }
  return rejected;
}

std::string to_markdown(const std::vector<Rejected>& rejected) {
  std::string text;
  const auto out = std::back_inserter(text);
  const std::span<const properties::Invariant> invariants = properties::all_invariants();
  const std::vector<Share> shares = shares_of(rejected);
  fmt::format_to(out,
                 "| no. | invariant | rejects | misses, of those that claim it | rejects alone | alone but for "
                 "`backward_error` |\n| ---: | --- | ---: | --- | --- | --- |\n");
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const Share& share = shares[i];
    fmt::format_to(out, "| {} | `{}` | {} | {} | {} | {} |\n", i + 1, share.invariant, share.rejects,
                   names_of_few(share.misses), names(share.alone), names(share.alone_without_truth));
  }
  const auto count =
      std::count_if(rejected.begin(), rejected.end(), [](const Rejected& one) { return !one.by.empty(); });
  fmt::format_to(
      out, "\n{} of {} mutants are rejected. These reject as many: {}. Without `backward_error` these do: {}.\n\n",
      count, rejected.size(), names(sufficient_invariants(rejected)),
      names(sufficient_invariants(without_truth(rejected))));
  fmt::format_to(out, "| mutant | law |");
  for (std::size_t i = 0; i < invariants.size(); ++i) {
    fmt::format_to(out, " {} |", i + 1);
  }
  fmt::format_to(out, "\n| --- | --- |");
  for (std::size_t i = 0; i < invariants.size(); ++i) {
    fmt::format_to(out, ":-:|");
  }
  fmt::format_to(out, "\n");
  for (const auto& [mutant, by] : rejected) {
    fmt::format_to(out, "| `{}` | {} |", mutant->name, name_of(mutant->law));
    for (const properties::Invariant& invariant : invariants) {
      fmt::format_to(out, "{}|", by.contains(invariant.name) ? "●" : (invariant.claimed_for(mutant->law) ? "·" : " "));
    }
    fmt::format_to(out, "\n");
  }
  return text;
}

}  // namespace carom::mutants
