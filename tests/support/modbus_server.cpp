// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/modbus_server.h"

#include <algorithm>
#include <array>
#include <modbus.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

namespace codewheel {
namespace {

constexpr int registers = 65'536;

std::size_t at(int index)
{
    return static_cast<std::size_t>(index);
}

} // namespace

ModbusServer::ModbusServer()
    : m_modbus(modbus_new_tcp("127.0.0.1", 0))
    , m_registers(modbus_mapping_new(0, 0, registers, registers))
    , m_listener(modbus_tcp_listen(m_modbus, 8))
    , m_ended(::eventfd(0, EFD_CLOEXEC))
{
    sockaddr_in address = {};
    socklen_t length = sizeof address;
    ::getsockname(m_listener, reinterpret_cast<sockaddr *>(&address), &length);
    m_port = ntohs(address.sin_port);
    m_thread = std::jthread([this](const std::stop_token &stop) { serveClients(stop); });
}

ModbusServer::ModbusServer(int line, int unit)
    : m_modbus(modbus_new_rtu("/dev/null", 19'200, 'E', 8, 1)) // not opened: it has a descriptor
    , m_registers(modbus_mapping_new(0, 0, registers, registers))
    , m_ended(::eventfd(0, EFD_CLOEXEC))
{
    modbus_set_slave(m_modbus, unit);
    modbus_set_socket(m_modbus, line);
    m_thread = std::jthread([this](const std::stop_token &stop) { serve(stop); });
}

ModbusServer::~ModbusServer()
{
    m_thread.request_stop();
    ::eventfd_write(m_ended, 1);
    m_thread.join();
    modbus_mapping_free(m_registers);
    modbus_free(m_modbus);
    if (m_listener >= 0)
        ::close(m_listener);
    ::close(m_ended);
}

void ModbusServer::setInput(int first, const std::vector<std::uint16_t> &values)
{
    const std::scoped_lock lock(m_mutex);
    std::ranges::copy(values, m_registers->tab_input_registers + first);
}

void ModbusServer::setHolding(int first, const std::vector<std::uint16_t> &values)
{
    const std::scoped_lock lock(m_mutex);
    std::ranges::copy(values, m_registers->tab_registers + first);
}

std::vector<std::uint16_t> ModbusServer::holding(int first, int count)
{
    const std::scoped_lock lock(m_mutex);
    return {m_registers->tab_registers + first, m_registers->tab_registers + first + count};
}

int ModbusServer::requests(int function)
{
    const std::scoped_lock lock(m_mutex);
    return m_requests[at(function)];
}

bool ModbusServer::waitFor(int descriptor)
{
    std::array<pollfd, 2> waited{{{descriptor, POLLIN, 0}, {m_ended, POLLIN, 0}}};
    return ::poll(waited.data(), waited.size(), -1) > 0 && waited[1].revents == 0;
}

void ModbusServer::serveClients(const std::stop_token &stop)
{
    while (!stop.stop_requested() && waitFor(m_listener)) {
        const int client = ::accept4(m_listener, nullptr, nullptr, SOCK_CLOEXEC);
        if (client < 0)
            continue;
        const int on = 1;
        ::setsockopt(client, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
        modbus_set_socket(m_modbus, client);
        serve(stop);
        ::close(client);
    }
}

void ModbusServer::serve(const std::stop_token &stop)
{
    std::array<std::uint8_t, MODBUS_TCP_MAX_ADU_LENGTH> request{};
    const auto function = static_cast<std::size_t>(modbus_get_header_length(m_modbus));
    while (!stop.stop_requested() && waitFor(modbus_get_socket(m_modbus))) {
        const int length = modbus_receive(m_modbus, request.data());
        if (length < 0 && m_listener >= 0)
            return; // the client has gone
        if (length <= 0)
            continue;
        const std::scoped_lock lock(m_mutex);
        ++m_requests[request[function]];
        modbus_reply(m_modbus, request.data(), length, m_registers);
    }
}

} // namespace codewheel
