// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "history/track.h"

#include <QObject>
#include <QStringList>

#include <map>
#include <set>
#include <vector>

namespace codewheel {

// Which curves a trend shows, in which unit, and on whose axis. Kept from one start to the next.
class TrendTracks : public QObject
{
    Q_OBJECT

public:
    static constexpr std::size_t most = 32;

    struct Shown
    {
        Track track;
        TrackUnit unit = TrackUnit::steps;
        bool sharesAxis = false; // with the one above, if that has the same unit

        friend bool operator==(const Shown &, const Shown &) = default;
    };

    using QObject::QObject;

    const std::vector<Shown> &shown() const { return m_shown; }
    std::optional<std::size_t> find(const Track &track) const;
    // At the end, in the unit of the last one of its encoder and kind; false: there is no room for more. One
    // that is already shown stays where it is.
    bool add(const Track &track);
    void remove(std::size_t index);
    void move(std::size_t index, std::size_t to);
    void encoderMoved(Place from, Place to);
    void setUnit(std::size_t index, TrackUnit unit);
    void shareAxis(std::size_t index, bool shares);
    // Of a shaft, where the user has said so: millimetres per turn.
    std::optional<double> travel(Place place) const;
    void setTravel(Place place, double millimetres);

    // Curves of these buses go with them, such as those of recordings.
    void setPassing(const std::set<BusId> &buses);

    QStringList state() const; // to be kept
    // Ignores what it cannot read, and curves of a bus that has passed since.
    void restore(const QStringList &state);

Q_SIGNALS:
    void changed();

private:
    std::vector<Shown> m_shown;
    std::map<Place, double> m_travel;
    std::set<BusId> m_passing;
};

// Whether these two may have one axis: numbers of one kind and unit.
bool canShareAxis(const TrendTracks::Shown &one, const TrendTracks::Shown &other);

} // namespace codewheel
