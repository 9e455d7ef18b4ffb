// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/served_clients.h"
#include "kinds/interbus/links/server_socket.h"

#include <memory>

namespace codewheel {

// Offers rings to Modbus/TCP clients, each in a thread of its own: one that sends nonsense, half a request,
// or fetches no answers delays nobody but itself, and is disconnected. Ends with the object.
class ModbusTcpServer
{
public:
    struct Limits
    {
        // A silent one gives way to one more (ServedClients::giveWay()); otherwise that is disconnected at
        // once.
        std::size_t clients = 64;
        std::chrono::milliseconds halfRequest{1'000}; // until the rest has to be there
        std::chrono::milliseconds idle{300'000};      // without a request
    };

    // Refused: as listenAt().
    static Result<std::unique_ptr<ModbusTcpServer>> start(const ServerPlace &place, ServedUnits units,
                                                          Limits limits);
    static Result<std::unique_ptr<ModbusTcpServer>> start(const ServerPlace &place, ServedUnits units)
    {
        return start(place, std::move(units), Limits());
    }
    ~ModbusTcpServer();
    ModbusTcpServer(const ModbusTcpServer &) = delete;
    ModbusTcpServer &operator=(const ModbusTcpServer &) = delete;

    ServerPlace place() const; // with the port that the system chose
    ServedClients &clients() const;

private:
    struct Private;
    explicit ModbusTcpServer(std::unique_ptr<Private> made);

    std::unique_ptr<Private> d;
};

} // namespace codewheel
