// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cerrno>
#include <cstdint>
#include <memory>
#include <modbus.h>
#include <vector>

namespace codewheel::test {

// A client of libmodbus.
class ModbusClient
{
public:
    explicit ModbusClient(int port, int unit = 1)
        : m_modbus(modbus_new_tcp("127.0.0.1", port))
    {
        modbus_set_slave(m_modbus.get(), unit);
        modbus_set_response_timeout(m_modbus.get(), 60, 0);
        m_isConnected = modbus_connect(m_modbus.get()) == 0;
    }

    bool isConnected() const { return m_isConnected; }
    // By function 16, or why not: errno.
    int write(int first, const std::vector<std::uint16_t> &registers)
    {
        const int count = static_cast<int>(registers.size());
        return modbus_write_registers(m_modbus.get(), first, count, registers.data()) == count ? 0 : errno;
    }
    int writeOne(int place, std::uint16_t value)
    {
        return modbus_write_register(m_modbus.get(), place, value) == 1 ? 0 : errno;
    }
    // Empty: errno says why.
    std::vector<std::uint16_t> readHolding(int first, int count)
    {
        std::vector<std::uint16_t> registers(static_cast<std::size_t>(count));
        if (modbus_read_registers(m_modbus.get(), first, count, registers.data()) != count)
            registers.clear();
        return registers;
    }
    std::vector<std::uint16_t> readInput(int first, int count)
    {
        std::vector<std::uint16_t> registers(static_cast<std::size_t>(count));
        if (modbus_read_input_registers(m_modbus.get(), first, count, registers.data()) != count)
            registers.clear();
        return registers;
    }

private:
    struct Close
    {
        void operator()(modbus_t *modbus) const
        {
            modbus_close(modbus);
            modbus_free(modbus);
        }
    };

    std::unique_ptr<modbus_t, Close> m_modbus;
    bool m_isConnected = false;
};

} // namespace codewheel::test
