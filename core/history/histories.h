// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/buses.h"
#include "history/archive.h"
#include "history/encoder_history.h"
#include "history/mark.h"
#include "history/step_scale.h"

#include <QPointer>

#include <deque>
#include <map>

namespace codewheel {

// The histories of all encoders there are, on whatever bus, as far back as the memory goes that they may take
// together; then the oldest of all is forgotten. And what happened meanwhile. Archives stand beside them.
class Histories : public QObject
{
    Q_OBJECT

public:
    static constexpr std::size_t usualLimit = std::size_t{256} << 20; // bytes
    static constexpr std::size_t mostMarks = 10'000;

    explicit Histories(Buses &buses, QObject *parent = nullptr);

    std::vector<Place> places() const; // that have one, here or in an archive
    // Null: nothing was ever shown there. What is kept stays when its bus is closed.
    const EncoderHistory *of(Place place) const; // here
    const History *of(Place place, Channel channel) const;
    // What its steps were, with the shift of an archive. Empty: not known.
    std::vector<ScaleSince> scales(Place place) const;
    // The values that these follow from, and what else was known meanwhile; of an archive all, as recorded.
    std::vector<ValuesSince> known(Place place) const;
    std::optional<TimeSpan> span() const; // of all that are here
    // Oldest first, with those of the archives.
    const std::deque<Mark> &marks() const { return m_archives.empty() ? m_ownMarks : m_mixedMarks; }
    // What the user notes; an empty text removes the note of that moment.
    void note(Instant at, const QString &text);

    // It is here until it is destroyed.
    void add(Archive &archive);
    Archive *archiveOf(Place place) const; // null: it is in none
    const std::vector<Archive *> &archives() const { return m_archives; }

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
    void archivesChanged(); // added, removed, or another shift of one
    void statisticsReady(); // of an archive
    void archiveTroubled(const codewheel::Refusal &why);
    void moved(codewheel::Place from, codewheel::Place to); // an encoder, with its history
    void marksChanged();                                    // soon; marks() are there at once
    void noted(codewheel::Instant at, const QString &text); // by note()

private:
    struct Watched
    {
        QPointer<EncoderSession> encoder;
        EncoderHistory history;
        ScaleHistory scales;
    };

    void watchAll();
    void watch(Place place, EncoderSession &encoder);
    Watched *watched(const EncoderSession &encoder);
    void add(const EncoderSession &encoder, const ShownSeries &shown);
    void takeScale(const EncoderSession &encoder);
    void watch(EncoderBus &bus);
    void addMessage(const codewheel::Message &message);
    void addDropped(std::uint64_t count) { m_dropped += count; }
    void remove(const QObject *archive);
    void insert(const Mark &mark);
    void tellMarks();
    void mixMarks();
    void takeArchives();
    void keepLimit();

    Buses &m_buses;
    std::map<Place, Watched> m_watched;
    std::vector<Archive *> m_archives;
    std::deque<Mark> m_ownMarks;
    std::deque<Mark> m_mixedMarks; // with those of the archives, if there are any
    std::size_t m_limit = usualLimit;
    std::uint64_t m_dropped = 0;
    bool m_marksAreToTell = false;
};

} // namespace codewheel
