// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/encoder_bus.h"

#include <vector>

namespace codewheel {

// The buses the program works with, connected or not: for whoever deals with any encoder, whatever bus it is
// on. Questions about devices go to the open ones.
class Buses : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    // In the order in which their devices are listed. It stays until it is removed or destroyed.
    void add(EncoderBus &bus);
    void remove(const EncoderBus *bus); // no effect if it is not here
    std::vector<EncoderBus *> open() const;
    EncoderBus *open(BusId bus) const;           // null: it is not open
    std::vector<EncoderBus *> connected() const; // those open that show no recording

    bool isOpening(BusId bus) const;

    std::vector<Place> places() const;
    EncoderBus *busOf(Place place) const; // null: no open bus has it
    bool isConnected(Place place) const { return busOf(place) != nullptr; }
    EncoderSession *encoder(Place place) const; // null: none, or a device without a driver
    WordChannel *channel(Place place) const;    // null: none, or it has no words
    Refusal whyNotThere(Place place) const;     // if there is no device
    // Of the newest snapshot of the bus at the place, otherwise of the first open bus; null: none is open.
    QDateTime now(Place place) const;
    bool hasJob() const; // any of them

    // All that are open, or opening.
    void pump();
    void alarmStop();

Q_SIGNALS:
    void changed();                     // buses added or removed, or another state of one
    void updated(codewheel::BusId bus); // a new snapshot of this one

private:
    bool has(const EncoderBus *bus) const { return std::ranges::find(m_buses, bus) != m_buses.end(); }
    template <typename Call>
    void callEach(Call call);

    std::vector<EncoderBus *> m_buses;
};

} // namespace codewheel
