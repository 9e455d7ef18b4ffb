// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/bus_state.h"
#include "bus/participant.h"
#include "bus/traffic.h"
#include "bus/wall_time.h"
#include "vocabulary/encoder_session.h"
#include "vocabulary/message.h"

#include <map>
#include <span>
#include <vector>

namespace codewheel {

class BusOutline;
class Catalog;
class WordChannel;
struct DataCheck;

// A write that somebody typed: to this encoder, or to a place where none is known to be.
struct TypedWrite
{
    Place place;
    QByteArray text;          // as it goes out
    ParameterValues values{}; // that it sets, according to the description of the encoder
};

// What became of it.
enum class TypedEnd : std::uint8_t {
    notDone, // it did not go out, or was refused
    done,
    notKnown, // it went out, or may have, and no answer tells
};

// A connected bus of any kind as window, command line and ledger see it: its devices, its state, and what may
// be sent to it. Implemented by RingSession (a ring) and EscLineSession (a serial line).
class EncoderBus : public QObject
{
    Q_OBJECT

public:
    enum class Start { watching, operating };
    enum class Drive {
        byThread, // a thread of its own, which also opens and closes the link
        byHand,   // advance()
    };

    // `begin` is the date and time of Instant 0 of the bus; `columns` are those of its traffic, and must
    // outlive it.
    EncoderBus(BusId id, const QDateTime &begin, std::span<const TrafficColumn> columns,
               QObject *parent = nullptr);

    BusId id() const { return m_id; }
    Place placeOf(NodeId node) const { return {m_id, node}; }
    // How it is displayed; lives as long as the bus.
    virtual const BusOutline &outline() const = 0;
    virtual std::vector<Place> places() const = 0; // of all devices, encoders or not
    // Null: no driver for it, or no such device.
    EncoderSession *encoder(NodeId node) const { return encoderAt(node); }
    EncoderSession *encoder(Place place) const { return place.bus == m_id ? encoderAt(place.node) : nullptr; }
    // Null: it has no words, or there is no such device.
    WordChannel *channel(NodeId node) const { return channelAt(node); }
    WordChannel *channel(Place place) const { return place.bus == m_id ? channelAt(place.node) : nullptr; }

    // What passes is shown by a terminal of its kind, and encoders take requests instead of words.
    virtual bool hasTerminal() const { return false; }
    // What its rows of traffic contain, in the order shown.
    std::span<const TrafficColumn> trafficColumns() const { return m_trafficColumns; }

    virtual const Catalog &catalog() const = 0;
    // The device there, as found or as the bus was told; empty: none.
    virtual std::optional<Participant> found(Place place) const = 0;
    // What to call a device of this bus; without its description (null) by what the bus itself tells.
    virtual QString nameOf(const Participant & /*device*/, const DeviceDescription *description) const
    {
        return participantName(description);
    }
    virtual Refusal whyNotThere(Place place) const; // if there is no device
    // The devices planned for this bus that are not certain to be the connected ones at their places, and
    // why.
    virtual std::map<NodeId, Refusal> strangers(const std::vector<Participant> &planned) const = 0;
    // Why the encoder at its place is not the planned one, by what it is taken for and the serial number it
    // reports; what is not known of either is not compared. Empty: nothing contradicts it, or this kind of
    // bus distinguishes devices only by strangers().
    virtual std::optional<Refusal> isOther(Place place, const QString &deviceKey,
                                           const QString &serialNumber) const;
    // Whether the device at `place` can be this one.
    virtual Result<void> canBe(Place place, const DeviceDescription &device) const = 0;
    // The user names the device: the key of a description that fits it. The resolution on the label takes
    // precedence over the description; 0: not on the label. The device gets a new session (or none), which
    // encoder() returns from then on, and of what was known only the count of EEPROM writes is kept; the old
    // session ends. Refused while a job runs. Sends nothing.
    virtual Result<void> name(Place place, const QString &deviceKey, int turns = 0, int stepsPerTurn = 0) = 0;

    // The same for a device that has replaced the one before: nothing that is known of that is kept for it.
    Result<void> replace(Place place, const QString &deviceKey, int turns, int stepsPerTurn);

    // Why there is no data: of the device there, or, without a node, of the bus itself; `planned` are the
    // devices that the project plans for it.
    virtual std::vector<DataCheck> dataChecks(NodeId node, const std::vector<Participant> &planned) const;
    // Why it could not be connected, when that was last tried.
    const std::optional<Refusal> &whyRefused() const { return m_whyRefused; }

