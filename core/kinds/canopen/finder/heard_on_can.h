// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_frame.h"
#include "finder/found.h"
#include "kinds/canopen/bus/other_master.h"

#include <set>

namespace codewheel {

// Who is heard on a CAN bus, by the predefined identifiers of CANopen.
class HeardOnCan
{
public:
    void take(const CanFrame &frame);
    bool isAnything() const { return m_frames > 0; }
    bool hasErrors() const { return m_errors > 0; }
    bool isMasterAtWork() const { return m_master.isHeard(); }
    // "Nodes 5, 6 are heard."
    QString sentence() const;

private:
    std::set<int> m_nodes{};
    int m_frames = 0;
    int m_extended = 0;
    int m_errors = 0;
    OtherMaster m_master{};
};

// How to connect with the bus there: "can:can0", or "slcan:/dev/ttyACM0" and a rate in Bd.
Found canBusAt(const QString &place, const QString &link, std::optional<int> rate, const QString &sentence);

} // namespace codewheel
