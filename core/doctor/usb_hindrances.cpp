// SPDX-License-Identifier: GPL-3.0-or-later
#include "doctor/doctor_texts.h"
#include "doctor/link_hindrances.h"
#include "doctor/usb_adapters.h"
#include "vocabulary/sentence.h"
#include "vocabulary/shell_command.h"

namespace codewheel {
namespace {

// Those of our package keep adapters from ModemManager and brltty, unless the administrator has put an empty
// file in their place.
bool hasOurRules(const Computer &computer)
{
    const QString rules = QStringLiteral("/udev/rules.d/91-codewheel.rules");
    if (computer.has(QStringLiteral("/etc") + rules))
        return !computer.contents(QStringLiteral("/etc") + rules).isEmpty();
    return computer.has(QStringLiteral("/usr/lib") + rules) || computer.has(QStringLiteral("/lib") + rules);
}

// Some systems start it by udev for the adapters that it takes; on Debian 12 it is a service like others.
QString brlttyService(const Computer &computer)
{
    const QString byUdev = QStringLiteral("brltty-udev.service");
    const bool isByUdev = computer.has(QStringLiteral("/usr/lib/systemd/system/") + byUdev) ||
                          computer.has(QStringLiteral("/lib/systemd/system/") + byUdev);
    return isByUdev ? byUdev : QStringLiteral("brltty.service");
}

bool isTakenByBrltty(const UsbAdapter &adapter, const Computer &computer)
{
    return computer.runs(QStringLiteral("brltty")) ||
           (adapter.isClaimed && computer.has(QStringLiteral("/usr/bin/brltty")));
}

Hindrance withoutPort(const UsbAdapter &adapter, const Computer &computer)
{
    if (isTakenByBrltty(adapter, computer))
        return {HindranceId::takenByBrltty, Hindrance::Weight::prevents, adapter.name,
                sentence(DoctorTexts::tr(
                             "The adapter %1 has no port: brltty takes it for a Braille display. Unless you "
                             "use one, switch that off and plug the adapter in again."),
                         {adapter.name}),
                shellCommand(QStringLiteral("sudo systemctl mask --now %1"), {brlttyService(computer)})};
    return {HindranceId::noDriver, Hindrance::Weight::prevents, adapter.name,
            sentence(DoctorTexts::tr(
                         "The adapter %1 (%2) is plugged in, but no driver has made a port of it. Load its "
                         "driver."),
                     {adapter.name, adapter.ids}),
            shellCommand(QStringLiteral("sudo modprobe %1"), {adapter.driver})};
}

} // namespace

Hindrances usbHindrances(const Computer &computer)
{
    Hindrances found;
    const auto adapters = usbAdapters(computer);
    for (const UsbAdapter &adapter : adapters)
        if (!adapter.hasPort)
            found.push_back(withoutPort(adapter, computer));
    if (!adapters.empty() && computer.runs(QStringLiteral("ModemManager")) && !hasOurRules(computer))
        found.push_back(
            {HindranceId::modemManager,
             Hindrance::Weight::slows,
             {},
             DoctorTexts::tr(
                 "ModemManager runs: for some seconds after an adapter is plugged in, it sends to it to "
                 "find a modem, and nobody else can use the port. Stop it if you need no modem."),
             QStringLiteral("sudo systemctl stop ModemManager.service")});
    return found;
}

} // namespace codewheel
