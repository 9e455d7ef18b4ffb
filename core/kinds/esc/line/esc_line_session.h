// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/encoder_bus.h"
#include "kinds/esc/line/esc_line_command.h"
#include "kinds/esc/line/esc_line_event.h"
#include "kinds/esc/line/esc_line_snapshot.h"
#include "kinds/esc/protocol/esc_explain.h"
#include "serial/byte_link.h"
#include "vocabulary/sleep_watch.h"

#include <functional>
#include <memory>
#include <vector>

namespace codewheel {

class EscEncoderSession;

// A connected serial line as the window and the command line see it: owns link, runner, thread and encoder
// sessions. All of it lives in the caller's thread; the line thread is hidden behind pump().
//
// In Watch only reads are sent: positions are polled, values may be read. Writing needs Operate.
class EscLineSession final : public EncoderBus
{
    Q_OBJECT

public:
    // Null for a device that cannot be driven; the description outlives the driver.
    using DriverFactory =
        std::function<std::unique_ptr<RequestDriver>(const DeviceDescription &, EscLineAddress)>;

    // The catalog must outlive the session. `begin` is the date and time of the line's Instant 0.
    EscLineSession(std::unique_ptr<ByteLink> link, const Catalog &catalog, QDateTime begin,
                   DriverFactory makeDriver, QObject *parent = nullptr, BusId id = firstLine);
    ~EscLineSession() override;

    // Opens the line; it is polled from then on. Encoders and sessions of an earlier connection end; those
    // added while its thread is opening it are asked once it is open.
    Result<void> open(const SerialSettings &settings, const esc::Timing &timing, Start start, Drive drive,
                      SleepWatch::Slept slept = SleepWatch::ofThisComputer);
    void close() override;

    // By hand until now, from now on by a thread.
    void startThread(SleepWatch::Slept slept = SleepWatch::ofThisComputer);
    void advance(Instant duration) override;
    void pump() override;

    std::vector<DataCheck> dataChecks(NodeId node, const std::vector<Participant> &planned) const override;

    BusState state() const override;
    bool isSimulated() const override;
    QString linkName() const;
    const SerialSettings &settings() const;

    // Why an encoder at `own` cannot get the address `wanted`: another one of the line answers there, or at
    // the other reading of its digits. Empty: nothing is known of one.
    std::optional<Refusal> addressTaken(EscLineAddress wanted, EscLineAddress own) const;

    // Adds an encoder at this address to the polling. Refused for an address out of range or taken, and for a
    // device that is not for a serial line.
    Result<void> add(EscLineAddress address, const QString &deviceKey);
    Result<void> remove(Place place);
    const BusOutline &outline() const override;
    std::vector<Place> places() const override;

    const Catalog &catalog() const override;
    std::optional<Participant> found(Place place) const override;
    // The addresses of a line do not depend on each other: those where nothing is polled.
    std::map<NodeId, Refusal> strangers(const std::vector<Participant> &planned) const override;
    std::optional<Refusal> isOther(Place place, const QString &deviceKey,
                                   const QString &serialNumber) const override;
    // Any encoder for serial lines.
    Result<void> canBe(Place place, const DeviceDescription &device) const override;
    Result<void> name(Place place, const QString &deviceKey, int turns = 0, int stepsPerTurn = 0) override;

    const EscLineSnapshot &latest() const;
    const EscLineSnapshot::Device *shown(Place place) const; // null: no such device
    bool isOperating() const override;
    bool isPolling() const;
    bool isRunning() const override;
    Instant now() const override { return latest().at; }

    // The adapter that otherAdapterFound() reported is the right one: it is used from now on.
    void takeOtherAdapter();
    // "Determine from device": reads what determines the format of its scaling factor; ends with
    // fractionBitsDetermined(). Sets nothing.
    Result<void> determineFractionBits(Place place);
    // Of the scaling factor, for all encoders, including those added later; what a job will send is worked
    // out with them.
    void setFractionBits(int bits);
    int fractionBits() const;
    // Whether the warnings of this encoder come with their two bytes in the other order (the manual's example
    // of E reads 0098 as 9800h). No effect without such an encoder.
    void setSwapsWarningBytes(Place place, bool on);
    // For putting requests and answers on this line into words.
    esc::ExplainOptions explainOptions() const;

    void setRunning(bool on) override; // polls, or not
    void setOperate(bool on) override;
    // Ends all jobs, drops what was typed but not yet sent, ends a scan.
    void alarmStop() override;
    bool hasTerminal() const override { return true; }
    void scan(const ScanWish &wish);
    void cancelScan();
    // Sends what was typed, once, in its turn; ends with typedAnswered, which says if it was refused.
    void send(const esc::Request &request);

Q_SIGNALS:
    void explainOptionsChanged();
    // The port is gone, and what is plugged in is not known to be its adapter (portOfOther): it is not used
    // unasked.
    void otherAdapterFound(const codewheel::Refusal &which);
    void fractionBitsDetermined(codewheel::Place place, const codewheel::Result<int> &bits);
    void alarmStopped(); // by alarmStop(): nothing may be sent automatically any more
    void passed(const codewheel::esc::EscLineRow &row); // what went over the line
    void typedAnswered(const codewheel::TypedAnswered &answer);
    void scanProgressed(const codewheel::ScanProgress &progress);
    void scanEnded(const codewheel::ScanEnded &result);

private:
    friend class EscEncoderSession;
    template <class Runner, class Session>
    friend class BusEngine;
    EncoderSession *encoderAt(NodeId node) const override;
    EscEncoderSession &take(EscLineAddress address, const DeviceDescription &device); // starts polling it
    std::unique_ptr<EscEncoderSession> leave(std::size_t index);                      // stops polling it
    std::vector<TypedWrite> writesOf(const esc::Request &request) const;
    void tellEnd(const TypedAnswered &answered);
    void tellTyped(Place place, const TypedAnswered &answered);
    void post(EscLineCommand command);
    void dispatch(const EscLineEvent &event);
    void linkOpened();
    void showLatest();
    EncoderSession *showing(std::size_t device) const;

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace codewheel
