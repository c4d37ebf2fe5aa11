// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <compare>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <valarray>

#include <fmt/format.h>

#include <carom/oracles/judge/yardstick.hpp>
#include <carom/properties/cases/kinds.hpp>
#include <carom/properties/diagnosis/where.hpp>
#include <carom/properties/features/quantities.hpp>

namespace carom::properties::diagnosis {
namespace {

class CaseSet {
 public:
  explicit CaseSet(std::size_t size = 0) : words_((size + 63) / 64) {}

  [[nodiscard]] bool has(std::size_t one) const { return (words_[one / 64] >> (one % 64) & 1) != 0; }

  void add(std::size_t one) { words_[one / 64] |= std::uint64_t{1} << (one % 64); }

  [[nodiscard]] std::uint64_t size() const {
    std::uint64_t sum = 0;
    for (const std::uint64_t word : words_) {
      sum += static_cast<std::uint64_t>(std::popcount(word));
    }
    return sum;
  }

  friend CaseSet operator&(CaseSet x, const CaseSet& y) {
    x.words_ &= y.words_;
    return x;
  }
  friend CaseSet operator|(CaseSet x, const CaseSet& y) {
    x.words_ |= y.words_;
    return x;
  }
  [[nodiscard]] CaseSet without(CaseSet y) const {
    y.words_ = words_ & ~y.words_;
    return y;
  }

