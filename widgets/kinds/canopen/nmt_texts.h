// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/nmt.h"

#include <span>

namespace codewheel {

// A command to a node, as a button has it and as it is asked about.
struct NmtAction
{
    canopen::NmtCommand command;
    const char *key; // "nmtStart"
    const char *itsLabel;
    const char *itsToolTip;
    const char *itsQuestion;

    QString label() const;
    QString toolTip() const;
    QString question(int node) const; // "Stop node 5 (05h)?", and what follows
};
std::span<const NmtAction> nmtActions();
const NmtAction &nmtAction(canopen::NmtCommand command); // one that there is

} // namespace codewheel
