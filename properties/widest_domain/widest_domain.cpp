// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <carom/collision/expects.hpp>
#include <carom/properties/cases/draw_within.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/properties/widest_domain/widest_domain.hpp>

namespace carom::properties {

KeptSessions::KeptSessions(const Subject& subject)
    : subject_(subject), open_(subject.open), idle_(std::make_shared<std::deque<std::shared_ptr<Kept>>>()) {
  subject_.open = [this] { return take(); };
}

Session KeptSessions::take() {
  constexpr std::size_t most_idle = 2;
  std::shared_ptr<Kept> kept;
  if (idle_->size() < most_idle) {
    kept = std::make_shared<Kept>(Kept{open_()});
  } else {
    kept = std::move(idle_->front());
    idle_->pop_front();
  }
  return {[kept](std::span<const Collision> collisions) {
            try {
              return kept->session(collisions);
            } catch (...) {
              kept->has_failed = true;
              throw;
            }
          },
          [kept, idle = idle_] {
            if (!kept->has_failed) {
              idle->push_back(kept);
            }
          }};
}

namespace {

/// A value as a number that the search halves: its logarithm, or the value itself.
double on_scale(LimitedQuantity quantity, double value) { return is_linear(quantity) ? value : std::log10(value); }
/// Rounded to three digits, so that the value does not depend on how a machine rounds logarithms.
double from_scale(LimitedQuantity quantity, double scaled) {
  const double value = is_linear(quantity) ? scaled : std::pow(10.0, scaled);
  return std::strtod(fmt::format("{:.3g}", value).c_str(), nullptr);
}
/// The search ends if its interval is this narrow: 0.01 of a coefficient, 2 % of another quantity.
constexpr double resolution = 0.01;
/// The first step of a search.
double first_step(LimitedQuantity quantity) { return is_linear(quantity) ? 0.25 : 1; }

/// Widens the quantities without which `quantity` cannot be x, but not beyond the faces that are known.
void make_room(Domain& domain, const std::vector<Face>& known, LimitedQuantity quantity, double x) {
  const auto widen = [&](LimitedQuantity of, double least, double most) {
    for (const Face& face : known) {
      if (face.quantity == of) {
        (face.is_upper ? most : least) = face.is_upper ? std::min(most, face.end) : std::max(least, face.end);
      }
    }
    Range& range = domain.ranges[of];
    range = {std::min(range.least, least), std::max(range.most, most)};
  };
  const Range& mass = domain.ranges[LimitedQuantity::mass];
  const Range& size = domain.ranges[LimitedQuantity::size];
  const Range& approach = domain.ranges[LimitedQuantity::approach];
  switch (quantity) {
    case LimitedQuantity::mass_ratio:
      widen(LimitedQuantity::mass, mass.least, mass.most * x);
      break;
    case LimitedQuantity::size_ratio:
      widen(LimitedQuantity::size, size.least, size.most * x);
      break;
    case LimitedQuantity::speed:
      widen(LimitedQuantity::approach, x / 4, approach.most);
      break;
    case LimitedQuantity::approach:
      widen(LimitedQuantity::speed, x / 8, x * 4);
      break;
    case LimitedQuantity::size:
    case LimitedQuantity::mass:
    case LimitedQuantity::moment_ratio:
    case LimitedQuantity::spin:
    case LimitedQuantity::distance:
    case LimitedQuantity::restitution:
    case LimitedQuantity::friction:
    case LimitedQuantity::tangential_restitution:
      break;
  }
}

/// A result without cases does not fail: no collision lies in its domain.
bool fails(const SubjectResult& result) {
  return !result.error.empty() || !result.violated_invariants().empty() || !result.not_judged.empty();
}

class Search {
 public:
  Search(const Subject& subject, const WidestDomainOptions& options, const oracles::Limits& limits)
      : subject_(&subject), options_(&options), limits_(limits) {
    if (subject.is_program()) {
      kept_.emplace(subject);
    }
  }

  /// The gate's result for the subject in this domain.
  [[nodiscard]] SubjectResult judged(const Domain& domain, std::uint64_t seed, std::uint64_t cases,
                                     bool shrinks) const {
    return judged(*subject_, options_->workers, domain, seed, cases, shrinks);
  }

