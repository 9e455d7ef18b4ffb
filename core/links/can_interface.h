// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "links/can_status.h"
#include "links/computer.h"

#include <functional>
#include <vector>

namespace codewheel {

// A SocketCAN interface of this computer. Rate, mode and state are those of the system: shown, never set.
struct CanInterface
{
    QString name{};
    bool isUp = false;
    bool isVirtual = false;    // no controller is behind it, as with vcan0
    bool isConfirming = false; // its driver tells when a frame was on the bus
    CanStatus status{};

    friend bool operator==(const CanInterface &, const CanInterface &) = default;
};

// Empty: it is not asked for.
using CanStatusOf = std::function<std::optional<CanStatus>(const QString &interface)>;

// Empty: there is none of this name, or it is not one for CAN.
std::optional<CanInterface> canInterface(const QString &name, const Computer &computer = Computer(),
                                         const CanStatusOf &statusOf = canStatus);
// By name.
std::vector<CanInterface> canInterfaces(const Computer &computer = Computer(),
                                        const CanStatusOf &statusOf = canStatus);

// For a command, where nobody has said which rate the bus has; Bd.
inline constexpr int proposedCanRate = 250'000;

// Commands for the user, never run by the program: to switch an interface on, to have it listen only or
// send, and to bring it back after bus off.
QString switchOnCommand(const CanInterface &interface, int rate);
QString listenOnlyCommand(const CanInterface &interface, int rate);
QString restartCommand(const QString &interface);

} // namespace codewheel
