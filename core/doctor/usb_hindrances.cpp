// SPDX-License-Identifier: GPL-3.0-or-later
#include "doctor/usb_hindrances.h"

#include "doctor/doctor_texts.h"
#include "doctor/usb_adapters.h"
#include "encoder/sentence.h"
#include "encoder/shell_command.h"

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

// Of our package: they keep adapters from ModemManager and brltty.
constexpr std::array ourRules{"/usr/lib/udev/rules.d/91-codewheel.rules",
                              "/lib/udev/rules.d/91-codewheel.rules", "/etc/udev/rules.d/60-codewheel.rules"};

bool hasOurRules(const Computer &computer)
{
    return std::ranges::any_of(ourRules,
                               [&](const char *path) { return computer.has(QString::fromLatin1(path)); });
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
                QStringLiteral("sudo systemctl mask --now brltty-udev.service")};
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
