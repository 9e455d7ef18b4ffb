// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "replay/recorded_encoder.h"

#include <QDateTime>
#include <QObject>

namespace codewheel {

// An open recording, and the moment of it that is shown; all its buses (ReplayBus) share one. Time passes by
// advance(): whoever shows the recording calls it. Used by the window and by the command line.
class Playback : public QObject
{
    Q_OBJECT

public:
    enum class Direction { forward, backward };

    // At its beginning, paused.
    static Result<std::unique_ptr<Playback>> open(const QString &file);

    const QString &file() const { return m_reader.file(); }
    const RecordingReader &reader() const { return m_reader; }
    const RecordingHead &head() const { return m_head; } // when it was looked at last
    // When the file was written to last, as of then.
    const QDateTime &lookedAt() const { return m_lookedAt; }
    const std::vector<RecordedBus> &buses() const { return m_buses; }
    std::vector<RecordedEncoder> &encoders() { return m_encoders; }
    // From the first moment to the last one, which can be shown both.
    const TimeSpan &span() const { return m_span; }
    Instant position() const { return m_position; }
    // What the clock of the computer said then.
    QDateTime dateTime(Instant at) const;
    // Rises whenever the position has moved otherwise than forward, by playing or step by step: what was
    // passed before is not what comes before it.
    int jumps() const { return m_jumps; }

    bool isPlaying() const { return m_isPlaying; }
    Direction direction() const { return m_direction; }
    double factor() const { return m_factor; } // how much faster than it was; above 0
    void setFactor(double factor);
    // From an end, away from it, as if it were the other one.
    void play(Direction direction);
    void pause();
    void advance(Instant elapsed); // pauses at the end
    void jumpTo(Instant at);       // within the span
    // Pauses, and goes to the next or the previous sample of the encoder at that place of the recording, or
    // of all. False: there is none.
    bool step(Direction direction, std::optional<Place> of = {});
    // Of a recording that is still being written: what came since. Its devices stay those it had.
    void lookAgain();

    // Why something could not be read; nothing: all could be.
    std::optional<Refusal> problem() const;

Q_SIGNALS:
    void positionChanged();
    void stateChanged(); // playing or not, direction, factor, span

private:
    explicit Playback(RecordingReader reader)
        : m_reader(std::move(reader))
    {}
    Result<void> read();
    void moveTo(Instant at);
    bool isAtEnd(Direction direction) const;

    RecordingReader m_reader;
    RecordingHead m_head;
    WallClock m_clock;
    QDateTime m_lookedAt; // by the clock of the file's disk
    std::vector<RecordedBus> m_buses;
    std::vector<RecordedEncoder> m_encoders;
    TimeSpan m_span;
    Instant m_position{};
    bool m_isPlaying = false;
    Direction m_direction = Direction::forward;
    double m_factor = 1;
    int m_jumps = 0;
};

} // namespace codewheel
