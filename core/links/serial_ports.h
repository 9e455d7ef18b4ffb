// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

namespace codewheel {

// A serial port of this computer, and the adapter it belongs to; what the adapter does not report is empty.
struct PortInfo
{
    QString path{}; // "/dev/ttyUSB0"
    QString description{};
    QString manufacturer{};
    QString serialNumber{};
    QString usbPath{}; // where it is plugged in, with its interface: "1-2.4:1.0"
    int vendor = 0;    // of USB; 0: no USB adapter
    int product = 0;

    bool isUsb() const { return vendor != 0; }
    // "ttyUSB0, FT232R USB UART, FTDI, A50285BI"
    QString label() const;

    friend bool operator==(const PortInfo &, const PortInfo &) = default;
};

// The ports present now, by name.
std::vector<PortInfo> serialPorts();
// Shown instead of an empty list.
QString noSerialPortsText();

// The part of a device's path in /sys that says where on USB it is plugged in; empty for any other device.
QString usbPathOf(const QString &sysfsPath);

// Where an adapter is after it was plugged in again: by its serial number, otherwise by its place on USB. A
// different adapter is never taken for it unasked.
struct AdapterMatch
{
    enum class Kind : std::uint8_t {
        absent,
        found, // ports[0]
        ask,   // it may be one of these
    };

    Kind kind = Kind::absent;
    std::vector<PortInfo> ports{};

    friend bool operator==(const AdapterMatch &, const AdapterMatch &) = default;
};
AdapterMatch sameAdapter(const PortInfo &wanted, const std::vector<PortInfo> &present);

} // namespace codewheel
