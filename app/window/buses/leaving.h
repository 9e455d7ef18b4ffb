// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/buses/work_under_way.h"
#include "vocabulary/encoder_session.h"

#include <QObject>
#include <QPointer>

#include <functional>
#include <map>

class QWidget;

namespace codewheel {

class Buses;
class EncoderBus;

// What to ask before a bus is stopped or disconnected, or the window is closed: how to end a running
// handshake, or what else is under way, and whether to set OUT words that are not 0 to 0. Saying "no" loses
// nothing.
class Leaving : public QObject
{
    Q_OBJECT

public:
    enum class Why { stop, disconnect, quit };

    explicit Leaving(QWidget &window);

    // The buses outlive it. Called once, before anything is asked.
    void setBuses(Buses &buses);
    // What pages have under way on a bus, and what ends it, as BusViews has it.
    struct OtherWork
    {
        std::function<std::optional<WorkUnderWay>(BusId bus)> underWay;
        std::function<void(BusId bus, const std::function<void(bool isSettled)> &then)> breakOff;
    };
    void setOtherWork(OtherWork work) { m_otherWork = std::move(work); }
    // Calls `then` once everything is answered and done; not at all if the user stays. `left` are the buses
    // concerned; null entries are ignored.
    void ask(Why why, const std::vector<EncoderBus *> &left, std::function<void()> then);

private:
    void goOn();
    bool endJob(EncoderSession &encoder);
    bool goesOnWithoutJob(Place place);
    QString title() const;
    QString headline(const std::vector<Place> &devices, bool needsRun) const;
    enum class Asked { first, again }; // again: in place of a question that was open
    bool askForOut(const std::vector<Place> &devices, Asked asked);
    bool askForWhatIsLeft();
    const EncoderBus *busWithOtherWork() const; // null: none has any
    void askToBreakOff(BusId bus);
    bool askAboutZeros();
    bool waitsForZeros() const;
    void zero(const std::vector<Place> &devices, bool runsFirst);
    std::vector<Place> devicesToAskFor() const;
    bool isInParameterization(Place device) const; // or was, when the link was lost
    bool isInOtherMode(Place device) const;        // in which a job that was cut off has left it
    bool isLost(Place device) const;               // the link to it
    QStringList statesOf(const std::vector<Place> &devices) const;
    QString stateOf(Place device) const;
    EncoderSession *busyEncoder() const;
    std::vector<EncoderBus *> buses() const; // to be left, and still open
    // To one of them; empty: it can be.
    QString whyNothingCanBeSent(const std::vector<Place> &devices) const;
    void watch();
    void takeProgress(const EncoderSession &encoder, const Progress &progress);
    void stay();

    QWidget &m_window;
    Buses *m_buses = nullptr;
    OtherWork m_otherWork;
    std::vector<QPointer<EncoderSession>> m_watched;
    std::map<Place, Progress> m_progress; // of the running jobs
    QPointer<EncoderSession> m_cancelled; // while it has taken nothing
    Why m_why = Why::stop;
    std::vector<EncoderBus *> m_left; // for comparison only: they may be gone
    std::function<void()> m_then;
    bool m_outAnswered = false;
    bool m_zerosAnswered = false; // those of an ALARM STOP that have not arrived
    bool m_waitsForZero = false;  // or for what run brings back
    bool m_breaksOff = false;     // and waits for the end of other work
    bool m_asks = false;          // a question is open
};

} // namespace codewheel
