// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "links/computer.h"

namespace codewheel {

// A USB adapter of a make that has serial ports, and what the system has made of it.
struct UsbAdapter
{
    QString name{};   // "FT232R USB UART", as it reports itself; otherwise "USB 0403:6001"
    QString ids{};    // "0403:6001", vendor and product
    QString driver{}; // that belongs to it: "ftdi_sio"
    bool hasPort = false;
    bool isClaimed = false; // by a program, past every driver

    friend bool operator==(const UsbAdapter &, const UsbAdapter &) = default;
};

// The module of Linux 6.1 for adapters with these IDs of USB, such as "0403" and "6001": "ftdi_sio". Empty:
// they are no serial adapters, or not known.
QString serialDriverOf(const QByteArray &vendor, const QByteArray &product);

// Those that are plugged in, by place.
std::vector<UsbAdapter> usbAdapters(const Computer &computer);

} // namespace codewheel