  /// Whether the subject holds where the quantity is about x. A domain without cases shows no violation.
  [[nodiscard]] bool holds_at(const std::vector<Face>& known, LimitedQuantity quantity, double x) const {
    return !fails(judged_in_slab(slab(known, quantity, x), false));
  }

  [[nodiscard]] Face face(const std::vector<Face>& known, LimitedQuantity quantity, bool is_upper) const {
    const Range& core = options_->core.ranges[quantity];
    const Range end = searched_range(quantity);
    // A core may end at 0, or beyond the ends of the search.
    const double first = on_scale(quantity, is_upper ? std::max(core.most, end.least) : core.least);
    const double last =
        is_upper ? std::max(first, on_scale(quantity, end.most)) : std::min(first, on_scale(quantity, end.least));
    const double direction = is_upper ? 1 : -1;
    double held = first;
    double failed = held;
    while (direction * (last - held) > 0) {
      const double next = direction * std::min(direction * (held + direction * first_step(quantity)), direction * last);
      if (!holds_at(known, quantity, from_scale(quantity, next))) {
        failed = next;
        break;
      }
      held = next;
    }
    Face result{quantity, is_upper};
    if (failed == first) {
      result.end = is_upper ? std::max(core.most, end.most) : std::min(core.least, end.least);
      return result;
    }
    while (std::abs(failed - held) > resolution) {
      const double middle = held + (failed - held) / 2;
      (holds_at(known, quantity, from_scale(quantity, middle)) ? held : failed) = middle;
    }
    result.end = held == first ? (is_upper ? core.most : core.least) : from_scale(quantity, held);
    const SubjectResult beyond = judged_in_slab(slab(known, quantity, from_scale(quantity, failed)), true);
    if (!beyond.witnesses.empty()) {
      result.beyond = beyond.witnesses.front();
    }
    result.error = beyond.error.empty() ? beyond.not_judged : beyond.error;
    return result;
  }

 private:
  [[nodiscard]] SubjectResult judged(const Subject& subject, const Workers& workers, const Domain& domain,
                                     std::uint64_t seed, std::uint64_t cases, bool shrinks) const {
    GateOptions options;
    options.seed = seed;
    options.cases = cases;
    options.within = domain;
    options.limits = limits_;
    options.workers = workers;
    options.fail_fast = true;
    options.shrinks = shrinks;
    options.is_part = true;
    options.stop = options_->stop;
    for (const Family& family : all_families()) {
      if (family.is_valid && has_cases_within(domain, family, options.seed)) {
        options.families.push_back(&family);
      }
    }
    if (options.families.empty()) {
      return {};
    }
    GateReport report = run_gate({subject}, options);
    if (report.judge_error) {
      throw *report.judge_error;
    }
    return std::move(report.results.at(0));
  }

  /// The gate's result for few cases. A kept session belongs to this thread, so this thread alone asks a program.
  [[nodiscard]] SubjectResult judged_in_slab(const Domain& domain, bool shrinks) const {
    const Subject& subject = kept_ ? kept_->subject() : *subject_;
    const Workers workers = kept_ ? Workers() : options_->workers;
    return judged(subject, workers, domain, options_->seed, options_->cases_of_slab, shrinks);
  }

  /// The core, with the quantity near x.
  [[nodiscard]] Domain slab(const std::vector<Face>& known, LimitedQuantity quantity, double x) const {
    Domain domain = options_->core;
    make_room(domain, known, quantity, x);
    const Range whole = whole_range(quantity);
    const double width = is_linear(quantity) ? 0.01 : x / 20;
    domain.ranges[quantity] = {std::max(whole.least, x - width), std::min(whole.most, x + width)};
    return domain;
  }

