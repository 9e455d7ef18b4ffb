// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <modbus.h>
#include <mutex>
#include <thread>
#include <vector>

namespace codewheel {

// A server of libmodbus with all registers there are, in a thread of its own: on TCP for one client after the
// other, or at the far end of a pseudo terminal.
class ModbusServer
{
public:
    ModbusServer(); // on TCP
    ModbusServer(int line, int unit);
    ~ModbusServer();
    ModbusServer(const ModbusServer &) = delete;
    ModbusServer &operator=(const ModbusServer &) = delete;

    int port() const { return m_port; }
    void setInput(int first, const std::vector<std::uint16_t> &registers);
    void setHolding(int first, const std::vector<std::uint16_t> &registers);
    std::vector<std::uint16_t> holding(int first, int count);
    // As many requests of this function have come.
    int requests(int function);

private:
    void serveClients(const std::stop_token &stop);
    void serve(const std::stop_token &stop);
    bool waitFor(int descriptor);

    std::mutex m_mutex;
    modbus_t *m_modbus;
    modbus_mapping_t *m_registers;
    std::vector<int> m_requests = std::vector<int>(256);
    int m_listener = -1;
    int m_port = 0;
    int m_ended; // readable: the server is to end
    std::jthread m_thread;
};

} // namespace codewheel
