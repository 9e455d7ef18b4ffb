// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/bus_feed.h"
#include "recording/recording_target.h"
#include "recording/recording_trigger.h"

namespace codewheel {

class Histories;

// What is recorded, and when.
struct RecordingPlan
{
    RecordingSettings settings;
    std::set<Place> places{};                  // empty: all encoders
    bool withTraffic = true;                   // requests, answers and words as they pass
    std::optional<RecordingTrigger> trigger{}; // nothing: at once
    RecordingExtent extent{};                  // around the trigger, or the beginning
};

// Records what the encoders of all buses show: at once, or when something happens, with what was before,
// until it is ended or the time is over. Used by window and command line, in their thread.
class BusRecorder : public QObject
{
    Q_OBJECT

public:
    enum class State { waiting, recording, ended };

    // The file, or the recording on the server, is made at once, so that what is wrong with it is known
    // before anything happens.
    static Result<std::unique_ptr<BusRecorder>> begin(Buses &buses, const Histories &histories,
                                                      const RecordingPlan &plan,
                                                      const BusFeed::WallClockNow &now);

    State state() const { return m_state; }
    const RecordingPlan &plan() const { return m_plan; }
    // What is recorded, as far as it is known; nothing: it waits, or nothing has come as yet.
    const std::optional<TimeSpan> &span() const { return m_span; }
    RecordingStatus status() const { return m_target->status(); }

    void fire(); // by hand, without waiting any longer
    void note(Instant at, const QString &text) { m_target->add(RecordedNote{at, text}); }
    void flush() { m_target->flush(); } // waits until what came is written, or could not be
    void end();                         // what came is written, if it can be: status() says so

Q_SIGNALS:
    void stateChanged();

private:
    BusRecorder(Buses &buses, const Histories &histories, const RecordingPlan &plan,
                const BusFeed::WallClockNow &now, std::unique_ptr<RecordingTarget> target);

    void receive(const RecordingEntry &entry);
    void take(const RecordedValues &values);
    void take(const RecordedMessage &message);
    void take(const RecordedTraffic &traffic);
    void take(const RecordedInterruption &interruption);
    void take(const RecordedClock &clock);
    void take(const RecordedDescription &description);
    template <class Other>
    void take(const Other &other);

    bool isWanted(const std::optional<Place> &place) const;
    bool isIn(Instant at) const { return m_span && at >= m_span->from && at < m_span->to; }
    void beginAt(Instant at);
    void endIfOver(Instant now);
    void addMarks(Instant until);
    void addPast(Place place, Instant until);
    void addEarlierDescriptions(Place place);
    void setState(State state);

    const Histories &m_histories;
    const RecordingPlan m_plan;
    std::unique_ptr<RecordingTarget> m_target;
    std::optional<TriggerWatch> m_trigger; // nothing: it has fired
    State m_state;
    std::optional<TimeSpan> m_span;
    std::set<Place> m_withPast;
    std::map<Place, RecordedDescription> m_described; // the first of each
    BusFeed m_feed;                                   // last: tells what it knows at once
};

} // namespace codewheel
