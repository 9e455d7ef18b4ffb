// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/place.h"

#include <QString>

namespace codewheel {

struct DeviceDescription;

inline constexpr unsigned busTerminalIdCode = 0x0C;

// One device of a bus, as found there and as named by the plan. On INTERBUS the master finds it (ID
// register); the vendor is not in the ID code: without a plan, deviceKey is empty and the make is not known.
// On a serial line there are only its place and its key.
struct Participant
{
    NodeId number;           // "6.1", "esc:12"
    unsigned idCode = 0;     // 37h
    unsigned deviceCode = 0; // length code << 8 | ID code: 0237h
    int inWords = 0;         // 16 bit each
    int outWords = 0;
    QString deviceKey; // catalog key, empty where the make is not known
    int level = 0;     // of the remote bus, 0..15: 0 is the main line, each branch one more

    friend bool operator==(const Participant &, const Participant &) = default;
};

// What to call it: the name of its description, or without one (null) "bus terminal" or "device not known".
QString participantName(const Participant &participant, const DeviceDescription *description);

} // namespace codewheel
