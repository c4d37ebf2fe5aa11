// SPDX-License-Identifier: BSL-1.0
#include <carom/conformance.hpp>

#include "textbook.hpp"

CAROM_CONFORMANCE(Textbook, carom::conformance::subject("textbook", carom::Law::frictionless, textbook));
