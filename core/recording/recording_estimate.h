// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/buses.h"

#include <set>

namespace codewheel {

class Histories;

// How much room a recording would need, by what encoders have shown lately, and by what passes on the buses
// that are open now from now on. Used by the window before it begins one.
class RecordingEstimate : public QObject
{
    Q_OBJECT

public:
    // Both outlive it.
    RecordingEstimate(Buses &buses, const Histories &histories, QObject *parent = nullptr);

    // Of these encoders, or, if there are none, of all; nothing: none of them has shown anything.
    std::optional<double> bytesPerSecond(const std::set<Place> &places, bool withTraffic) const;

private:
    struct Passed
    {
        Instant since{};
        std::map<Place, std::uint64_t> rows{}; // by device; of the bus itself: without a node
    };

    double trafficBytesPerSecond(const std::set<Place> &places) const;

    Buses &m_buses;
    const Histories &m_histories;
    std::map<BusId, Passed> m_passed;
};

} // namespace codewheel
