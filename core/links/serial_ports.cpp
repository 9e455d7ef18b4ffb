// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/serial_ports.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QRegularExpression>
#include <QSerialPortInfo>

#include <algorithm>

namespace codewheel {

QString PortInfo::label() const
{
    QStringList parts{path.section(u'/', -1), description, manufacturer, serialNumber};
    parts.removeAll(QString());
    return parts.join(QStringLiteral(", "));
}

QString usbPathOf(const QString &sysfsPath)
{
    static const QRegularExpression interface(QStringLiteral(R"(^\d+-\d+(\.\d+)*:\d+\.\d+$)"));
    const QStringList parts = sysfsPath.split(u'/');
    const qsizetype place = parts.lastIndexOf(interface);
    return place < 0 ? QString() : parts[place];
}

std::vector<PortInfo> serialPorts()
{
    std::vector<PortInfo> ports;
    for (const QSerialPortInfo &port : QSerialPortInfo::availablePorts()) {
        const QFileInfo device(QStringLiteral("/sys/class/tty/%1/device").arg(port.portName()));
        ports.push_back({.path = port.systemLocation(),
                         .description = port.description(),
                         .manufacturer = port.manufacturer(),
                         .serialNumber = port.serialNumber(),
                         .usbPath = usbPathOf(device.canonicalFilePath()),
                         .vendor = port.hasVendorIdentifier() ? port.vendorIdentifier() : 0,
                         .product = port.hasProductIdentifier() ? port.productIdentifier() : 0});
    }
    std::ranges::sort(ports, {}, &PortInfo::path);
    return ports;
}

QString noSerialPortsText()
{
    return QCoreApplication::translate(
        "SerialPorts",
        "This computer has no serial port. Plug a USB adapter in, or type the path of a port.");
}

} // namespace codewheel
