// SPDX-License-Identifier: GPL-3.0-or-later
#include <carom/conformance.hpp>

#include "textbook.hpp"

CAROM_CONFORMANCE(Textbook, carom::conformance::subject("textbook", carom::Model::frictionless, textbook));
