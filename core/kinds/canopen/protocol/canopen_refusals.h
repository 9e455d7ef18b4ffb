// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/refusal.h"

namespace codewheel {

// What only an encoder on CANopen or its bus refuses. The comment beside each lists its arguments. An object
// is its text, "6001h:0".
enum class CanopenRefusalId : std::uint8_t {
    sdoAborted,        // object, Word abort code
    sdoNoAnswer,       // object, node
    sdoNotSent,        // object, node
    sdoWriteUnknown,   // object: no answer, and what the encoder has now could not be read
    sdoWriteNotDone,   // object: no answer, and the encoder has the old value
    storingUnknown,    // node: no answer to the command that stores
    nodeWouldStop,     // node: it is running, and what is wanted stops it
    notBackAfterReset, // node, seconds
    nodeRestarted,     // node: during a job
    presetNotInForce,  // position wanted, position shown
    nodeDoubled,       // node
    notStartedAgain,   // node: stopped for a write, and started again without success
    startNotSeen,      // node: likewise, and it does not show its state
    makeDiffers,       // object, Word vendor number of the description, Word vendor number of the device
    otherProfile,      // node, profile that it tells: what was wanted has another meaning there
    nodeMayRun,        // node: its state is not known, and what is wanted would stop it
};
extern const RefusalFamily canopenRefusals;
constexpr const RefusalFamily &familyOf(CanopenRefusalId)
{
    return canopenRefusals;
}

namespace canopen {

// The user may agree that the node is stopped.
inline bool isAboutStopping(const Refusal &why)
{
    return why.id == CanopenRefusalId::nodeWouldStop || why.id == CanopenRefusalId::nodeMayRun;
}

// Nobody knows of whom an answer was, nor who has taken what was sent.
inline Refusal nodeIsDoubled(int node)
{
    return {RefusalKind::link, CanopenRefusalId::nodeDoubled, {std::int64_t{node}}};
}

} // namespace canopen
} // namespace codewheel
