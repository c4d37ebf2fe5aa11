// SPDX-License-Identifier: BSL-1.0
#include <carom/impulse/frictionless.hpp>
#include <carom/impulse/guaranteed.hpp>
#include <carom/impulse/reflection.hpp>
#include <carom/subjects/methods/groups.hpp>
#include <carom/subjects/methods/solver_method.hpp>

namespace carom::subjects {
namespace {

struct Posed {
  Collision collision;
  impulse::Contact<double> contact;
};

template <class Law>
Method guaranteed_method(Claim claim, Law law) {
  return method_of<double>(
      std::move(claim),
      [](const Collision& collision) {
        return Posed{collision, impulse::make_contact<double>(collision)};
      },
      [law](const Posed& posed) { return impulse::guaranteed(posed.collision, posed.contact, law); });
}

}  // namespace

std::vector<Method> guaranteed_methods() {
  using Contact = impulse::Contact<double>;
  return {guaranteed_method({"frictionless-guaranteed", "impulse along the normal, the exact N·V⁺ never negative",
                             Model::frictionless},
                            [](const Contact& contact) { return impulse::frictionless(contact); }),
          guaranteed_method({"reflection-guaranteed", "basis-free reflection by LDLᵀ, the exact N·V⁺ never negative",
                             Model::reflection},
                            [](const Contact& contact) { return impulse::reflection<impulse::Ldlt>(contact); })};
}

}  // namespace carom::subjects
