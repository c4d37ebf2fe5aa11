// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <carom/oracles/filters/refined_truth.hpp>
#include <carom/oracles/models/models.hpp>

namespace carom::oracles {

Approximation approximation_of(const Enclosure& x) {
  return (Approximation(x.middle()) + Approximation(x.lower_part())).widened_by(x.radius());
}

Enclosure enclosure_of(const Approximation& x) { return Enclosure(x.middle()).widened_by(x.radius()); }

ApproximateResponse::ApproximateResponse(const BasicCollision<Approximation>& collision)
    : units(unit_responses(collision)), matrix(response_matrix<Approximation>(collision, units)) {}

Outcome<Approximation> ApproximateResponse::operator()(const Vector3<Approximation>& impulse) const {
  Outcome<Approximation> answer;
  const auto into = vectors(answer);
  for (const OutcomeVector k : all_outcome_vectors) {
    *into[k] =
        *vectors(units[0])[k] * impulse[0] + *vectors(units[1])[k] * impulse[1] + *vectors(units[2])[k] * impulse[2];
  }
  return answer;
}

namespace {

struct Arithmetics {
  const Collision& rounded;
  const BasicCollision<Enclosure>& enclosed;
  const BasicCollision<Approximation>& approximate;
  const ApproximateResponse& response;
};

/// The impulse by which a linear law causes the change `wanted` of relative velocity. The outcome contains the velocity
/// changes by this impulse.
template <class LawType>
Truth<Enclosure> refined(const Arithmetics& of, const Vector3<Enclosure>& wanted) {
  const auto middle = [](const auto& x) { return x.middle(); };
  const Matrix3<double> matrix = of.response.matrix.unaryExpr(middle);
  const Vector3<double> first = LawType::template impulse_for<double>(of.rounded, wanted.unaryExpr(middle), &matrix);
  const Vector3<Enclosure> impulse = LawType::permitted(of.enclosed, first);
  const Outcome<Enclosure> answer = response<Enclosure>(of.enclosed, impulse);
  const Vector3<Enclosure> rest =
      LawType::asked_for(of.enclosed.normal, wanted - relative_velocity<Enclosure>(of.enclosed, answer));
  const Vector3<Approximation> second = LawType::template impulse_for<Approximation>(
      of.approximate, rest.unaryExpr(&approximation_of), &of.response.matrix);
  const Outcome<Enclosure> correction = map_outcome<Enclosure>(of.response(second), &enclosure_of);
  return {impulse + second.unaryExpr(&enclosure_of), sum(answer, correction)};
}

}  // namespace

Truth<Enclosure> refined_truth(const Collision& collision, const BasicCollision<Enclosure>& enclosed,
                               const BasicCollision<Approximation>& approximate, Law law, Branch branch,
                               const ApproximateResponse& approximate_response) {
  const Arithmetics of{collision, enclosed, approximate, approximate_response};
  Truth<Enclosure> truth = with_law(law, branch, [&]<class LawType>(LawType) -> Truth<Enclosure> {
    if constexpr (LinearLaw<LawType>) {
      return refined<LawType>(of, wanted_change<LawType>(enclosed));
    } else {
      const Vector3<Enclosure> stop = -relative_velocity<Enclosure>(enclosed, unchanged(enclosed));
      const Truth<Enclosure> approach = refined<typename LawType::StopsApproach>(of, stop);
      const Truth<Enclosure> point = refined<typename LawType::StopsPoint>(of, stop);
      const Vector3<Enclosure> d = point.impulse - approach.impulse;
      const Enclosure share = LawType::template friction_share<Enclosure>(enclosed, approach.impulse, d, branch);
      Truth<Enclosure> result{LawType::template combined<Enclosure>(enclosed, approach.impulse, d, share), {}};
      const auto into = vectors(result.outcome);
      for (const OutcomeVector k : all_outcome_vectors) {
        const Vector3<Enclosure>& by_approach = *vectors(approach.outcome)[k];
        *into[k] = LawType::template combined<Enclosure>(
            enclosed, by_approach, Vector3<Enclosure>(*vectors(point.outcome)[k] - by_approach), share);
      }
      return result;
    }
  });
  truth.outcome = sum(unchanged(enclosed), truth.outcome);
  return truth;
}

bool is_bounded(const Truth<Enclosure>& truth) {
  bool bounded = true;
  for (const Vector3<Enclosure>* vector : vectors(truth.outcome)) {
    for (int i = 0; i < 3; ++i) {
      bounded = bounded && std::isfinite((*vector)[i].radius());
    }
  }
  return bounded;
}

}  // namespace carom::oracles
