// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/bus_session.h"
#include "kinds/canopen/bus/canopen_command.h"
#include "kinds/canopen/bus/canopen_event.h"
#include "kinds/canopen/bus/canopen_outline.h"
#include "kinds/canopen/bus/canopen_settings.h"
#include "kinds/canopen/bus/canopen_snapshot.h"
#include "kinds/canopen/bus/canopen_traffic.h"
#include "kinds/canopen/protocol/canopen_address.h"

namespace codewheel {

// A connected CAN bus with CANopen as the window and the command line see it.
//
// In Watch nothing is sent. What is heard is shown all the same.
class CanopenSession final : public BusSession<CanopenCommand, CanopenEvent, CanopenSnapshot, CanLink>
{
    Q_OBJECT

public:
    // The catalog must outlive the session. `begin` is the date and time of the bus's Instant 0.
    CanopenSession(std::unique_ptr<CanLink> link, const Catalog &catalog, const QDateTime &begin,
                   QObject *parent = nullptr, BusId id = firstCanBus);

    // Refused with canWatchNotSure: see takeUnsureWatch().
    Result<void> open(const CanopenSettings &settings, Start start, Drive drive,
                      SleepWatch::Slept slept = SleepWatch::ofThisComputer);

    // The user agrees: the bus is watched although the adapter may acknowledge frames; a stopped link is
    // opened so at once, a closed one by open().
    void takeUnsureWatch();
    // The user says so of all nodes that are added from now on: NodeDriver::takeUsualMapping().
    void takeUsualMapping() { m_isUsuallyMapped = true; }
    // The user agrees: frames are sent although another master is at work.
    void sendBesideOthers() { post(canopen_command::SendBesideOthers{}); }
    // The user agrees: the next job of this encoder may stop its node for a moment.
    void mayStopNode(Place place);

    std::vector<DataCheck> dataChecks(NodeId node, const std::vector<Participant> &planned) const override;

    const CanopenSettings &settings() const { return m_settings; }
    int rate() const
    {
        return latest().status.rate.value_or(m_settings.rate);
    } // in force, as far as told; Bd

    using AskedBus::add;
    Result<void> add(int node, const QString &deviceKey)
    {
        return add(CanopenAddress{node}.place(), deviceKey);
    }
    const BusOutline &outline() const override { return m_outline; }

    Result<void> mayStart(const Job &job, const QString &place) const override;
    bool waitsForZeros() const override { return latest().stopsWait; }

    // By hand, in Operate. Each ends with its signal, which says if it was refused.
    void send(const CanFrame &frame);
    void transfer(const canopen::SdoRequest &request);
    void configure(const canopen::LssRequest &request);
    void cancelConfiguration() { post(canopen_command::CancelConfigure{}); }
    void scan() { post(canopen_command::Scan{}); } // all numbers are asked

Q_SIGNALS:
    void passed(const codewheel::CanopenRow &row, codewheel::Instant at);
    void frameSent(const codewheel::FrameSent &sent);
    void transferEnded(const codewheel::TransferEnded &ended);
    void configured(const codewheel::Configured &ended);
    void scanned(const codewheel::NodesScanned &scan); // some more, or all
    // While it is open: it cannot be watched for sure, and waits for takeUnsureWatch().
    void watchNotSure(const codewheel::Refusal &why);

private:
    Message openedMessage() const override;
    Message closedMessage() const override;
    void startAsking(NodeId node, const DeviceDescription &device) override;
    Result<void> mayAdd(NodeId node) const override;
    void takeOther(const CanopenEvent &event) override;
    void tellNmt(const FrameSent &sent);
    void tellWritten(const TransferEnded &ended);
    void accountFor(const std::optional<TypedWrite> &write);
    void tellEnd(const std::optional<TypedWrite> &write, TypedEnd end);
    std::optional<TypedWrite> storing(int node, const canopen::SdoObject &object, bool isWrite) const;
    std::optional<TypedWrite> storing(const CanFrame &frame) const;
    std::optional<TypedWrite> storing(const canopen::SdoRequest &request) const;
    std::optional<TypedWrite> storing(const canopen::LssRequest &request) const;

    const CanopenOutline m_outline;
    CanopenSettings m_settings;
    CanopenTraffic m_traffic;
    bool m_isUsuallyMapped = false; // the user says so
};

} // namespace codewheel
