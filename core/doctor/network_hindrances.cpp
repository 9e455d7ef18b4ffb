// SPDX-License-Identifier: GPL-3.0-or-later
#include "doctor/network_hindrances.h"

#include "doctor/doctor_texts.h"
#include "encoder/sentence.h"
#include "encoder/shell_command.h"

#include <unistd.h>

namespace codewheel {
namespace {

const QString interfaces = QStringLiteral("/sys/class/net/");

bool isCan(const QString &name, const Computer &computer)
{
    constexpr int can = 280; // ARPHRD_CAN of <linux/if_arp.h>
    return computer.contents(interfaces + name + QStringLiteral("/type")).toInt() == can;
}

bool isUp(const QString &name, const Computer &computer)
{
    constexpr unsigned up = 1; // IFF_UP of <linux/if.h>
    bool isNumber = false;
    const unsigned flags =
        computer.contents(interfaces + name + QStringLiteral("/flags")).toUInt(&isNumber, 0);
    return isNumber && (flags & up) != 0;
}

} // namespace

Hindrances canHindrances(const Computer &computer)
{
    Hindrances found;
    for (const QString &name : computer.folders(interfaces))
        if (isCan(name, computer) && !isUp(name, computer))
            found.push_back(
                {HindranceId::canDown, Hindrance::Weight::prevents, name,
                 sentence(
                     DoctorTexts::tr("The CAN interface %1 is switched off. Switch it on with the bit rate "
                                     "of the bus."),
                     {name}),
                 shellCommand(QStringLiteral("sudo ip link set %1 up type can bitrate 125000"), {name})});
    return found;
}

Hindrance privilegedPortHindrance(int port, Hindrance::Weight weight)
{
    return {HindranceId::privilegedPort, weight, QString::number(port),
            sentence(DoctorTexts::tr(
                         "A server at port %1 needs rights on this computer that you do not have. Use a "
                         "port from 1024 on, or allow it until the next start of the computer."),
                     {QString::number(port)}),
            shellCommand(QStringLiteral("sudo sysctl net.ipv4.ip_unprivileged_port_start=%1"),
                         {QString::number(port)})};
}

Hindrances serverPortHindrances(int port, Hindrance::Weight weight, const Computer &computer)
{
    const QByteArray first =
        computer.contents(QStringLiteral("/proc/sys/net/ipv4/ip_unprivileged_port_start"));
    if (::geteuid() == 0 || first.isEmpty() || port >= first.toInt())
        return {};
    return {privilegedPortHindrance(port, weight)};
}

} // namespace codewheel
