// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_link.h"

#include <QByteArray>
#include <QString>

namespace codewheel {

// What the system says of the rate, the mode and the state of a CAN interface; it is asked by rtnetlink, as
// "ip -details link show" does. Empty: it says nothing, as of an interface that is not real. Needs no rights.
std::optional<CanStatus> canStatus(const QString &interface);

// The same in the system's answer (linux/rtnetlink.h, linux/can/netlink.h).
std::optional<CanStatus> canStatusOf(const QByteArray &answer);

} // namespace codewheel
