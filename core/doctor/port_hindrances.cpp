// SPDX-License-Identifier: GPL-3.0-or-later
#include "doctor/doctor_texts.h"
#include "doctor/link_hindrances.h"
#include "doctor/port_lock.h"
#include "links/port_access.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "vocabulary/shell_command.h"

#include <algorithm>
#include <array>
#include <pwd.h>
#include <unistd.h>

namespace codewheel {
namespace {

constexpr int slowFrom = 3; // ms

using enum HindranceId;
using Weight = Hindrance::Weight;

// Whether the system's list of groups has the user in it.
bool isMember(const QString &group, const Computer &computer)
{
    const passwd *user = ::getpwuid(::getuid());
    if (user == nullptr)
        return false;
    const QByteArray begin = group.toLocal8Bit() + ':';
    for (const QByteArray &line : computer.contents(QStringLiteral("/etc/group")).split('\n'))
        if (line.startsWith(begin))
            return line.mid(line.lastIndexOf(':') + 1)
                .trimmed()
                .split(',')
                .contains(QByteArray(user->pw_name));
    return false;
}

// What is ended comes back, unless its service is switched off. One that the system makes at each start, as
// for its console, has to be masked.
QString noLoginCommand(const QString &path, const Computer &computer)
{
    const QString service =
        QStringLiteral("serial-getty@%1.service").arg(computer.canonical(path).section(u'/', -1));
    const bool isMade = computer.has(QStringLiteral("/run/systemd/generator/getty.target.wants/") + service);
    return shellCommand(isMade ? QStringLiteral("sudo systemctl mask --now %1")
                               : QStringLiteral("sudo systemctl disable --now %1"),
                        {service});
}

bool offersLogin(const Process &holder)
{
    return holder.name == QStringLiteral("agetty") || holder.name == QStringLiteral("login");
}

// A daemon is stopped, any other program ended.
QString endCommand(const Process &holder)
{
    constexpr std::array daemons{"ModemManager", "brltty"};
    const auto daemon =
        std::ranges::find_if(daemons, [&](const char *name) { return holder.name == QLatin1String(name); });
    return daemon != daemons.end()
               ? shellCommand(QStringLiteral("sudo systemctl stop %1.service"), {holder.name})
               : shellCommand(holder.isOfOther ? QStringLiteral("sudo kill %1") : QStringLiteral("kill %1"),
                              {QString::number(holder.id)});
}

Hindrance heldBy(const Process &holder, const QString &path, const Computer &computer)
{
    if (holder.isOurs)
        return {portTaken, Weight::prevents, path,
                sentence(DoctorTexts::tr("%1 is in use by another bus of this program. Disconnect that one."),
                         {path})};
    if (offersLogin(holder))
        return {
            portTaken, Weight::prevents, path,
            sentence(DoctorTexts::tr("The system offers a login at %1 (%2, process %3). Switch that off if "
                                     "nobody logs in there."),
                     {path, holder.name, QString::number(holder.id)}),
            noLoginCommand(path, computer)};
    return {
        portTaken, Weight::prevents, path,
        sentence(DoctorTexts::tr("%1 is in use by the program %2 (process %3). Close it there, or end it."),
                 {path, holder.name, QString::number(holder.id)}),
        endCommand(holder)};
}

Hindrance lockedBy(const QString &file, const QString &path)
{
    return {portLocked, Weight::prevents, path,
            sentence(DoctorTexts::tr("The file %2 keeps %1 for a program that has ended. Remove it."),
                     {path, file}),
            shellCommand(QStringLiteral("sudo rm %1"), {file})};
}

// No group for serial ports may use it; joining another would give away more than the port.
QString noGroupText(const QString &path)
{
    return mayGroupUse(path)
               ? sentence(
                     DoctorTexts::tr(
                         "You may not use %1. Its group %2 may, but that is no group for serial ports: "
                         "do not join it. Let yourself use the port until it is unplugged or the computer "
                         "starts again."),
                     {path, groupOf(path)})
               : sentence(
                     DoctorTexts::tr("You may not use %1, and no group of users may. Let yourself use it "
                                     "until it is unplugged or the computer starts again."),
                     {path});
}

// FTDI adapters; others have no such timer.
std::optional<Hindrance> latencyHindrance(const QString &path, const Computer &computer)
{
    const QString name = computer.canonical(path).section(u'/', -1);
    const QString timer = QStringLiteral("/sys/bus/usb-serial/devices/%1/latency_timer").arg(name);
    const int latency = computer.contents(timer).toInt();
    if (latency < slowFrom)
        return std::nullopt;
    return Hindrance{
        slowPort, Weight::slows, path,
        sentence(DoctorTexts::tr("The adapter of %1 collects bytes for up to %2 ms, which slows down every "
                                 "answer, until a program asks for low latency as Codewheel does."),
                 {path, QString::number(latency)}),
        shellCommand(QStringLiteral("echo 1 | sudo tee %1"), {timer})};
}

} // namespace

Hindrance rightsHindrance(const QString &path, const Computer &computer)
{
    if (!isForGroup(path))
        return {noRightsForAnyone, Weight::prevents, path, noGroupText(path), rightsCommand(path)};
    const QString group = groupOf(path);
    if (isMember(group, computer))
        return {
            rightsAtNextLogin, Weight::prevents, path,
            sentence(DoctorTexts::tr(
                         "You may not use %1 yet: you are in its group %2 from your next login on. Log out "
                         "and in again. In a terminal, this is enough."),
                     {path, group}),
            shellCommand(QStringLiteral("newgrp %1"), {group})};
    return {noRights, Weight::prevents, path,
            sentence(DoctorTexts::tr(
                         "You may not use %1: you are not in its group %2. Join it, then log out and in "
                         "again."),
                     {path, group}),
            rightsCommand(path)};
}

std::vector<Hindrance> holderHindrances(const QString &path, const Computer &computer)
{
    Hindrances found;
    for (const Process &holder : computer.holdersOf(path))
        found.push_back(heldBy(holder, path, computer));
    if (!found.empty())
        return found;
    if (const auto locker = lockerOf(path, computer))
        return {heldBy(*locker, path, computer)};
    if (const QString lock = staleLock(path, computer); !lock.isEmpty())
        return {lockedBy(lock, path)};
    return {};
}

Hindrances portHindrances(const QString &path, const Computer &computer)
{
    const auto hindrance = portHindrance(path);
    if (hindrance && hindrance->id == RefusalId::portNotFound)
        return {{portMissing, Weight::prevents, path,
                 sentence(DoctorTexts::tr("There is no port %1. Plug its adapter in, and see whether the "
                                          "system names it."),
                          {path}),
                 QStringLiteral("ls -l /dev/serial/by-id")}};
    if (hindrance && hindrance->id == RefusalId::linkFailed)
        return {{notAPort, Weight::prevents, path, refusalText(*hindrance), {}}};
    Hindrances found = holderHindrances(path, computer);
    if (hindrance && hindrance->id == RefusalId::portNoRights)
        found.insert(found.begin(), rightsHindrance(path, computer));
    if (auto slow = latencyHindrance(path, computer))
        found.push_back(*std::move(slow));
    return found;
}

} // namespace codewheel
