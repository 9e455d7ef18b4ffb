// SPDX-License-Identifier: GPL-3.0-or-later
#include "doctor/doctor.h"

#include "doctor/link_hindrances.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr int modbusPort = 502; // of Modbus/TCP

void append(Hindrances &to, Hindrances more)
{
    to.insert(to.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

} // namespace

Hindrances examine(const std::vector<PortInfo> &ports, const Computer &computer)
{
    Hindrances found = usbHindrances(computer);
    if (ports.empty())
        found.push_back({HindranceId::noPort,
                         Hindrance::Weight::prevents,
                         {},
                         noSerialPortsText(),
                         QStringLiteral("lsusb")});
    for (const PortInfo &port : ports)
        append(found, portHindrances(port.path, computer));
    append(found, canHindrances(computer));
    append(found, serverPortHindrances(modbusPort, Hindrance::Weight::remark, computer));
    std::ranges::stable_sort(found, {}, &Hindrance::weight);
    return found;
}

} // namespace codewheel
