// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/gateway_map.h"
#include "kinds/interbus/gateway/register_port.h"
#include "vocabulary/refusal.h"

namespace codewheel {

// "function 4, registers 0 to 27", for sentences in the user's language.
QString registersText(int function, const RegisterBlock &block);

int readFunction(RegisterArea area);

// The unit answers that it cannot do it yet: it is asked again after a pause.
bool isBusy(const RegisterError &error);
// Whether another try may give a valid answer.
bool isWorthRepeating(const RegisterError &error);

// The unit answers that it has not done it, and does not.
bool isNotCarriedOut(const RegisterError &error);
bool isNotCarriedOut(const Refusal &refusal);

// Why a transaction failed for good. `tries`: how often it was sent.
Refusal registerRefusal(const RegisterError &error, const QString &port, int function,
                        const RegisterBlock &block, int tries);

// The unit answers, but it does not have these registers, or not this function.
bool isOfMap(const RegisterError &error);
bool isOfMap(const Refusal &refusal);

} // namespace codewheel
