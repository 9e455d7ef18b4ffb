// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus/present_ports.h"

#include "cli/call/texts.h"
#include "links/serial_ports.h"
#include "vocabulary/sentence.h"

namespace codewheel {
namespace {

const QString deviceFolder = QStringLiteral("/dev/");

} // namespace

QStringList presentPortNames()
{
    QStringList names;
    for (const PortInfo &port : serialPorts())
        names << (port.path.startsWith(deviceFolder) ? port.path.sliced(deviceFolder.size()) : port.path);
    return names;
}

QString presentPortsText()
{
    QStringList ports;
    for (const PortInfo &port : serialPorts())
        ports << port.label();
    return ports.isEmpty()
               ? noSerialPortsText()
               : sentence(CommandLine::tr("The ports there are: %1."), {ports.join(QStringLiteral("; "))});
}

} // namespace codewheel
