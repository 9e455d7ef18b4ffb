// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/master_text.h"
#include "kinds/interbus/ring/snapshot.h"
#include "vocabulary/role.h"

namespace codewheel {

// How the state of the master is marked wherever it is shown.
inline Role masterRole(const Snapshot &ring)
{
    if (ring.state == MasterState::busFail)
        return Role::fault;
    if (ring.master && ring.master->isFaulty())
        return Role::attention;
    return ring.state == MasterState::run ? Role::running : Role::inactive;
}

} // namespace codewheel
