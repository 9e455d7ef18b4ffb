// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/nmt.h"
#include "vocabulary/job.h"

namespace codewheel::canopen {

// What a job of this kind of encoder alone is (KindJob): the node goes to another state.
struct NmtJob
{
    NmtCommand command = NmtCommand::start;

    friend bool operator==(const NmtJob &, const NmtJob &) = default;
};

inline Job nmtJob(NmtCommand command)
{
    return KindJob{KindData(NmtJob{command})};
}

inline bool isReset(NmtCommand command)
{
    return command == NmtCommand::resetNode || command == NmtCommand::resetCommunication;
}

} // namespace codewheel::canopen
