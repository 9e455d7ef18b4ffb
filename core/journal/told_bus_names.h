// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/place.h"

#include <map>

namespace codewheel {

// What buses were called when something was told of them, while the program runs: another project may give
// their numbers to others. What was told before the program started has the names of now, since only the
// number of its bus is kept. Used by the list of messages.
class ToldBusNames
{
public:
    // Something is told of this bus.
    void note(BusId bus, qint64 at); // ms since 1970, UTC
    // As placeName(), with the name of then.
    QString placeName(const std::optional<Place> &place, qint64 at) const;

private:
    struct Names
    {
        QString amongOthers; // empty: no other bus has the same places
        QString ofBus;

        friend bool operator==(const Names &, const Names &) = default;
    };

    const Names *namesAt(BusId bus, qint64 at) const; // null: nothing was told of it until then

    std::map<BusId, std::map<qint64, Names>> m_names; // since when
};

} // namespace codewheel
