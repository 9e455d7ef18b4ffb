// SPDX-License-Identifier: GPL-3.0-or-later
#include "doctor/hindrance_of_refusal.h"

#include "doctor/link_hindrances.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "vocabulary/shell_command.h"

#include <algorithm>

namespace codewheel {
namespace {

using Weight = Hindrance::Weight;

QString firstText(const Refusal &why)
{
    return why.arguments.empty() ? QString() : argumentText(why.arguments.front());
}

// The whole sentence of the refusal, with a command.
Hindrance asRefused(HindranceId id, const Refusal &why, const QString &command)
{
    return {id, Weight::prevents, firstText(why), refusalText(why), command};
}

Hindrance takenPort(const Refusal &why, const Computer &computer)
{
    const auto holders = holderHindrances(firstText(why), computer);
    return holders.empty() ? asRefused(HindranceId::portTaken, why,
                                       shellCommand(QStringLiteral("sudo fuser -v %1"), {firstText(why)}))
                           : holders.front();
}

// An adapter that is plugged in but has no port is probably the one that is looked for.
Hindrance missingPort(const Refusal &why, const Computer &computer)
{
    const auto adapters = usbHindrances(computer);
    const auto without = std::ranges::find(adapters, Weight::prevents, &Hindrance::weight);
    return without != adapters.end()
               ? *without
               : asRefused(HindranceId::portMissing, why, QStringLiteral("ls -l /dev/serial/by-id"));
}

// "192.168.0.5:502", "[fe80::1]:502"
QString hostOf(const QString &address)
{
    return address.section(u':', 0, -2).remove(u'[').remove(u']');
}

} // namespace

std::optional<Hindrance> hindranceOf(const Refusal &why, const Computer &computer)
{
    const QString place = firstText(why);
    const auto id = why.id.as<RefusalId>();
    if (!id)
        return canHindranceOf(why);
    switch (*id) {
    case RefusalId::portNoRights:
        return rightsHindrance(place, computer);
    case RefusalId::portInUse:
        return takenPort(why, computer);
    case RefusalId::portNotFound:
        return missingPort(why, computer);
    case RefusalId::serverPortPrivileged:
        return privilegedPortHindrance(static_cast<int>(std::get<std::int64_t>(why.arguments.front())),
                                       Weight::prevents, computer);
    case RefusalId::serverPortTaken:
        return asRefused(HindranceId::serverPortTaken, why,
                         shellCommand(QStringLiteral("ss -ltnp \"sport = :%1\""),
                                      {QString::number(std::get<std::int64_t>(why.arguments.front()))}));
    case RefusalId::hostNotFound:
        return asRefused(HindranceId::hostUnknown, why,
                         shellCommand(QStringLiteral("getent hosts %1"), {place}));
    case RefusalId::connectionRefused:
        return asRefused(
            HindranceId::hostRefuses, why,
            shellCommand(QStringLiteral("nc -vz %1 %2"), {hostOf(place), place.section(u':', -1)}));
    case RefusalId::connectionSilent:
        return asRefused(HindranceId::hostSilent, why,
                         shellCommand(QStringLiteral("ping -c 3 %1"), {hostOf(place)}));
    default:
        return std::nullopt;
    }
}

} // namespace codewheel
