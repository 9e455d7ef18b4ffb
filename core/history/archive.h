// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "history/history.h"
#include "history/mark.h"
#include "history/shown_channels.h"
#include "history/values_since.h"
#include "vocabulary/place.h"

#include <QObject>

namespace codewheel {

// Histories from another time, such as those of a recording, under places that no other encoder has.
class Archive : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    virtual std::vector<Place> places() const = 0;
    virtual const History *of(Place place, Channel channel) const = 0; // null: it has none of these
    virtual std::optional<TimeSpan> span() const = 0;                  // of all
    virtual std::vector<Mark> marks() const = 0;                       // oldest first
    // Oldest first, as recorded.
    virtual std::vector<ValuesSince> known(Place /*place*/) const { return {}; }
    // How much later than they were all its times are told, so that they lie beside those of others.
    Instant shift() const { return m_shift; }
    void setShift(Instant shift)
    {
        if (std::exchange(m_shift, shift) != shift)
            Q_EMIT changed();
    }
    // Where it is being played, with the shift; nothing: it is not.
    virtual std::optional<Instant> played() const { return {}; }
    // Its encoders are to show this moment, with the shift.
    void askFor(Instant moment) { Q_EMIT asked(moment - m_shift); }

Q_SIGNALS:
    void asked(codewheel::Instant moment);              // as recorded
    void changed();                                     // its times are others, or it has more of them
    void statisticsReady();                             // that were asked for before
    void troubled(const codewheel::Refusal &why) const; // something of it cannot be read

private:
    Instant m_shift{};
};

} // namespace codewheel
