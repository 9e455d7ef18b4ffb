// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/served_clients.h"
#include "serial/byte_link.h"

#include <memory>

namespace codewheel {

// Offers rings to the Modbus RTU client at a serial line, in a thread of its own. It answers to the units
// that are offered (to this one, if one ring answers to all), and carries out broadcasts, which nobody
// answers. Ends with the object.
class ModbusRtuServer
{
public:
    // Opens the line. Refused: as SerialPortLink::open().
    static Result<std::unique_ptr<ModbusRtuServer>>
    start(std::unique_ptr<ByteLink> line, const SerialSettings &settings, ServedUnits units, int unit);
    ~ModbusRtuServer();
    ModbusRtuServer(const ModbusRtuServer &) = delete;
    ModbusRtuServer &operator=(const ModbusRtuServer &) = delete;

    QString port() const;
    ServedClients &clients() const;
    // Why nothing is served any more, such as an adapter that was unplugged; empty: it is.
    std::optional<Refusal> whyEnded() const;

private:
    struct Private;
    explicit ModbusRtuServer(std::unique_ptr<Private> made);

    std::unique_ptr<Private> d;
};

} // namespace codewheel