 private:
  std::valarray<std::uint64_t> words_;
};

/// If two conditions fit equally well, the plainer one wins: the one with the lower value.
enum class Plainness { feature, either, absence, size, family };

struct Literal {
  std::string words;  // a clause with "if" or "unless"
  Plainness plainness;
  CaseSet cases;
  const char* usual_cause = "";
};

/// A condition may miss this fraction of the violated cases (mostly cases of overflow and underflow). The second value
/// applies if the first finds no condition.
constexpr std::array most_missed{0.05, 0.2};

/// A condition must exclude this fraction of the cases that are not violated.
constexpr double least_taken_away = 0.3;

/// The usual cause of violations if the quantity is at least `limit`; empty if none is known. With moments of the ratio
/// ρ, a matrix J⁻¹ in world axes has errors of ρ ulps of its least entry. The judge permits 32 ulps.
const char* usual_cause_from(double limit, const ComparedQuantity& quantity) {
  if (quantity.name != ratio_of_moments || limit < oracles::default_limit_ulps) {
    return "";
  }
  return "the inverse inertia: J⁻¹ as a matrix in world axes loses digits of the smaller 1/I; divide "
         "the torque by each moment in the body's axes";
}

/// A solver lets a body sleep if both of its speeds are small.
const ComparedQuantity slower_motion{
    "the larger of the slower body's speed and spin [m/s, rad/s]", [](const Collision& c) {
      double least = std::numeric_limits<double>::infinity();
      for (const Body* body : {&c.a, &c.b}) {
        const double size = std::max(body->velocity.stableNorm(), body->angular_velocity.stableNorm());
        least = size > 0 ? std::min(least, size) : least;
      }
      return least;
    }};

/// The value of a kind, such as "solid_spheres".
std::string in_plain_words(std::string_view value) {
  std::string words(value);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

/// "if the speed of approach is at most 0.5 m/s", of the quantity "the speed of approach [m/s]".
std::string limit_in_words(const ComparedQuantity& quantity, const char* most_or_least, double limit) {
  const std::size_t bracket = quantity.name.find(" [");
  const std::string unit =
      bracket == std::string::npos ? "" : ' ' + quantity.name.substr(bracket + 2, quantity.name.size() - bracket - 3);
  return fmt::format("if {} is at {} {:.2g}{}", quantity.name.substr(0, bracket), most_or_least, limit, unit);
}

class Sample {
 public:
  Sample(const GateReport& report, const Violations& violations) : report_(report) {
    std::size_t count = 0;
    for (const auto& of_family : report.sampled) {
      count += of_family.size();
    }
    size_ = count;
    everything_ = violated_ = CaseSet(count);
    std::vector<CaseSet> of_feature(all_features().size(), CaseSet(count));
    std::map<oracles::ContactState, CaseSet> of_approach;
    std::size_t number = 0;
    for (std::size_t f = 0; f < report.sampled.size(); ++f) {
      CaseSet of_family(count);
      for (std::size_t i = 0; i < report.sampled[f].size(); ++i, ++number) {
        const SampledCase& one = report.sampled[f][i];
        const bool is_left_out = !violations.left_out.empty() && std::ranges::binary_search(violations.left_out[f], i);
        if (!one.is_valid || !violations.judged[f].has(i) || is_left_out || !is_examined(i, violations.every)) {
          continue;
        }
        everything_.add(number);
        of_family.add(number);
        of_approach.try_emplace(one.approach, CaseSet(count)).first->second.add(number);
        for (const std::uint16_t feature : one.features) {
          of_feature[feature].add(number);
        }
        if (std::binary_search(violations.violated[f].begin(), violations.violated[f].end(), i)) {
          violated_.add(number);
        }
      }
      // Features describe cases of `structured` better than the family's name.
      if (report.options.families[f]->name != "structured") {
        add(fmt::format("if the family is {}", report.options.families[f]->name), Plainness::family,
            std::move(of_family));
      }
    }
    for (auto& [approach, cases] : of_approach) {
      approaches_.push_back({words_of(approach), Plainness::feature, std::move(cases), ""});
    }
    add_features(of_feature);
    add_kinds();
    add_sizes();
    add_distances();
  }

  [[nodiscard]] const CaseSet& everything() const { return everything_; }
  [[nodiscard]] const CaseSet& violated() const { return violated_; }
  [[nodiscard]] const std::vector<Literal>& literals() const { return literals_; }
  [[nodiscard]] const std::vector<Literal>& approaches() const { return approaches_; }

 private:
  /// The decimal logarithm of a quantity, in the sampled case with this number.
  struct Sized {
    float size;
    bool is_violated;
    std::size_t number;

    auto operator<=>(const Sized&) const = default;
  };

  static std::string words_of(oracles::ContactState approach) {
    switch (approach) {
      case oracles::ContactState::colliding:
        return "colliding contacts";
      case oracles::ContactState::resting:
        return "resting contacts";
      case oracles::ContactState::separating:
        return "separating contacts";
      case oracles::ContactState::inert:
        break;
    }
    return "contacts of two immovable bodies";
  }

  void add(std::string words, Plainness plainness, CaseSet cases, const char* usual_cause = "") {
    literals_.push_back({std::move(words), plainness, std::move(cases), usual_cause});
  }

  void add_with_absence(const std::string& words, Plainness plainness, const CaseSet& cases) {
    add("if " + words, plainness, cases);
    add("unless " + words, Plainness::absence, everything_.without(cases));
  }

  /// The statement of a feature, about A, B, or both.
  static std::string statement_on(const std::string& bodies, std::string_view statement) {
    constexpr std::string_view body = "the body ";
    return statement.starts_with(body) ? fmt::format("{} {}", bodies, statement.substr(body.size()))
                                       : fmt::format("for {} {}", bodies, statement);
  }

  void add_features(const std::vector<CaseSet>& of_feature) {
    for (std::size_t i = 0; i < of_feature.size(); ++i) {
      const Feature& feature = all_features()[i];
      if (feature.kind == FeatureKind::magnitude || feature.kind == FeatureKind::near) {
        continue;
      }
      const std::string words = feature.body == 0 ? std::string(feature.statement)
                                                  : statement_on(feature.body == 'a' ? "A" : "B", feature.statement);
      add_with_absence(words, Plainness::feature, of_feature[i]);
      if (feature.body == 'a') {
        const Feature* other = feature_named("b." + feature.name.substr(2));
        const CaseSet either = of_feature[i] | of_feature[static_cast<std::size_t>(other - all_features().data())];
        add_with_absence(statement_on("A or B", feature.statement), Plainness::either, either);
      }
    }
  }

  /// Adds the kinds of domains. The features say which bodies can move.
  void add_kinds() {
    for (const auto& [name, value] : all_kinds()) {
      const std::string words = name == "bodies"  ? fmt::format("the bodies are {}", in_plain_words(value))
                                : name == "walls" ? "every wall is at rest"
                                : name == "plane" ? fmt::format("the collision lies in the plane {}", value)
                                                  : std::string();
      if (!words.empty()) {
        Kinds kinds;
        set_kind(kinds, name, value);
        CaseSet cases(size_);
        for_each([&](std::size_t number, const SampledCase& one) {
          if (!kind_outside(kinds, one.collision)) {
            cases.add(number);
          }
        });
        add_with_absence(words, Plainness::feature, cases);
      }
    }
  }

  /// For each quantity, adds the upper and the lower limit that separate best. Of two limits, the one is better that
  /// keeps a larger share of the violated cases, less the share of the other cases that it keeps. So a few violated
  /// cases far away do not move a limit. Adds the limits that all violated cases keep too.
  void add_sizes() {
    const std::span<const ComparedQuantity> quantities = all_compared_quantities();
    for (std::size_t q = 0; q <= quantities.size(); ++q) {
      const ComparedQuantity& quantity = q < quantities.size() ? quantities[q] : slower_motion;
      std::vector<Sized> values;
      for_each([&](std::size_t number, const SampledCase& one) {
        const float size =
            q < quantities.size() ? one.quantities[q] : static_cast<float>(std::log10(quantity.of(one.collision)));
        if (std::isfinite(size)) {
          values.push_back({size, violated_.has(number), number});
        }
      });
      std::ranges::sort(values);
      add_limits(values, [&](double limit, CaseSet kept) {
        add(limit_in_words(quantity, "most", limit), Plainness::size, std::move(kept));
      });
      std::ranges::reverse(values);
      add_limits(values, [&](double limit, CaseSet kept) {
        add(limit_in_words(quantity, "least", limit), Plainness::size, std::move(kept),
            usual_cause_from(limit, quantity));
      });
    }
  }

  /// For each near feature, of A or B, adds the upper limits of the distance. A body is nearly immovable by the ratio
  /// of masses, whose limits `add_sizes` adds.
  void add_distances() {
    std::map<std::string_view, std::vector<Sized>> distances;  // by special statement
    for_each([&](std::size_t number, const SampledCase& one) {
      for (const std::uint16_t place : one.features) {
        const Feature& feature = all_features()[place];
        if (feature.kind == FeatureKind::near && feature.name != "near_immovable") {
          const auto size = static_cast<float>(std::log10(feature.measure(one.collision)));
          std::vector<Sized>& of_either = distances[std::string_view(feature.statement).substr(nearly.size())];
          if (of_either.empty() || of_either.back().number != number) {
            of_either.push_back({size, violated_.has(number), number});
          } else {
            of_either.back().size = std::min(of_either.back().size, size);
          }
        }
      }
    });
    for (auto& of_special : distances) {
      std::ranges::sort(of_special.second);
      add_limits(of_special.second, [&](double limit, CaseSet kept) {
        add(fmt::format("{}{:.2g}, that {}", nearly_holds, limit, of_special.first), Plainness::size, std::move(kept),
            "a tolerance within which the solver takes values for the special one");
      });
    }
  }

  /// Calls use(limit, the cases within it). `values` are in the order in which a limit takes them in.
  template <class Use>
  void add_limits(const std::vector<Sized>& values, const Use& use) {
    const auto violated = static_cast<double>(std::ranges::count(values, true, &Sized::is_violated));
    const double others = std::max(1.0, static_cast<double>(values.size()) - violated);
    std::optional<float> best;
    std::optional<float> last;
    double balance = 0;
    double best_balance = -std::numeric_limits<double>::infinity();
    for (const auto& [value, is_violated, number] : values) {
      balance += is_violated ? 1 / violated : -1 / others;
      if (is_violated) {
        last = value;
        if (balance >= best_balance) {
          best = value;
          best_balance = balance;
        }
      }
    }
    if (!best) {
      return;
    }
    for (const std::optional<float>& limit : {last, best == last ? std::nullopt : best}) {
      if (!limit) {
        continue;
      }
      CaseSet kept(size_);
      const auto is_at_limit = [&](const Sized& value) { return value.size == *limit; };
      const auto end = std::find_if(values.rbegin(), values.rend(), is_at_limit).base();
      for (auto value = values.begin(); value != end; ++value) {
        kept.add(value->number);
      }
      use(std::pow(10, *limit), std::move(kept));
    }
  }

  template <class Visit>
  void for_each(const Visit& visit) const {
    std::size_t number = 0;
    for (const auto& of_family : report_.sampled) {
      for (const SampledCase& one : of_family) {
        if (everything_.has(number)) {
          visit(number, one);
        }
        ++number;
      }
    }
  }

  const GateReport& report_;
  std::size_t size_ = 0;
  CaseSet everything_;
  CaseSet violated_;
  std::vector<Literal> literals_;
  std::vector<Literal> approaches_;
};

/// An upper bound of the probability that at least `found` of `drawn` cases lie in a part of a set. The cases are drawn
/// by chance from the set, and the part is the fraction `share` of the set. Source: W. Hoeffding, "Probability
/// inequalities for sums of bounded random variables", J. Amer. Statist. Assoc. 58, 1963, theorem 1, and section 6 for
/// draws without replacement. Preconditions: 0 < found ≤ drawn; 0 < share ≤ 1.
double chance_bound(std::uint64_t found, std::uint64_t drawn, double share) {
  const double fraction = static_cast<double>(found) / static_cast<double>(drawn);
  if (fraction <= share) {
    return 1;
  }
  const double rest = 1 - fraction;
  const double of_rest = rest > 0 ? rest * std::log((1 - share) / rest) : 0;
  return std::exp(static_cast<double>(drawn) * (fraction * std::log(share / fraction) + of_rest));
}

/// The greatest probability that one search finds a condition by chance. A subject has at most six searches.
constexpr double greatest_chance = 1e-3;

/// A condition other than a size needs this share of violations among the cases that meet the conditions. With a
/// smaller share, it may be a coincidence. A size stays, because it may be far from the limit in the code.
constexpr double least_share_there = 2.0 / 3;

/// Whether at least nine tenths of the cases are violated.
bool is_nearly_all(const Share& share) { return 10 * (share.cases - share.violated) <= share.cases; }

Share share_of(const CaseSet& cases, const Sample& sample) {
  return {(cases & sample.violated()).size(), cases.size()};
}

Where where_in(const Sample& sample, double left_out) {
  Where where;
  where.violated = sample.violated().size();
  where.all = share_of(sample.everything(), sample);
  if (where.violated == 0) {
    return where;
  }
  constexpr std::size_t most_conditions = 3;
  CaseSet here = sample.everything();
  const double needed = static_cast<double>(where.violated) * (1 - left_out);
  for (const Literal& approach : sample.approaches()) {
    const Share share = share_of(here & approach.cases, sample);
    if (static_cast<double>(share.violated) >= needed) {
      where.of = approach.words;
      where.all = share;
      here = here & approach.cases;
      break;
    }
  }
  where.there = where.all;
  const CaseSet of_kind = here;
  Where telling = where;
  Share now = where.all;  // of the cases that meet all conditions
  bool has_sizes_alone = true;
  while (where.conditions.size() < most_conditions && !is_nearly_all(now)) {
    const Literal* best = nullptr;
    Share of_best;
    double best_rest = 0;
    const auto rest = static_cast<double>(now.cases - now.violated);
    for (const Literal& literal : sample.literals()) {
      const Share share = share_of(here & literal.cases, sample);
      if (static_cast<double>(share.violated) < needed) {
        continue;
      }
      const auto others = static_cast<double>(share.cases - share.violated);
      // A plainer condition wins even if it includes a few more cases that are not violated.
      constexpr double worth_of_plainness = 0.02;
      const double burden = others + worth_of_plainness * rest * static_cast<double>(literal.plainness);
      if (best == nullptr || burden < best_rest) {
        best = &literal;
        of_best = share;
        best_rest = burden;
      }
    }
    if (best == nullptr || static_cast<double>(of_best.cases - of_best.violated) > (1 - least_taken_away) * rest) {
      break;
    }
    // A bound of the probability that, by chance, any of the conditions holds in so many violated cases.
    const double part = static_cast<double>(of_best.cases) / static_cast<double>(now.cases);
    if (static_cast<double>(sample.literals().size()) * chance_bound(of_best.violated, now.violated, part) >
        greatest_chance) {
      break;
    }
    where.there = of_best;
    where.conditions.push_back({best->words, best->usual_cause, share_of(of_kind & best->cases, sample)});
    has_sizes_alone = has_sizes_alone && best->plainness == Plainness::size;
    now = of_best;
    here = here & best->cases;
    if (has_sizes_alone || static_cast<double>(now.violated) >= least_share_there * static_cast<double>(now.cases)) {
      telling = where;
    }
  }
  return telling;
}

/// A condition that says where a fault does not happen.
bool is_exception(const Condition& condition) { return condition.words.starts_with("unless "); }

}  // namespace

bool is_examined(std::uint64_t index, std::uint64_t every) {
  // Families may repeat a pattern after a few cases. The multiplier of D. Knuth's multiplicative hashing, 2³² over the
  // golden ratio, breaks it up.
  constexpr std::uint64_t multiplier = 2654435761;
  constexpr int kept_bits = 16;
  return (index * multiplier >> kept_bits) % every == 0;
}

Where where_violated(const GateReport& report, const Violations& violations) {
  const Sample sample(report, violations);
  Where where;
  for (const double left_out : most_missed) {
    where = where_in(sample, left_out);
    if (!where.conditions.empty() || is_nearly_all(where.all)) {
      break;
    }
  }
  if (where.violated < least_violated) {
    where.conditions.clear();
  }
  return where;
}

const Condition* told_condition(const Where& where) {
  // A condition of which few cases fail, and hardly more than of all, tells a reader nothing.
  const auto tells = [&](const Condition& condition) {
    constexpr std::uint64_t least_part = 5;
    constexpr std::uint64_t least_gain = 3;
    const Share& there = condition.there;
    return there.violated * least_part >= there.cases ||
           there.violated * where.all.cases >= least_gain * where.all.violated * there.cases;
  };
  const std::vector<Condition>& all = where.conditions;
  auto told =
      std::find_if(all.begin(), all.end(), [&](const Condition& one) { return tells(one) && !is_exception(one); });
  told = told == all.end() ? std::find_if(all.begin(), all.end(), tells) : told;
  return told == all.end() ? nullptr : &*told;
}

std::string in_words(const Where& where) {
  if (where.violated < least_violated) {
    return {};
  }
  const auto percent = [](const Share& share) {
    const std::uint64_t rounded = (100 * share.violated + share.cases / 2) / std::max<std::uint64_t>(share.cases, 1);
    return rounded == 0 && share.violated > 0 ? std::string("less than 1 %") : fmt::format("{} %", rounded);
  };
  const std::string of = where.of.empty() ? "cases" : where.of;
  const Condition* const told = told_condition(where);
  if (told == nullptr) {
    return fmt::format("in {} of the {}", percent(where.all), of);
  }
  const Share others{where.all.violated - told->there.violated, where.all.cases - told->there.cases};
  return fmt::format("{} ({} of such {} fail, else {})", told->words,
                     percent(is_exception(*told) ? others : told->there), of,
                     percent(is_exception(*told) ? told->there : others));
}

std::string in_one_sentence(const std::string& what, const std::string& where) {
  if (where.empty()) {
    return what;
  }
  const bool is_one =
      what.ends_with('.') && what.find(". ") == std::string::npos && what.find(": ") == std::string::npos;
  const char* const comma = where.starts_with("if ") ? "" : ",";
  return is_one ? fmt::format("{}{} {}.", what.substr(0, what.size() - 1), comma, where)
                : fmt::format("{} It happens {}.", what, where);
}

}  // namespace carom::properties::diagnosis
