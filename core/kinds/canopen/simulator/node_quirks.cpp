// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/simulator/node_quirks.h"

namespace codewheel::canopen {
namespace {

constexpr Instant silenceOfStore = std::chrono::milliseconds(400); // as Gotting's

template <bool NodeQuirks::*flag>
constexpr NamedQuirk switchable(const char *key)
{
    return {key, [](const NodeQuirks &its) { return its.*flag; },
            [](NodeQuirks &its, bool on) { its.*flag = on; }};
}

constexpr std::array quirkRows{
    switchable<&NodeQuirks::startsItself>("autostart"),
    switchable<&NodeQuirks::hasFixedMapping>("fixed-mapping"),
    switchable<&NodeQuirks::rangeIsHighest>("highest-range"),
    switchable<&NodeQuirks::keepsIdentifiers>("keeps-identifiers"),
    switchable<&NodeQuirks::keepsPreset>("keeps-preset"),
    switchable<&NodeQuirks::lssForgets>("lss-forgets"),
    switchable<&NodeQuirks::lssOnlyWhenStopped>("lss-stopped"),
    NamedQuirk{"restore-at-once",
               [](const NodeQuirks &its) { return its.restore == NodeQuirks::Restore::atOnce; },
               [](NodeQuirks &its, bool on) {
                   its.restore = on ? NodeQuirks::Restore::atOnce : NodeQuirks::Restore::afterReset;
               }},
    NamedQuirk{"silent-store", [](const NodeQuirks &its) { return its.silenceWhileStoring > Instant{}; },
               [](NodeQuirks &its, bool on) { its.silenceWhileStoring = on ? silenceOfStore : Instant{}; }},
    switchable<&NodeQuirks::speedIsOff>("speed-off"),
    switchable<&NodeQuirks::hasSwitches>("switches"),
    switchable<&NodeQuirks::writesOnlyPreOperational>("writes-pre-operational"),
};

} // namespace

std::span<const NamedQuirk> namedQuirks()
{
    return quirkRows;
}

} // namespace codewheel::canopen
