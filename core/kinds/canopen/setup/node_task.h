// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/bus/canopen_snapshot.h"
#include "kinds/canopen/protocol/lss_client.h"
#include "kinds/canopen/protocol/nmt.h"
#include "kinds/canopen/protocol/sdo_client.h"

#include <variant>

namespace codewheel::canopen {

// Something that is done with a device in several requests, each of which is given once and ends before the
// next one. A state machine without I/O, carried out by NodeTaskRun.
class NodeTask
{
public:
    using Request = std::variant<LssRequest, SdoRequest, NmtRequest>;

    virtual ~NodeTask() = default;

    // Empty: it has ended, or waits for something on the bus.
    virtual std::optional<Request> next(const CanopenSnapshot &bus) = 0;
    virtual void answered(const LssOutcome &) {}
    virtual void answered(const SdoOutcome &) {}
    virtual void sent(CanFate) {} // a command, which nobody answers
    virtual bool isEnded() const = 0;
    // What is not sent yet is not sent any more, apart from what leaves a device as it should be.
    virtual void cancel() = 0;
};

} // namespace codewheel::canopen
