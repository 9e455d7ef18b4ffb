// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/links/modbus_rtu_server.h"

#include "kinds/interbus/gateway/rtu_frame.h"

#include <algorithm>
#include <future>
#include <thread>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using std::chrono::system_clock;

constexpr int broadcast = 0;
constexpr int silentCharacters = 4; // 3.5 between two frames, Modbus over Serial Line V1.02, 2.5.1.1
// An adapter hands over what it has every few milliseconds, also in the middle of a frame.
constexpr Instant longestGap = 30ms;
constexpr Instant longestRead = 1s;

} // namespace

struct ModbusRtuServer::Private
{
    void run(const std::stop_token &stop, std::promise<Result<void>> opened);
    Result<void> serveNext();
    Result<void> serve(const RtuRequests::Request &request);
    bool isServed(int asked) const;

    std::unique_ptr<ByteLink> line;
    SerialSettings settings;
    ServedUnits units;
    int unit;
    ServedClients clients{1};
    std::optional<unsigned> client{}; // once it has asked something
    RtuRequests requests{};
    mutable std::mutex mutex{}; // guards what follows
    std::optional<Refusal> whyEnded{};
    std::jthread thread{};
};

// The line is opened here, since only one thread may use it.
void ModbusRtuServer::Private::run(const std::stop_token &stop, std::promise<Result<void>> opened)
{
    const auto isOpen = line->open(settings);
    opened.set_value(isOpen);
    if (!isOpen)
        return;
    while (!stop.stop_requested()) {
        if (const auto served = serveNext(); !served) {
            const std::scoped_lock lock(mutex);
            whyEnded = served.error();
            break;
        }
    }
    if (client)
        clients.leave(*client);
    line->close();
}

Result<void> ModbusRtuServer::Private::serveNext()
{
    const Instant silence = std::max(longestGap, settings.timeOf(silentCharacters));
    const auto bytes = line->read(line->now() + (requests.isWithin() ? silence : longestRead));
    if (!bytes)
        return tl::unexpected(bytes.error());
    requests.take(rtuOctets(*bytes));
    Result<void> served;
    while (const auto request = bytes->isEmpty() ? requests.silence() : requests.next())
        served = served ? serve(*request) : served;
    return served;
}

bool ModbusRtuServer::Private::isServed(int asked) const
{
    const std::vector<int> served = units.units();
    return asked == broadcast || (served.empty() ? asked == unit : std::ranges::count(served, asked) > 0);
}

Result<void> ModbusRtuServer::Private::serve(const RtuRequests::Request &request)
{
    if (!isServed(request.unit))
        return {};
    if (!client)
        client = clients.come(line->name(), system_clock::now());
    const ServedUnits::Answer answer = units.answer(request.unit, request.pdu);
    clients.took(*client, request.unit, answer, system_clock::now());
    if (request.unit == broadcast)
        return {};
    return line->write(rtuByteArray(rtuFrame(request.unit, answer.pdu)));
}

Result<std::unique_ptr<ModbusRtuServer>> ModbusRtuServer::start(std::unique_ptr<ByteLink> line,
                                                                const SerialSettings &settings,
                                                                ServedUnits units, int unit)
{
    std::unique_ptr<Private> made(new Private{std::move(line), settings, std::move(units), unit});
    std::promise<Result<void>> opening;
    auto opened = opening.get_future();
    made->thread =
        std::jthread([made = made.get(), opening = std::move(opening)](const std::stop_token &stop) mutable {
            made->run(stop, std::move(opening));
        });
    if (const auto result = opened.get(); !result)
        return tl::unexpected(result.error());
    return std::unique_ptr<ModbusRtuServer>(new ModbusRtuServer(std::move(made)));
}

ModbusRtuServer::ModbusRtuServer(std::unique_ptr<Private> made)
    : d(std::move(made))
{}

ModbusRtuServer::~ModbusRtuServer()
{
    d->thread.request_stop();
    d->line->interrupt();
}

QString ModbusRtuServer::port() const
{
    return d->line->name();
}

ServedClients &ModbusRtuServer::clients() const
{
    return d->clients;
}

std::optional<Refusal> ModbusRtuServer::whyEnded() const
{
    const std::scoped_lock lock(d->mutex);
    return d->whyEnded;
}

} // namespace codewheel
