// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_frame.h"
#include "catalog/device_description.h"
#include "kinds/canopen/protocol/kept_identifier.h"
#include "kinds/canopen/protocol/nmt.h"
#include "kinds/canopen/protocol/pdo_mapping.h"
#include "kinds/canopen/protocol/sdo_client.h"
#include "vocabulary/event.h"
#include "vocabulary/message.h"

#include <memory>
#include <span>
#include <variant>

namespace codewheel::canopen {

using NodeRequest = std::variant<SdoRequest, NmtRequest>;

// Drives one encoder on CANopen: says what it wants to ask or command, and makes a reading of its answers and
// of what it sends by itself. Asked by the runner of the bus, which owns the transfers; no I/O and no clock.
class NodeDriver
{
public:
    virtual ~NodeDriver() = default;

    virtual const Reading &reading() const = 0;
    // What the node was heard or told to be in; empty: not known.
    virtual std::optional<NmtState> state() const = 0;
    virtual bool busy() const = 0;
    virtual void setKnown(const std::vector<Known> &known) = 0;
    // Refused: the encoder cannot do the job or goes by another profile, or it would stop a node that
    // runs, or may, and mayStopNode() was not called.
    virtual Result<void> begin(JobId id, const Job &job, Pace pace, Instant now) = 0;
    // The user agrees that the next job stops the node, where it takes something only then, and starts it
    // again.
    virtual void mayStopNode(bool may) = 0;
    virtual void proceed() = 0;
    virtual void cancel(OnCancel how, Instant now) = 0;
    // Ends the job at once. A request under way is answered to answered() all the same, or never if the bus
    // is gone.
    virtual void stop(const Refusal &why, Instant now) = 0;

    // When next() will want something, if nothing comes in before; empty: it waits for the user.
    virtual std::optional<Instant> wakesAt() const = 0;
    // The request wanted at `now`, given once; answered() follows before next() is called again, for a
    // command with the kind written or notSent. Only called while frames may be sent.
    virtual std::optional<NodeRequest> next(Instant now) = 0;
    virtual void answered(const NodeRequest &request, const SdoOutcome &outcome, Instant now) = 0;

    // What was asked or written by hand, and how it ended.
    virtual void observe(const SdoRequest &request, const SdoOutcome &outcome, Instant now) = 0;
    // What this node sent that is no SDO: PDO, emergency, heartbeat, boot-up; SDO requests to it, SYNC and
    // NMT of others.
    virtual void take(const CanFrame &frame, Instant now) = 0;
    // The bus is gone, and what answers when it is back may be another device. Its job was stopped before.
    virtual void lost(Instant now) = 0;
    // It stores or restores, or was reset: its silence is no fault.
    virtual bool mayBeSilent() const = 0;

    virtual int node() const = 0;
    // Object 1000h; empty: it was not read, or the node does not tell it.
    virtual std::optional<std::uint32_t> deviceType() const = 0;
    // The PDOs that it sends, as far as they were read from it.
    virtual std::span<const PdoMapping> transmitPdos() const = 0;
    // Identifiers that it has and are not those of its number, as far as they were read.
    virtual std::span<const KeptIdentifier> keptIdentifiers() const = 0;
    // What happened since the last call, oldest first.
    virtual std::vector<Event> takeEvents() = 0;
    virtual std::vector<Message> takeMessages() = 0;

    // An SDO frame from or to this node, whoever sent it: it may tell what its PDOs hold.
    virtual void hear(const SdoFrame &sdo) = 0;
    // The user says that its first PDO holds the position in front, as CiA 406 has it. What was read or heard
    // goes before.
    virtual void takeUsualMapping() = 0;
};

// Null: the device is not for CANopen. The description must outlive the driver.
std::unique_ptr<NodeDriver> makeNodeDriver(const DeviceDescription &device, int node);

} // namespace codewheel::canopen