  const Subject* subject_;
  const WidestDomainOptions* options_;
  oracles::Limits limits_;
  std::optional<KeptSessions> kept_;  // of a program
};

/// An error "interrupted" says that a stop was requested.
Ends searched_ends(const Search& search, const WidestDomainOptions& options) {
  const Ends interrupted{{}, "interrupted"};
  const SubjectResult in_core = search.judged(options.core, options.seed, options.cases_of_box, true);
  if (options.stop.stop_requested()) {
    return interrupted;
  }
  Ends ends;
  ends.cases_of_core = in_core.cases();
  ends.unjudged_of_core = in_core.unjudged();
  if (fails(in_core)) {
    ends.error = in_core.error.empty() ? in_core.not_judged : in_core.error;
    if (!in_core.witnesses.empty()) {
      ends.in_core = in_core.witnesses.front();
    }
    return ends;
  }
  for (const LimitedQuantity quantity : all_limited_quantities) {
    for (const bool is_upper : {false, true}) {
      const Range& core = options.core.ranges[quantity];
      const Range whole = whole_range(quantity);
      if (is_upper ? core.most < whole.most : core.least > whole.least) {
        ends.faces.push_back(search.face(ends.faces, quantity, is_upper));
      }
      if (options.stop.stop_requested()) {
        return interrupted;
      }
    }
  }
  return ends;
}

/// The end of a range, this share of the way from the core's end to the face's.
double between(LimitedQuantity quantity, double core, double face, double share) {
  const double from = on_scale(quantity, std::max(core, searched_range(quantity).least));
  return share == 1 ? face : from_scale(quantity, from + share * (on_scale(quantity, face) - from));
}

Domain domain_at(const Domain& core, const std::vector<Face>& faces, double share) {
  Domain domain = core;
  for (const Face& face : faces) {
    Range& range = domain.ranges[face.quantity];
    double& end = face.is_upper ? range.most : range.least;
    end = between(face.quantity, end, face.end, share);
  }
  return domain;
}

}  // namespace

Domain default_core() {
  return domain_from(
      "size=0.5:2,mass=0.5:2,mass_ratio=:2,moment_ratio=:2,size_ratio=:2,speed=4:16,approach=4:32,spin=:2,distance=:4,"
      "restitution=0.25:0.75,friction=:0.75,tangential_restitution=0:0.5");
}

bool is_linear(LimitedQuantity quantity) {
  return quantity == LimitedQuantity::restitution || quantity == LimitedQuantity::tangential_restitution;
}

Range searched_range(LimitedQuantity quantity) {
  if (is_linear(quantity)) {
    return whole_range(quantity);
  }
  // Features draw these decades, so a search does not leave what the gate poses. A bar that reaches an end says only
  // that the search ended there.
  constexpr double smallest = 1e-9;
  constexpr double largest = 1e9;
  constexpr double most_slender = 1e8;
  return {std::max(smallest, whole_range(quantity).least),
          quantity == LimitedQuantity::moment_ratio ? most_slender : largest};
}

Range range_of(const Ends& ends, const Domain& core, LimitedQuantity quantity) {
  return domain_at(core, ends.faces, 1).ranges[quantity];
}

WidestDomain measured_widest_domain(const Subject& subject, const WidestDomainOptions& options) {
  CAROM_EXPECTS(has_cases_within(options.core, *family_named("generic"), options.seed), to_text(options.core));
  const Search search(subject, options, options.limits);
  const WidestDomain interrupted{{{}, "interrupted"}, {}, options.core};
  WidestDomain widest;
  widest.domain = options.core;
  widest.ends = searched_ends(search, options);
  widest.cases = widest.ends.cases_of_core;
  widest.unjudged = widest.ends.unjudged_of_core;
  if (!widest.ends.error.empty() || widest.ends.in_core) {
    return widest;
  }
  double held = 0;
  double failed = 1;
  std::uint64_t seed = options.seed;  // each domain gets fresh cases
  constexpr double narrowest = 1.0 / 64;
  for (double share = 1; failed - held > narrowest; share = held + (failed - held) / 2) {
    const Domain domain = domain_at(options.core, widest.ends.faces, share);
    const SubjectResult result = search.judged(domain, ++seed, options.cases_of_box, false);
    if (options.stop.stop_requested()) {
      return interrupted;
    }
    if (fails(result)) {
      failed = share;
      continue;
    }
    held = share;
    widest.domain = domain;
    widest.cases = result.cases();
    widest.unjudged = result.unjudged();
    if (share == 1) {
      break;
    }
  }
  widest.share = held;
  if (options.stricter) {
    widest.stricter = searched_ends(Search(subject, options, *options.stricter), options);
  }
  if (options.stop.stop_requested()) {
    return interrupted;
  }
  return widest;
}

}  // namespace carom::properties
