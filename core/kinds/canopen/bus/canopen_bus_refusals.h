// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/refusal.h"

namespace codewheel {

// What only a bus with CANopen refuses. The comment beside each lists its arguments.
enum class CanopenBusRefusalId : std::uint8_t {
    nodeNumberWrong, // the text given
    otherMaster,     // what was heard of it
    searching,       //
    closed,          //
    onlyJ1939,       // nothing else was heard
};
extern const RefusalFamily canopenBusRefusals;
constexpr const RefusalFamily &familyOf(CanopenBusRefusalId)
{
    return canopenBusRefusals;
}

} // namespace codewheel
