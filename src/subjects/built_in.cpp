// SPDX-License-Identifier: BSL-1.0
#include <carom/impulse/frictionless.hpp>
#include <carom/impulse/reflection.hpp>
#include <carom/impulse/reflection_in_basis.hpp>
#include <carom/subjects/catalogue.hpp>
#include <carom/subjects/session.hpp>

namespace carom::subjects {
namespace {

template <class S>
ReportedOutcome reported(const Outcome<S>& outcome) {
  return map_outcome<long double>(outcome, [](S number) { return static_cast<long double>(number); });
}

template <class S>
Matrix3<long double> world_matrix(const Collision& collision) {
  return impulse::collision_matrix(impulse::make_contact<S>(collision)).template cast<long double>();
}

template <class S>
Matrix3<long double> printed_matrix(const Collision& collision) {
  const auto contact = impulse::make_contact<S>(collision);
  const Matrix3<S> basis = impulse::tangent_basis(contact);
  return impulse::printed_collision_matrix(contact, basis).template cast<long double>();
}

template <class S>
std::string_view scalar_name;
template <>
constexpr std::string_view scalar_name<float> = "float";
template <>
constexpr std::string_view scalar_name<double> = "double";
template <>
constexpr std::string_view scalar_name<long double> = "long-double";

/// A solver Contact<S> → Outcome<S> as a subject.
template <class S, class Solver>
Subject solver_subject(std::string name, std::string summary, Model model, Solver solver) {
  Subject subject;
  subject.name = std::move(name) + '-' + std::string(scalar_name<S>);
  subject.summary = std::move(summary);
  subject.model = model;
  subject.precision = precision_of<S>;
  subject.open = [solver] {
    return session_of([solver](const Collision& collision) -> Answer {
      return reported<S>(solver(impulse::make_contact<S>(collision)));
    });
  };
  subject.collision_matrix = world_matrix<S>;
  return subject;
}

template <class S>
void add_in_scalar(std::vector<Subject>& subjects) {
  using impulse::Contact;
  subjects.push_back(solver_subject<S>("frictionless", "impulse along the normal, eq. 18", Model::frictionless,
                                       [](const Contact<S>& contact) { return impulse::frictionless(contact); }));
  subjects.push_back(
      solver_subject<S>("reflection", "basis-free reflection, 3×3 solve by LDLᵀ", Model::reflection,
                        [](const Contact<S>& contact) { return impulse::reflection<impulse::Ldlt>(contact); }));
  subjects.push_back(
      solver_subject<S>("reflection-llt", "basis-free reflection, 3×3 solve by Eigen's LLT", Model::reflection,
                        [](const Contact<S>& contact) { return impulse::reflection<impulse::EigenLlt>(contact); }));
  Subject adjugate =
      solver_subject<S>("reflection-adjugate", "basis-free reflection, 3×3 solve by the adjugate", Model::reflection,
                        [](const Contact<S>& contact) { return impulse::reflection<impulse::Adjugate>(contact); });
  if constexpr (precision_of<S> == Precision::binary32) {
    adjugate.expected_to_pass = false;
    adjugate.summary += "; the determinant under- and overflows from about 1e±12 kg on";
  }
  subjects.push_back(std::move(adjugate));
  Subject in_basis = solver_subject<S>(
      "reflection-in-basis", "reflection in the basis {N, T0, T1} as note §2 prints it; fails near head-on",
      Model::reflection, [](const Contact<S>& contact) { return impulse::reflection_in_basis(contact); });
  in_basis.expected_to_pass = false;
  in_basis.collision_matrix = printed_matrix<S>;
  subjects.push_back(std::move(in_basis));
}

}  // namespace

std::vector<Subject> built_in_subjects() {
  std::vector<Subject> subjects;
  add_in_scalar<float>(subjects);
  add_in_scalar<double>(subjects);
  add_in_scalar<long double>(subjects);
  return subjects;
}

}  // namespace carom::subjects
