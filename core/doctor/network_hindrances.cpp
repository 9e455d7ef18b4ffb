// SPDX-License-Identifier: GPL-3.0-or-later
#include "doctor/doctor_texts.h"
#include "doctor/link_hindrances.h"
#include "vocabulary/sentence.h"
#include "vocabulary/shell_command.h"

namespace codewheel {
namespace {

// The first one at which everybody may listen; empty: the system does not say.
std::optional<int> firstFreePort(const Computer &computer)
{
    bool isNumber = false;
    const int first =
        computer.contents(QStringLiteral("/proc/sys/net/ipv4/ip_unprivileged_port_start")).toInt(&isNumber);
    return isNumber ? std::optional(first) : std::nullopt;
}

// As root has it, or a program that was given it (capabilities(7)).
bool mayServeAnyPort(const Computer &computer)
{
    constexpr int netBindService = 10;
    const QByteArray key = "CapEff:";
    for (const QByteArray &line : computer.contents(QStringLiteral("/proc/self/status")).split('\n'))
        if (line.startsWith(key))
            return ((line.mid(key.size()).trimmed().toULongLong(nullptr, 16) >> netBindService) & 1U) != 0;
    return false;
}

} // namespace

Hindrance privilegedPortHindrance(int port, Hindrance::Weight weight, const Computer &computer)
{
    constexpr int usualFirst = 1'024;
    const int first = firstFreePort(computer).value_or(usualFirst);
    return {HindranceId::privilegedPort, weight, QString::number(port),
            sentence(DoctorTexts::tr(
                         "A server at port %1 needs rights on this computer that you do not have. Use a "
                         "port from %2 on, or allow it until the next start of the computer."),
                     {QString::number(port), QString::number(first)}),
            shellCommand(QStringLiteral("sudo sysctl net.ipv4.ip_unprivileged_port_start=%1"),
                         {QString::number(port)})};
}

Hindrances serverPortHindrances(int port, Hindrance::Weight weight, const Computer &computer)
{
    if (mayServeAnyPort(computer) || port >= firstFreePort(computer).value_or(0))
        return {};
    return {privilegedPortHindrance(port, weight, computer)};
}

} // namespace codewheel
