// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/buses.h"
#include "history/encoder_history.h"
#include "history/mark.h"

#include <QPointer>

#include <deque>
#include <map>

namespace codewheel {

// The histories of all encoders there are, on whatever bus, as far back as the memory goes that they may take
// together; then the oldest of all is forgotten. And what happened meanwhile.
class Histories : public QObject
{
    Q_OBJECT

public:
    static constexpr std::size_t usualLimit = std::size_t{256} << 20; // bytes
    static constexpr std::size_t mostMarks = 10'000;

    explicit Histories(Buses &buses, QObject *parent = nullptr);

    std::vector<Place> places() const; // that have one
    // Null: nothing was ever shown there. What is kept stays when its bus is closed.
    const EncoderHistory *of(Place place) const;
    std::optional<TimeSpan> span() const;                     // of all
    const std::deque<Mark> &marks() const { return m_marks; } // oldest first
    // What the user notes; an empty text removes the note of that moment.
    void note(Instant at, const QString &text);

    std::size_t bytes() const;
    std::size_t limit() const { return m_limit; }
    // The newest some thousand samples of each are kept in any case.
    void setLimit(std::size_t bytes);
    // How far back it will go once it is full, if all goes on as it did lately; nothing: nothing comes.
    std::optional<Instant> reach() const;
    // Cycles and answers that came faster than they were taken; there are gaps in their place.
    std::uint64_t dropped() const { return m_dropped; }

Q_SIGNALS:
    void placesChanged();
    void moved(codewheel::Place from, codewheel::Place to); // an encoder, with its history
    void marksChanged();
    void droppedChanged();

private:
    struct Watched
    {
        QPointer<EncoderSession> encoder;
        EncoderHistory history;
    };

    void watchAll();
    void watch(Place place, EncoderSession &encoder);
    void add(const EncoderSession &encoder, const ShownSeries &shown);
    void watch(EncoderBus &bus);
    void addMessage(const codewheel::Message &message);
    void addDropped(std::uint64_t count);
    void insert(const Mark &mark);
    void keepLimit();

    Buses &m_buses;
    std::map<Place, Watched> m_watched;
    std::deque<Mark> m_marks;
    std::size_t m_limit = usualLimit;
    std::uint64_t m_dropped = 0;
};

} // namespace codewheel
