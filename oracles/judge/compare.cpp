// SPDX-License-Identifier: GPL-3.0-or-later
#include <carom/oracles/judge/compare.hpp>
#include <carom/oracles/judge/judged_laws.hpp>

namespace carom::oracles {

template Comparison compare(const law::LinearMomentum&, Relation, const ExactCase&, const LiftedOutcome&,
                            const Yardstick&);
template Comparison compare(const law::AngularMomentum&, Relation, const ExactCase&, const LiftedOutcome&,
                            const Yardstick&);
template Comparison compare(const law::TotalAngularMomentum&, Relation, const ExactCase&, const LiftedOutcome&,
                            const Yardstick&);
template Comparison compare(const law::Untouched&, Relation, const ExactCase&, const LiftedOutcome&, const Yardstick&);
template Comparison compare(const law::Restitution&, Relation, const ExactCase&, const LiftedOutcome&,
                            const Yardstick&);
template Comparison compare(const law::NonPenetration&, Relation, const ExactCase&, const LiftedOutcome&,
                            const Yardstick&);
template Comparison compare(const law::Push&, Relation, const ExactCase&, const LiftedOutcome&, const Yardstick&);
template Comparison compare(const law::FrictionlessDirection&, Relation, const ExactCase&, const LiftedOutcome&,
                            const Yardstick&);
template Comparison compare(const law::ReflectionPlane&, Relation, const ExactCase&, const LiftedOutcome&,
                            const Yardstick&);
template Comparison compare(const law::Energy&, Relation, const ExactCase&, const LiftedOutcome&, const Yardstick&);

template std::array<double, 4> slopes_of(const law::LinearMomentum&, const Collision&);
template std::array<double, 4> slopes_of(const law::AngularMomentum&, const Collision&);
template std::array<double, 4> slopes_of(const law::TotalAngularMomentum&, const Collision&);
template std::array<double, 4> slopes_of(const law::Untouched&, const Collision&);
template std::array<double, 4> slopes_of(const law::Restitution&, const Collision&);
template std::array<double, 4> slopes_of(const law::NonPenetration&, const Collision&);
template std::array<double, 4> slopes_of(const law::Push&, const Collision&);
template std::array<double, 4> slopes_of(const law::FrictionlessDirection&, const Collision&);
template std::array<double, 4> slopes_of(const law::ReflectionPlane&, const Collision&);

}  // namespace carom::oracles
