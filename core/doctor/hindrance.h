// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

namespace codewheel {

enum class HindranceId : std::uint8_t {
    noPort,            // there is no serial port at all
    portMissing,       // this one is not there
    notAPort,          // a file, a disk, a device of another kind
    noRights,          // the port's group may use it, the user is not in it
    rightsAtNextLogin, // the user is in it, but was not when logging in
    noRightsForAnyone, // no group may use it, or one that should not be joined
    portTaken,         // by a program
    slowPort,          // the adapter collects bytes
    noDriver,          // an adapter without a port
    takenByBrltty,     // an adapter that is taken for a Braille display
    modemManager,      // sends to adapters to find modems
    canDown,           //
    privilegedPort,    // of a server
    serverPortTaken,   //
    hostUnknown,       //
    hostRefuses,       //
    hostSilent,        //
    portLocked,        // by a program that has ended
    canMissing,        // there is no such CAN interface
    noCan,             // the kernel has none
    noCanPlugin,       // of Qt
};
QString hindranceKey(HindranceId id); // language-neutral: "noRights"

// What keeps a link from working, and what to do: a sentence, and one command for a terminal.
struct Hindrance
{
    enum class Weight : std::uint8_t {
        prevents, // it does not work
        slows,    // it works, but not well
        remark,   // it would prevent something that nobody may want
    };

    HindranceId id = HindranceId::noPort;
    Weight weight = Weight::prevents;
    QString about{}; // "/dev/ttyUSB0", "can0", "192.168.0.5:502"; empty: the whole computer
    QString sentence{};
    QString command{}; // empty: none helps

    friend bool operator==(const Hindrance &, const Hindrance &) = default;
};
using Hindrances = std::vector<Hindrance>;

QString weightKey(Hindrance::Weight weight); // "prevents"

} // namespace codewheel
