// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/bus_state.h"
#include "bus/participant.h"
#include "bus/traffic.h"
#include "bus/wall_time.h"
#include "encoder/encoder_session.h"
#include "encoder/message.h"

#include <map>
#include <span>
#include <vector>

namespace codewheel {

class BusOutline;
class Catalog;
class WordChannel;

// A write that somebody has typed: to this encoder, or to a place where none is known to stand.
struct TypedWrite
{
    Place place;
    QByteArray text;          // as it goes out
    ParameterValues values{}; // that it sets, by the description of the encoder
};

// A connected bus, whatever it is, as window, command line and ledger see it: its devices, its state, and
// what they let pass to it. Implemented by RingSession (a ring) and LineSession (a serial line).
class EncoderBus : public QObject
{
    Q_OBJECT

public:
    enum class Start { watching, operating };
    enum class Drive {
        byThread, // of its own, which also opens and closes the link
        byHand,   // advance()
    };

    // `begin` is the date and time that Instant 0 of the bus stands for; `columns` are those of its traffic,
    // and outlive it.
    EncoderBus(BusId id, QDateTime begin, std::span<const TrafficColumn> columns, QObject *parent = nullptr);

    BusId id() const { return m_id; }
    Place placeOf(NodeId node) const { return {m_id, node}; }
    // How it is looked at; as long as the bus.
    virtual const BusOutline &outline() const = 0;
    virtual std::vector<Place> places() const = 0; // of all devices, encoders or not
    // Null: no driver for it, or no such device.
    EncoderSession *encoder(NodeId node) const { return encoderAt(node); }
    EncoderSession *encoder(Place place) const { return place.bus == m_id ? encoderAt(place.node) : nullptr; }
    // Null: it has no words, or there is no such device.
    WordChannel *channel(NodeId node) const { return channelAt(node); }
    WordChannel *channel(Place place) const { return place.bus == m_id ? channelAt(place.node) : nullptr; }

    // What its rows of traffic have to tell, in the order in which it is shown.
    std::span<const TrafficColumn> trafficColumns() const { return m_trafficColumns; }

    virtual const Catalog &catalog() const = 0;
    // What stands there, as it was found or as the bus was told; nothing: no device.
    virtual std::optional<Participant> found(Place place) const = 0;
    virtual Refusal whyNotThere(Place place) const; // where nothing stands
    // Of the devices planned for this bus those that are not for certain the connected ones at their places,
    // and why.
    virtual std::map<NodeId, Refusal> strangers(const std::vector<Participant> &planned) const = 0;
    // Why the encoder at its place is another one than planned, by what it is taken for and the serial number
    // it tells; what is not known of either is not compared. Nothing: nothing speaks against it, or this kind
    // of bus tells devices from each other by strangers() alone.
    virtual std::optional<Refusal> isOther(Place place, const QString &deviceKey,
                                           const QString &serialNumber) const;
    // Whether the device at `place` can be this one.
    virtual Result<void> canBe(Place place, const DeviceDescription &device) const = 0;
    // The user names the device: the key of a description that it can be. What the label tells of its
    // resolution goes before the description; 0: it does not. The device gets a new session (or none):
    // encoder() gives that one from now on, and nothing that was known is kept but the count of EEPROM
    // writes; the old one ends. Refused while a job runs. Sends nothing.
    virtual Result<void> name(Place place, const QString &deviceKey, int turns = 0, int stepsPerTurn = 0) = 0;

    virtual BusState state() const = 0;
    bool isOpen() const { return state() == BusState::open || state() == BusState::lost; } // connected
    virtual bool isSimulated() const = 0;                                                  // the encoders are
    virtual bool isRunning() const = 0; // RUN; of a serial line: the port is there, and positions are polled
    virtual bool isOperating() const = 0; // writing is allowed

    virtual Instant now() const = 0; // of the newest snapshot
    QDateTime dateTime(Instant at) const { return m_wallTime.dateTime(at); }
    // A simulated clock stands still until the bus is opened: it is `time` now.
    void setTime(const QDateTime &time) { m_wallTime.goOn(time, now()); }

    // Takes what came from the bus since the last call and emits it. The window calls this 30 times a second.
    virtual void pump() = 0;
    // Driven by hand: works so long on the bus's clock, and pumps afterwards.
    virtual void advance(Instant duration) = 0;
    // Leaves the bus, or ends opening it. Jobs end as stopped; the sessions stay to be looked at.
    virtual void close() = 0;

    virtual void setRunning(bool on) = 0; // RUN or stopped; of a serial line: polled or not
    virtual void setOperate(bool on) = 0;
    // Jobs end as stopped, and nothing is sent on its own any more; of a ring, all OUT words become 0. From
    // every state, at once.
    virtual void alarmStop() = 0;

Q_SIGNALS:
    void updated();                                  // a new snapshot; at most once per pump
    void openRefused(const codewheel::Refusal &why); // told by a message too
    void stateChanged();                             // connected or not, running or stopped, Watch or Operate
    void named(codewheel::Place place); // by name(), before nodesChanged(): its session is another one now
    // It is another bus now: what looks the same may be another device. nodesChanged() follows.
    void structureChanged();
    void nodesChanged(); // other devices, or an encoder has another session than before
    // An encoder has another place now: encoder() finds it by that one.
    void moved(codewheel::Place from, codewheel::Place to);
    void messaged(const codewheel::Message &message); // with its place, of a device or of the bus itself
    void trafficPassed(const codewheel::TrafficRow &row);
    // Nothing of it has been sent yet. For the ledger of EEPROM writes.
    void writeAboutToBeSent(const codewheel::TypedWrite &write);
    // Once for each that was about to be sent, for each encoder there is by now. `mayBeDone`: it went out,
    // and was not refused.
    void typedWriteEnded(const codewheel::TypedWrite &write, bool mayBeDone);

protected:
    // What name() may be refused for on every bus; null: the make is not known any more.
    Result<void> mayName(Place place, const DeviceDescription *device) const;
    void tell(Message message);           // of one of its devices, or of the bus: its place need not know it
    void tellTraffic(TrafficRow row);     // with its time
    void linkRefused(const Refusal &why); // it is closed: it is told
    void tellState(bool isOther = false); // stateChanged(), if it is another; `isOther`: for more reasons
    // The jobs have ended, and the bus is in Watch: the times are right again, and it is told.
    void takeSleep(const Slept &slept, Instant at);

private:
    virtual EncoderSession *encoderAt(NodeId node) const = 0;
    virtual WordChannel *channelAt(NodeId node) const;

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
    WallTime m_wallTime;
};

Refusal notConnected(Place place);

// Those whose OUT is not 00000000, to be named on stop, disconnect and quit.
std::vector<Place> devicesWithOut(const EncoderBus &bus);

} // namespace codewheel
