// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/plan/project_take_over.h"
#include "kinds/interbus/ring/id_code.h"
#include "kinds/interbus/words/device_number.h"
#include "tests/support/plans.h"

namespace codewheel {

inline constexpr int terminalsOfLargest = 8;
inline constexpr int localDevicesOfLargest = 63;

// As many as a ring may have: full local buses, alternating inputs and outputs.
inline Project largestProject()
{
    RingStructure ring;
    for (int segment = 1; segment <= terminalsOfLargest; ++segment) {
        RingDevice terminal = deviceOf(busTerminalIdCode);
        terminal.number = DeviceNumber{segment, 0}.node();
        ring.push_back(terminal);
        for (int position = 1; position <= localDevicesOfLargest; ++position) {
            RingDevice device = deviceOf(position % 2 == 0 ? 0x81BE : 0x81BD);
            device.number = DeviceNumber{segment, position}.node();
            ring.push_back(device);
        }
    }
    Project project = projectOf(ring);
    for (ProjectDevice &device : project.devices)
        device.station = QStringLiteral("station ") + device.place().toString();
    return project;
}

} // namespace codewheel
