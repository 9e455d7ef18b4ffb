// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/lss.h"

namespace codewheel::canopen {

// "node number 5", "store"
QString lssRequestText(const LssFrame &lss);
// "node number taken", "vendor 10Dh"
QString lssAnswerText(const LssFrame &lss);

} // namespace codewheel::canopen
