// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/encoder_bus.h"
#include "kinds/canopen/bus/canopen_command.h"
#include "kinds/canopen/bus/canopen_event.h"
#include "kinds/canopen/bus/canopen_settings.h"
#include "kinds/canopen/bus/canopen_snapshot.h"
#include "kinds/canopen/protocol/canopen_address.h"
#include "vocabulary/sleep_watch.h"

#include <memory>

namespace codewheel {

class CanopenEncoderSession;

// A connected CAN bus with CANopen as the window and the command line see it: owns link, runner, thread and
// encoder sessions. All of it lives in the caller's thread; that of the bus is hidden behind pump().
//
// In Watch nothing is sent. What is heard is shown all the same.
class CanopenSession final : public EncoderBus
{
    Q_OBJECT

public:
    // The catalog must outlive the session. `begin` is the date and time of the bus's Instant 0.
    CanopenSession(std::unique_ptr<CanLink> link, const Catalog &catalog, QDateTime begin,
                   QObject *parent = nullptr, BusId id = firstCanBus);
    ~CanopenSession() override;

    // Encoders and sessions of an earlier connection end. Refused with canWatchNotSure: see
    // takeUnsureWatch().
    Result<void> open(const CanopenSettings &settings, Start start, Drive drive,
                      SleepWatch::Slept slept = SleepWatch::ofThisComputer);
    void close() override;
    // By hand until now, from now on by a thread.
    void startThread(SleepWatch::Slept slept = SleepWatch::ofThisComputer);
    void advance(Instant duration) override;
    void pump() override;

    // The user agrees: the bus is watched although the adapter may acknowledge frames; a stopped link is
    // opened so at once, a closed one by open().
    void takeUnsureWatch();
    // The user agrees: frames are sent although another master is at work.
    void sendBesideOthers() { post(canopen_command::SendBesideOthers{}); }
    // The user agrees: the next job of this encoder may stop its node for a moment.
    void mayStopNode(Place place);

    std::vector<DataCheck> dataChecks(NodeId node, const std::vector<Participant> &planned) const override;

    BusState state() const override;
    bool isSimulated() const override;
    QString linkName() const;
    const CanopenSettings &settings() const;
    int rate() const; // in force, as far as the adapter tells; Bd

    // Adds an encoder with this number. Refused for one that is out of range or taken, and for a device that
    // is not for CANopen.
    Result<void> add(int node, const QString &deviceKey);
    Result<void> remove(Place place);
    const BusOutline &outline() const override;
    std::vector<Place> places() const override;

    const Catalog &catalog() const override;
    std::optional<Participant> found(Place place) const override;
    // The numbers of nodes do not depend on each other: those where nobody is asked.
    std::map<NodeId, Refusal> strangers(const std::vector<Participant> &planned) const override;
    std::optional<Refusal> isOther(Place place, const QString &deviceKey,
                                   const QString &serialNumber) const override;
    Result<void> canBe(Place place, const DeviceDescription &device) const override;
    Result<void> name(Place place, const QString &deviceKey, int turns = 0, int stepsPerTurn = 0) override;

    const CanopenSnapshot &latest() const;
    bool isOperating() const override { return latest().operate; }
    bool isRunning() const override { return latest().connected && latest().running; }
    Instant now() const override { return latest().at; }

    void setRunning(bool on) override { post(canopen_command::SetRunning{on}); } // nodes are asked, or not
    void setOperate(bool on) override { post(canopen_command::SetOperate{on}); }
    // Ends all jobs, drops what waits to be sent, and stops the nodes that were started from here.
    void alarmStop() override { post(canopen_command::AlarmStop{}); }
    bool waitsForZeros() const override { return latest().stopsWait; }

    // By hand, in Operate. Each ends with its signal, which says if it was refused.
    void send(const CanFrame &frame);
    void transfer(const canopen::SdoRequest &request);
    void configure(const canopen::LssRequest &request);
    void cancelConfiguration() { post(canopen_command::CancelConfigure{}); }
    void scan() { post(canopen_command::Scan{}); } // all numbers are asked
    void cancelScan() { post(canopen_command::CancelScan{}); }

Q_SIGNALS:
    void passed(const codewheel::CanopenRow &row);
    void frameSent(const codewheel::FrameSent &sent);
    void transferEnded(const codewheel::TransferEnded &ended);
    void configured(const codewheel::Configured &ended);
    void scanned(const codewheel::NodesScanned &scan); // some more, or all
    // While it is open: it cannot be watched for sure, and waits for takeUnsureWatch().
    void watchNotSure(const codewheel::Refusal &why);

private:
    friend class CanopenEncoderSession;
    template <class Runner, class Session>
    friend class BusEngine;
    EncoderSession *encoderAt(NodeId node) const override;
    CanopenEncoderSession &take(int node, const DeviceDescription &device); // starts asking it
    std::unique_ptr<CanopenEncoderSession> leave(std::size_t index);        // stops asking it
    void accountFor(const std::optional<TypedWrite> &write);
    void tellEnd(const std::optional<TypedWrite> &write, bool mayBeDone);
    std::optional<TypedWrite> storing(int node, const canopen::SdoObject &object, bool isWrite) const;
    std::optional<TypedWrite> storing(const CanFrame &frame) const;
    std::optional<TypedWrite> storing(const canopen::SdoRequest &request) const;
    std::optional<TypedWrite> storing(const canopen::LssRequest &request) const;
    void post(CanopenCommand command);
    void dispatch(const CanopenEvent &event);
    void linkOpened();
    void showLatest();
    EncoderSession *showing(std::size_t device) const;

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace codewheel
