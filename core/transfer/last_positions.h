// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/encoder_session.h"
#include "project/project.h"

#include <map>

namespace codewheel {

class Buses;
class EncoderBus;

// The position an encoder had last.
struct SeenPosition
{
    std::int64_t position = 0; // steps
    QDateTime at;
    bool beforeItWent = false; // then the encoder went away (or showed 00000000), and may be another now

    friend bool operator==(const SeenPosition &, const SeenPosition &) = default;
};

// What the encoder shows, to be kept in a project; empty if it shows no position.
std::optional<LastPosition> positionToKeep(const EncoderSession &encoder);

// Watches the positions of the encoders of all buses, so that a replacement can be given the position of the
// encoder it replaces, and so that they are kept with the project. Nothing is sent. After a second without a
// position (in a ring an encoder without power shows 00000000, on a serial line it is silent), or on a bus
// that is stopped, it is assumed to be gone, and its last position is kept until the next time.
class LastPositions : public QObject
{
    Q_OBJECT

public:
    static constexpr std::chrono::milliseconds untilGone{1000};

    explicit LastPositions(const Buses &buses, QObject *parent = nullptr);

    // The one to give to a new encoder: the position before the encoder went away, if it did.
    std::optional<SeenPosition> at(Place number) const;
    // The newest one, of whichever encoder is there.
    std::optional<SeenPosition> newest(Place number) const;

private:
    struct Watched
    {
        std::optional<SeenPosition> last;
        std::optional<SeenPosition> beforeGone; // of the encoder that was there then
        Instant lastAt{};                       // of its bus, starting from 0 when it is connected again
    };

    void look(const EncoderBus &bus);

    const Buses &m_buses;
    std::map<Place, Watched> m_watched;
};

// The project as it is to be saved: with the newest position of each encoder that is where the project has
// it.
Project withLastPositions(Project project, const LastPositions &positions, const Buses &buses);

} // namespace codewheel