    virtual BusState state() const = 0;
    bool isOpen() const { return state() == BusState::open || state() == BusState::lost; } // connected
    virtual bool isSimulated() const = 0;                                                  // its encoders are
    // False: its devices are those of the project as it was when the bus was connected.
    virtual bool findsDevices() const { return true; }
    // It shows a recording: nobody is at work there, nothing is sent, and what it shows is of then.
    virtual bool isReplay() const { return false; }
    virtual bool isRunning() const = 0; // RUN; for a serial line: the port is there, and positions are polled
    virtual bool isOperating() const = 0; // writing is allowed

    virtual Instant now() const = 0; // of the newest snapshot
    virtual QDateTime dateTime(Instant at) const { return m_wallTime.dateTime(at); }
    Instant instantOf(const QDateTime &time) const { return m_wallTime.instantOf(time); }
    Instant sinceEpoch(Instant at) const { return m_wallTime.sinceEpoch(at); }
    // A simulated clock stands still until the bus is opened: its time is now `time`.
    void setTime(const QDateTime &time) { m_wallTime.goOn(time, now()); }

    // Takes what came from the bus since the last call and emits it. The window calls this 30 times a second.
    virtual void pump() = 0;
    // Driven by hand: works for this long on the bus's clock, then pumps.
    virtual void advance(Instant duration) = 0;
    // Leaves the bus, or stops opening it. Jobs end as stopped; the sessions remain to be looked at.
    virtual void close() = 0;

    virtual void setRunning(bool on) = 0; // RUN or stopped; for a serial line: polled or not
    virtual void setOperate(bool on) = 0;
    // Jobs end as stopped, and nothing that waits is sent any more; on a ring all OUT words become 0, on a
    // serial line only reading goes on. From every state, at once.
    virtual void alarmStop() = 0;
    // What an ALARM STOP sends has not arrived yet, and is tried on until the bus is closed.
    virtual bool waitsForZeros() const { return false; }

Q_SIGNALS:
    void updated();                                  // a new snapshot; at most once per pump
    void openRefused(const codewheel::Refusal &why); // a message says so too
    void stateChanged();                             // connected or not, running or stopped, Watch or Operate
    void named(codewheel::Place place);    // by name(), before nodesChanged(): it has a new session now
    void replaced(codewheel::Place place); // by replace(), before named()
    // The link is back, and what is known of the encoders is about to be forgotten: others may be there.
    void meetsAgain();
    // It is a different bus now: what looks the same may be another device. nodesChanged() follows.
    void structureChanged();
    void nodesChanged(); // other devices, or an encoder with a new session
    // An encoder has a new place: encoder() finds it there now.
    void moved(codewheel::Place from, codewheel::Place to);
    // Of this many cycles or answers of its devices nobody will know what they showed: they came faster than
    // they were taken.
    void valuesDropped(std::uint64_t count);
    void messaged(const codewheel::Message &message); // with its place, of a device or of the bus itself
    void trafficPassed(const codewheel::TrafficRow &row);
    // What passes from now on does not follow what passed before: it is another moment of a recording.
    void trafficRestarted();
    // For the ledger of EEPROM writes, before anything of it is sent.
    void writeAboutToBeSent(const codewheel::TypedWrite &write);
    // Once for each that was about to be sent, for every encoder that exists by then.
    void typedWriteEnded(const codewheel::TypedWrite &write, codewheel::TypedEnd end);

protected:
    // What name() may be refused for on every bus; null: the make is no longer known.
    Result<void> mayName(Place place, const DeviceDescription *device) const;
    // Another clock from now on, on which it is `time` at `at`. What was shown by the one before is gone.
    void setClock(const QDateTime &time, Instant at) { m_wallTime.beginAnew(time, at); }
    void tell(Message message);           // from a device, or from the bus: its place need not name the bus
    void tellTraffic(TrafficRow row);     // adds its time
    void linkRefused(const Refusal &why); // it is closed, and reported
    void tellState(bool isOther = false); // stateChanged() if it differs; `isOther`: also for other reasons
    // The jobs have ended, and the bus is in Watch: corrects the times and reports it.
    void takeSleep(const Slept &slept, Instant at);

private:
    friend class EncoderOnBus;
    virtual EncoderSession *encoderAt(NodeId node) const = 0;
    virtual WordChannel *channelAt(NodeId /*node*/) const { return nullptr; }

    struct State
    {
        BusState bus = BusState::closed;
        bool isRunning = false;
        bool isOperating = false;

        friend bool operator==(const State &, const State &) = default;
    };

    BusId m_id;
    std::span<const TrafficColumn> m_trafficColumns;
    State m_told;
    std::chrono::milliseconds m_trafficAt{}; // since 1970, of the newest row
    QDateTime m_trafficTime;                 // likewise
    std::optional<Refusal> m_whyRefused;
    WallTime m_wallTime;
};

Refusal notConnected(Place place);

// Those whose OUT is not 00000000, to be named on stop, disconnect and quit. None of a recording.
std::vector<Place> devicesWithOut(const EncoderBus &bus);

} // namespace codewheel
