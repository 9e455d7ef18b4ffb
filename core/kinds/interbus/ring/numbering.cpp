// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/numbering.h"

namespace codewheel {

void numberDevices(RingStructure &structure)
{
    DeviceNumber number;
    for (RingDevice &participant : structure) {
        number = nextNumber(number, isOnLocalBus(participant));
        participant.number = number.node();
    }
}

} // namespace codewheel
