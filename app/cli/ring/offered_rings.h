// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/subcommand.h"
#include "modbus/served_units.h"
#include "training_session.h"

#include <memory>
#include <vector>

namespace codewheel {

// The simulated rings that serve offers: in real time, in RUN and in Operate, with the fault plan of the
// call.
class OfferedRings
{
public:
    struct Ring
    {
        QString name;
        TrainingSession training;
        std::shared_ptr<RingGuests> guests = std::make_shared<RingGuests>();
    };

    // The training ring; the rings of the project that are linked to a simulated one; or one ring for each
    // seat.
    static Checked<OfferedRings> of(const Call &call);

    // From now on the cycles pass, each in its millisecond.
    void start();
    void pump();
    // One ring to all units, several to the units from 1 on.
    ServedUnits units(ServedUnits::Writing writing) const;
    const std::vector<Ring> &rings() const { return m_rings; }

private:
    std::vector<Ring> m_rings;
};

} // namespace codewheel
