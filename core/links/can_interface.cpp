// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/can_interface.h"

#include "vocabulary/shell_command.h"

namespace codewheel {
namespace {

const QString networkInterfaces = QStringLiteral("/sys/class/net/");

} // namespace

std::optional<CanInterface> canInterface(const QString &name, const Computer &computer,
                                         const CanStatusOf &statusOf)
{
    constexpr int can = 280;             // ARPHRD_CAN of <linux/if_arp.h>
    constexpr unsigned up = 0x1;         // IFF_UP of <linux/if.h>
    constexpr unsigned echoes = 0x40000; // IFF_ECHO
    const QString folder = networkInterfaces + name;
    if (name.contains(u'/') || computer.contents(folder + QStringLiteral("/type")).toInt() != can)
        return std::nullopt;
    const unsigned flags = computer.contents(folder + QStringLiteral("/flags")).toUInt(nullptr, 0);
    CanInterface found{.name = name,
                       .isUp = (flags & up) != 0,
                       .isVirtual = computer.canonical(folder).contains(QStringLiteral("/virtual/")),
                       .isConfirming = (flags & echoes) != 0};
    if (statusOf)
        found.status = statusOf(name).value_or(CanStatus());
    return found;
}

std::vector<CanInterface> canInterfaces(const Computer &computer, const CanStatusOf &statusOf)
{
    std::vector<CanInterface> found;
    for (const QString &name : computer.folders(networkInterfaces))
        if (auto interface = canInterface(name, computer, statusOf))
            found.push_back(*std::move(interface));
    return found;
}

QString switchOnCommand(const CanInterface &interface, int rate)
{
    return interface.isVirtual ? shellCommand(QStringLiteral("sudo ip link set %1 up"), {interface.name})
                               : shellCommand(QStringLiteral("sudo ip link set %1 up type can bitrate %2"),
                                              {interface.name, QString::number(rate)});
}

// It takes another mode only while it is switched off.
QString listenOnlyCommand(const CanInterface &interface, int rate)
{
    return shellCommand(QStringLiteral("sudo ip link set %1 down && sudo ip link set %1 up type can bitrate "
                                       "%2 listen-only on"),
                        {interface.name, QString::number(interface.status.rate.value_or(rate))});
}

QString restartCommand(const QString &interface)
{
    return shellCommand(QStringLiteral("sudo ip link set %1 type can restart"), {interface});
}

} // namespace codewheel
