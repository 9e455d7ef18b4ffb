// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/buses/bus_views.h"
#include "app/window/connect/port_rows.h"
#include "finder/place_finder.h"
#include "widgets/help/key_help.h"

#include <span>

namespace codewheel {

// A kind of bus in the window: how its buses work, and what they add to the window.
struct WindowKind
{
    QString bus; // key of its BusKind
    // Null: projects do not plan such a bus (Recordings).
    std::unique_ptr<BusAtWork> (*make)(BusId id, const BusAtWork::Surroundings &surroundings);
    // Null: its buses are only shown in the bus structure and in the panels of a device.
    BusViews *(*makeViews)(BusAtWork &bus, const WindowParts &parts, QObject *parent) = nullptr;
    std::span<const Panel *const> panels{}; // with a page for each of its buses
    QStringList (*adapters)() = nullptr;    // of this computer, for support; null: it has none
    // Looks who is at a host, on a bus of this kind; null: it is at no host.
    HostSearch (*hostSearch)(const QString &host, int port) = nullptr;
    KeyGroup (*keys)() = nullptr; // that its views answer without actions; null: none
    // What of this computer, beside its serial ports, can be listened to, and why something cannot; null:
    // nothing.
    PortRows (*interfaces)() = nullptr;
    // Listens at such an interface; null: it is none of this kind.
    std::unique_ptr<PlaceFinder> (*listenAt)(const QString &interface) = nullptr;
};

// Those of the program, and the added ones; in the order of the panels.
std::vector<const WindowKind *> windowKinds();
const WindowKind *windowKind(QStringView bus); // null: the program has no link for it
void addWindowKind(WindowKind kind);           // before the window is made

} // namespace codewheel
