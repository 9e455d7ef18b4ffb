// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/kind_data.h"
#include "vocabulary/place.h"

#include <QString>

namespace codewheel {

struct DeviceDescription;

// One device of a bus, as found there and as named by the plan.
struct Participant
{
    NodeId number;           // "6.1", "esc:12"
    unsigned deviceCode = 0; // by which its bus tells what it is, on INTERBUS 0237h; 0: it does not
    QString deviceKey;       // catalog key, empty where the make is not known
    KindData details{}; // of its kind of bus, such as the width of its data; empty: nothing is known of it

    friend bool operator==(const Participant &, const Participant &) = default;
};

// What to call it: the name of its description, or without one (null) "device not known".
QString participantName(const DeviceDescription *description);

} // namespace codewheel
