// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/master_text.h"
#include "kinds/interbus/ring/ring_refusals.h"
#include "kinds/interbus/ring/snapshot.h"
#include "vocabulary/role.h"

namespace codewheel {

// How the state of the master is marked wherever it is shown.
inline Role masterRole(const Snapshot &ring)
{
    if (ring.state == MasterState::busFail || ring.refusedStart)
        return Role::fault;
    if (ring.master && ring.master->isFaulty())
        return Role::attention;
    return ring.state == MasterState::run ? Role::running : Role::inactive;
}

// Of a fault that stopped the ring, or that a start has met.
inline std::optional<FaultPlace> standstillPlaceOf(const Snapshot &ring)
{
    if (ring.refusedStart)
        return ring.refusedStart->id == RingRefusalId::busFault
                   ? faultPlaceOf(diagnosticParameterOf(ring.refusedStart->arguments))
                   : std::nullopt;
    return ring.master ? ring.master->faultPlace() : std::nullopt;
}

} // namespace codewheel
