// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/answer.h"
#include "cli/kinds/canopen/object_argument.h"

namespace codewheel {

// Writes an object by hand, in Operate, once, after it was shown with what it has now and asked for; what
// became of it is read back and told.
Checked<Answer> writeObject(const Call &call, const NodeMeant &where, const ObjectArgument &what);

// Why an object was not read or written.
Complaint aboutObjectOutcome(const NodeMeant &where, const ObjectArgument &what,
                             const canopen::SdoOutcome &outcome);
QString objectNameText(const ObjectArgument &what); // "6001h:0 steps"

} // namespace codewheel
