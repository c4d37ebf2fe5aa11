// SPDX-License-Identifier: GPL-3.0-or-later
#include <carom/oracles/compare.hpp>
#include <carom/oracles/judged_laws.hpp>

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

}  // namespace carom::oracles
