// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/served_units.h"
#include "training_session.h"

#include <memory>
#include <vector>

namespace codewheel {

// Simulated rings that are offered to others, and that nobody else works with: in real time, in RUN and in
// Operate, each with a thread of its own. Used by serve, and by the window for a class in which each seat has
// a ring of its own.
class OfferedRings
{
public:
    struct Ring
    {
        QString name;
        TrainingSession training;
        std::shared_ptr<RingGuests> guests = std::make_shared<RingGuests>();
    };

    void add(const QString &name, TrainingSession training)
    {
        m_rings.push_back({name, std::move(training)});
    }
    const std::vector<Ring> &rings() const { return m_rings; }

    // From now on the cycles pass, each in its millisecond.
    void start();
    void pump();
    // Instead of that ring, for the same guests; it starts.
    void replace(std::size_t ring, TrainingSession training);
    // The units from 1 on, in this order.
    ServedUnits units(ServedUnits::Writing writing) const;

private:
    static void start(Ring &ring);

    std::vector<Ring> m_rings;
};

} // namespace codewheel
