// SPDX-License-Identifier: BSL-1.0
#include <carom/conformance.hpp>

#include "textbook.hpp"

/// The textbook's solver with a defect: it adds the restitution twice.
struct Mutant {
  carom::Outcome<double> operator()(carom::impulse::Contact<double> contact) const {
    contact.restitution += contact.restitution;
    return textbook(contact);
  }
};

CAROM_CONFORMANCE(Mutant, carom::conformance::subject("mutant", carom::Law::frictionless, Mutant{}),
                  carom::conformance::Options{.families = {"generic", "inelastic"}});
