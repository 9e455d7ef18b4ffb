// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/recording/replay_at_work.h"
#include "recording/recording_archive.h"

#include <QElapsedTimer>

#include <vector>

namespace codewheel {

class Plant;

// The recordings that are open: each is a Playback and a bus for each recorded one. They are buses of the
// plant like any other until they are closed.
class Recordings : public QObject
{
    Q_OBJECT

public:
    struct Open
    {
        QString file;
        std::shared_ptr<Playback> playback;
        std::vector<std::pair<BusId, BusId>> buses{}; // recorded, and as it is shown
        std::shared_ptr<RecordingArchive> archive{};  // for the trend

        // Of the place in the recording; empty: its bus is none of these.
        std::optional<Place> shown(Place recorded) const;
    };

    // `surroundings` for the buses.
    Recordings(Plant &plant, BusAtWork::Surroundings surroundings);

    // The first of its buses; of a file that is open already, that one. Refused with a sentence if it is no
    // recording, or has no bus.
    Result<BusId> open(const QString &file);
    void close(BusId bus); // with all of its recording
    const std::vector<Open> &all() const { return m_open; }

    // For recordings that play, unless they are driven by hand: by the clock, since the last call.
    void passTime();

Q_SIGNALS:
    void changed(); // opened or closed

private:
    BusId freeId() const;
    void showInTrend(const Open &open);
    void lookAgain();

    Plant &m_plant;
    const BusAtWork::Surroundings m_surroundings;
    std::vector<Open> m_open;
    QElapsedTimer m_sincePassed;
    QElapsedTimer m_sinceLook;
    std::chrono::milliseconds m_betweenLooks; // at files that are being written
};

} // namespace codewheel
