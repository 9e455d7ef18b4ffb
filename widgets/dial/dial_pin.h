// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/buses.h"
#include "widgets/models/shown_encoder.h"

#include <functional>

namespace codewheel {

class DialPanel;

// Whose dial the panel shows: that of the chosen encoder, or of the one that is pinned, whatever is chosen. A
// pin stays while its encoder is away, and has whatever encoder stands at its place when there is one again.
class DialPin : public QObject
{
    Q_OBJECT

public:
    using StationOf = std::function<QString(Place)>; // what a device is called at the plant

    // `buses` outlive it.
    DialPin(DialPanel &panel, const Buses &buses, StationOf stationOf);

    void follow(const ShownEncoder &chosen);
    // That which is shown; false: the chosen one is followed again.
    void setPinned(bool pinned);
    bool canBePinned() const { return m_pin || m_chosen.isThere(); } // or is
    void showHead();                                                 // stations may be others now
    std::optional<Place> pinned() const;
    // Not by the user: it goes as soon as the encoder does, and is not kept.
    void pinForNow(Place place);
    std::optional<Place> toKeep() const; // what the user has pinned
    void restore(std::optional<Place> kept);

Q_SIGNALS:
    void changed(); // whether it is pinned, or can be

private:
    struct Pin
    {
        Place place;
        bool isForNow = false;
    };

    void followBuses();
    void show();
    QString title() const;

    DialPanel &m_panel;
    const Buses &m_buses;
    const StationOf m_stationOf;
    ShownEncoder m_chosen;
    std::optional<Pin> m_pin;
};

} // namespace codewheel
