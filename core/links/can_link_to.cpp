// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/can_link_to.h"

#include "links/serial_port_link.h"
#include "links/slcan_link.h"
#include "links/socket_can_link.h"

#include <QCanBusDevice>

namespace codewheel {

std::unique_ptr<CanLink> canLinkTo(const CanLinkArgument &at)
{
    if (!at.isSerial)
        return std::make_unique<SocketCanLink>(at.where);
    return std::make_unique<SlcanLink>(std::make_unique<SerialPortLink>(at.where), at.rate, at.baudRate);
}

} // namespace codewheel
