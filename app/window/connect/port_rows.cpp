// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/connect/port_rows.h"

#include "app/window/connect/trouble_of.h"
#include "doctor/link_hindrances.h"
#include "links/port_access.h"
#include "widgets/connect/connect_page.h"

#include <QStringList>

#include <algorithm>

namespace codewheel {
namespace {

// An adapter without a port is probably the one that is looked for; otherwise why the first port that cannot
// be opened cannot. What only slows, such as ModemManager, comes last.
Trouble troubleWith(const std::vector<PortInfo> &ports)
{
    const Computer computer; // looks at the processes once
    const Hindrances adapters = usbHindrances(computer);
    const auto without = std::ranges::find(adapters, Hindrance::Weight::prevents, &Hindrance::weight);
    if (without != adapters.end())
        return troubleOf(*without);
    if (ports.empty())
        return noSerialPortsText();
    for (const PortInfo &port : ports)
        if (const auto hindrance = openingHindrance(port.path, computer))
            return troubleOf(*hindrance);
    return adapters.empty() ? Trouble() : troubleOf(adapters.front());
}

} // namespace

void tellCommand(ConnectPage &page, const Refusal &why)
{
    if (const Trouble trouble = troubleOf(why); !trouble.command.isEmpty())
        page.setProblem(trouble);
}

PortRows portRows(const std::vector<PortInfo> &ports)
{
    PortRows listed{.rows = {}, .trouble = troubleWith(ports)};
    for (const PortInfo &port : ports)
        listed.rows.push_back({port.path, port.description, port.serialNumber});
    return listed;
}

QStringList adapterRows()
{
    QStringList rows;
    for (const PortInfo &port : serialPorts())
        rows << QStringLiteral("%1: %2; USB %3:%4, at %5")
                    .arg(port.path, port.label())
                    .arg(port.vendor, 4, 16, QChar(u'0'))
                    .arg(port.product, 4, 16, QChar(u'0'))
                    .arg(port.usbPath);
    return rows;
}

} // namespace codewheel
