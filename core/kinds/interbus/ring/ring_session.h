// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/bus_engine.h"
#include "bus/encoder_bus.h"
#include "kinds/interbus/ring/command.h"
#include "kinds/interbus/ring/crc_history.h"
#include "kinds/interbus/ring/master_link.h"
#include "kinds/interbus/ring/process_data_link.h"
#include "kinds/interbus/ring/ring_checks.h"
#include "kinds/interbus/ring/ring_device.h"
#include "kinds/interbus/ring/ring_event.h"
#include "kinds/interbus/ring/ring_outline.h"
#include "kinds/interbus/ring/ring_runner.h"
#include "kinds/interbus/ring/snapshot.h"
#include "kinds/interbus/ring/word_doubts.h"
#include "kinds/interbus/words/cyclic_driver.h"

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace codewheel {

class Catalog;
class RingEncoderSession;

// A connected ring as the window and the command line see it: owns link, runner, thread, encoder sessions and
// word channels. All of it lives in the caller's thread; the bus thread is hidden behind pump().
//
// A lost link is tried again every second. Once it is back the bus is in Watch; if the ring is a different
// one by then, it is adopted: structureChanged. A device with the same number, device code and name keeps its
// session and its channel; those of all others are gone at the next pump(). Of a real encoder nothing is
// known then: meetsAgain.
class RingSession final : public EncoderBus
{
    Q_OBJECT

public:
    // Null for a device that cannot be driven; the description outlives the driver.
    using DriverFactory = std::function<std::unique_ptr<CyclicDriver>(const DeviceDescription &)>;

    // The catalog must outlive the session. `begin` is the date and time of Instant 0. No factory: the
    // drivers of the program (make_driver.h).
    RingSession(std::unique_ptr<ProcessDataLink> link, const Catalog &catalog, QDateTime begin,
                QObject *parent = nullptr, DriverFactory makeDriver = {}, BusId id = firstBus);
    ~RingSession() override;

    // Connects, finds the participants, makes sessions and channels; the bus is in RUN afterwards. Sends
    // nothing. Ends sessions and channels of an earlier connection. With a pacing a thread does it, and the
    // bus is `opening` until pump() reports the end; without one it is done at once, and the first cycle
    // comes with startThread() or advance().
    Result<void> open(Start start, std::optional<Pacing> pacing = {});
    // Closes the bus, which has this link, on whose clock it is `time` now, from its next open() on. What was
    // on the bus is gone. Returns the link it had.
    std::unique_ptr<ProcessDataLink> useLink(std::unique_ptr<ProcessDataLink> link, const QDateTime &time);
    void close() override;

    // Cycles driven by a thread of its own, on absolute deadlines ...
    void startThread(std::chrono::nanoseconds period, SleepWatch::Slept slept = SleepWatch::ofThisComputer)
    {
        m_engine.startThread({period, std::move(slept)});
    }
    // ... or by hand: each cycle is 1 ms after the previous one. Pumps afterwards.
    void advance(int cycles);
    void advance(Instant duration) override;
    void pump() override;

    // Guests read and write the ring beside us, from now on and after each opening; null: nobody does.
    void offerTo(std::shared_ptr<RingGuests> guests);

    std::vector<DataCheck> dataChecks(NodeId node, const std::vector<Participant> &planned) const override;

    BusState state() const override;
    bool isSimulated() const override { return m_link->isSimulated(); }
    bool findsDevices() const override { return m_link->findsDevices(); }
    const RingStructure &structure() const { return m_structure; }
    const BusOutline &outline() const override { return m_outline; }
    std::vector<Place> places() const override;

    const Snapshot &latest() const { return *m_engine.latest(); }
    // What the ring's master says; null if the link reaches none.
    const MasterStatus *master() const { return latest().master.get(); }
    const CrcHistory &crcHistory() const { return m_crcHistory; }
    const WordDoubts &doubts() const { return m_doubts; }
    // Whether a device can have sent its IN word; empty: its link or its description does not tell.
    std::optional<DataCheck> checkWord(std::size_t device) const;
    bool isOperating() const override { return latest().operate; }
    bool isRunning() const override { return latest().state == MasterState::run; }
    Instant now() const override { return latest().at; }

    void setRunning(bool on) override;
    void setOperate(bool on) override { post(command::SetOperate{on}); }
    void alarmStop() override;
    // The zeros of an ALARM STOP were asked for a second ago, and have not arrived.
    bool areZerosLate() const { return m_zerosAreLate; }
    // They are on the gateway, and its ring has not run since.
    bool areZerosBeforeRing() const { return m_zerosAreBeforeRing; }
    bool waitsForZeros() const override { return isOpen() && (m_zerosAskedAt || latest().zerosAreDue); }
    // Of a ring that could not be opened: ProcessDataLink::sendZerosUnheard().
    bool sendZerosUnheard() { return !isOpen() && m_link->sendZerosUnheard(); }
    // What was in OUT when they were asked for: "1.0 20210001 (register 0)".
    QString outBeforeZeros() const;
    // Of a gateway; refused where no register is set for it.
    void acknowledgeWatchdog() { post(command::AcknowledgeWatchdog{}); }
    // Goes to Operate, sets the OUT that a job has left to 00000000 and reads what is not known since. What
    // comes of it is reported like any job.
    void bringBack(Place place);
    // Ends the parameterization in which the encoder was left: what it has taken becomes valid.
    void sendRun(Place place);

    // Services of the ring's master. Each ends in messages; a link that reaches no master refuses them.
    //
    // Reads in the ring: stops it, has the master find the devices (readInProgressed), and lets it run again.
    // A ring that differs from the previous one is adopted: structureChanged.
    void readIn();
    bool isReadingIn() const { return m_readingIn; }
    // Takes a segment out of the data cycles with everything behind it, or puts it back.
    void switchSegment(int segment, bool on) { post(command::SwitchSegment{segment, on}); }
    void confirmDiagnostics() { post(command::ConfirmDiagnostics{}); }
    // The master stores this configuration from now on, and activates it the next time it is started.
    void keepConfiguration(const KeptConfiguration &configuration)
    {
        post(command::KeepConfiguration{configuration});
    }
    // Answered by keptConfigurationTold.
    void askKeptConfiguration() { post(command::AskKeptConfiguration{.onConnecting = false}); }

    // If no description has the key, the device is "make not known" again.
    Result<void> name(Place place, const QString &deviceKey, int turns = 0, int stepsPerTurn = 0) override;
    // By its device code.
    Result<void> canBe(Place place, const DeviceDescription &device) const override;
    const Catalog &catalog() const override { return m_catalog; }
    std::optional<Participant> found(Place place) const override;
    QString nameOf(const Participant &device, const DeviceDescription *description) const override;
    Refusal whyNotThere(Place place) const override;
    std::map<NodeId, Refusal> strangers(const std::vector<Participant> &planned) const override;

Q_SIGNALS:
    void
    refused(const codewheel::Refusal &why); // a request to the whole ring was refused, or its link is lost
    void readInProgressed(int devices);     // found so far
    void readInEnded();                     // structure() is what was found
    void readInFailed(const codewheel::Refusal &why);
    void keptConfigurationTold(const std::optional<codewheel::KeptConfiguration> &configuration);

private:
    friend class RingEncoderSession;
    template <class Runner, class Session>
    friend class BusEngine;
    EncoderSession *encoderAt(NodeId node) const override;
    WordChannel *channelAt(NodeId node) const override; // null: no such device
    Result<void> write(const WordChannel &channel, Word word);
    void showDevice(std::size_t place);
    void lookForZeros();
    void goOnBringingBack();
    void startReported(EncoderSession &encoder, const Job &job);
    void post(Command command) { m_engine.post(std::move(command)); }
    void linkOpened() {} // the ring is reported next
    bool takeAtOnce(const RingEvent &event);
    bool isWordDoubtful(std::size_t device) const;
    bool isOfNow(const Snapshot &snapshot) const
    {
        return snapshot.generation == m_generation && m_generation > 0;
    }
    EncoderSession *showing(std::size_t device) const;
    void showLatest();
    void dispatch(const RingEvent &event);
    void dispatch(Message message, std::optional<std::size_t> device);
    void takeOfMaster(const MasterEvent &event);
    void useFirstRing(const RingFound &found);
    void useOtherRing(const RingFound &found);
    void endJobsOfBefore();
    void meetAgain();
    void showNewRing(const RingFound &found, const RingState &state);
    command::UseRing makeDevices(const RingFound &found);
    std::unique_ptr<WordChannel> makeChannel(const RingDevice &participant);
    // The session at a place of the ring, for `description` if there is one, and its driver.
    std::unique_ptr<CyclicDriver> makeSession(std::size_t place, const DeviceDescription *description);
    bool isStale(std::size_t place) const { return m_renamings[place] > 0; }
    void retireAll();
    void forgetDevices();
    void endRetired(); // unless handlers may still be looking at them
    void keepEepromWrites(const RingEvent &event);
    // Another ring replaces this one (ring_session_ring.cpp).
    command::UseRing takeOver(const RingFound &found);
    std::vector<Word> outNow() const;
    void noteForeign(const Refusal &why);
    std::size_t indexOf(NodeId node) const; // m_structure.size(): no such device

    const RingOutline m_outline;
    std::unique_ptr<ProcessDataLink> m_link;
    const Catalog &m_catalog;
    DriverFactory m_driverFor;

    // What was found by open(), in ring order.
    RingStructure m_structure;
    std::deque<DeviceDescription> m_descriptions;                // of those that have a session
    std::vector<std::unique_ptr<RingEncoderSession>> m_sessions; // null: no driver
    std::vector<std::unique_ptr<WordChannel>> m_channels;
    std::vector<std::deque<DeviceDescription>> m_retiredDescriptions;
    // Of devices named, or of a ring read in, in the middle of pump().
    std::vector<std::unique_ptr<RingEncoderSession>> m_retired;
    std::vector<std::unique_ptr<WordChannel>> m_retiredChannels;
    std::vector<int> m_renamings; // on their way to the bus thread: until then, the previous driver reports

    std::shared_ptr<RingGuests> m_guests; // null: none
    Start m_start = Start::watching;
    unsigned m_generation = 0; // of the ring; 0: none is used yet
    bool m_readingIn = false;
    StoppedBy m_stoppedBy = StoppedBy::other;
    std::optional<Instant> m_zerosAskedAt{}; // and nothing has been told of them yet; by the link's clock
    bool m_zerosAreLate = false;
    bool m_zerosAreBeforeRing = false;
    std::vector<Word> m_outBeforeZeros{}; // as last seen
    struct Foreign
    {
        Word word = 0;
        std::uint64_t cycle = 0; // a later one shows OUT
    };
    std::map<std::size_t, Foreign> m_foreign{}; // by device: what somebody else has written
    std::optional<Place> m_toBringBack{};       // once the ring operates
    CrcHistory m_crcHistory;
    WordDoubts m_doubts;
    MasterState m_toldState = MasterState::ready;
    BusEngine<RingRunner, RingSession> m_engine; // destroyed before what its drivers use
};

} // namespace codewheel
