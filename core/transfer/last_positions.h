// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/encoder_session.h"
#include "project/project.h"

#include <map>

namespace codewheel {

class BusSession;
class EncoderBus;

// The position an encoder had last.
struct SeenPosition
{
    std::int64_t position = 0; // steps
    QDateTime at;
    bool beforeItWent = false; // the encoder went away (or showed 00000000) after it, and may be another now

    friend bool operator==(const SeenPosition &, const SeenPosition &) = default;
};

// What the encoder shows, to be kept in a project; nothing for one that shows no position, or 00000000, as it
// would without power.
std::optional<LastPosition> positionToKeep(const EncoderSession &encoder);

// Watches where the encoders of a ring stand, so that one that is replaced can be given the position of the
// one before, and so that they are kept with the project. Nothing is sent. An encoder without power shows
// 00000000: after a second of that, or of a bus that stands, it is taken to have gone, and the position
// before is kept until the next time.
class LastPositions : public QObject
{
    Q_OBJECT

public:
    static constexpr std::chrono::milliseconds untilGone{1000};

    explicit LastPositions(EncoderBus &bus, QObject *parent = nullptr);

    // The one to give to a new encoder: that before the encoder went away, if it did.
    std::optional<SeenPosition> at(Place number) const;
    // The newest one, of whichever encoder is there.
    std::optional<SeenPosition> newest(Place number) const;

private:
    struct Seen // a date and time is made of it when somebody asks
    {
        std::int64_t position = 0; // steps
        Instant at{};
        bool beforeItWent = false;
    };
    struct Watched
    {
        std::optional<Seen> last;       // not 00000000
        std::optional<Seen> beforeGone; // of the encoder that was there then
        Instant lastAt{};
    };

    void look();
    std::optional<SeenPosition> dated(const std::optional<Seen> &seen) const;

    EncoderBus &m_bus;
    std::map<Place, Watched> m_watched;
};

// The project as it is to be saved: with the newest position of each encoder that stands where it has one.
Project withLastPositions(Project project, const LastPositions &positions, const BusSession &bus);

} // namespace codewheel
