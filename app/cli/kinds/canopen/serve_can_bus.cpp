// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_bridge.h"
#include "can/simulator/simulated_slcan_adapter.h"
#include "cli/bus/pseudo_terminal.h"
#include "cli/call/stop_signals.h"
#include "cli/call/texts.h"
#include "cli/kinds/canopen/canopen_link_kind.h"
#include "cli/kinds/canopen/serve_can_plan.h"
#include "links/can_link_to.h"

#include <algorithm>
#include <chrono>

namespace codewheel {
namespace {

// A simulated CAN bus behind a pseudo terminal, on which an SLCAN adapter answers. Whoever has it open is the
// only one: when the last program closes it, the adapter begins anew. Used by the command serve; time is an
// argument.
class ServedCanBus
{
public:
    ServedCanBus(SimulatedCanBus &bus, SimulatedSlcanAdapter &adapter, PseudoTerminal &port)
        : m_bus(bus)
        , m_adapter(adapter)
        , m_port(port)
    {}

    // Does what is due at `now`; returns when there will be more, if nobody writes.
    std::optional<Instant> serve(Instant now);

private:
    SimulatedCanBus &m_bus;
    SimulatedSlcanAdapter &m_adapter;
    PseudoTerminal &m_port;
};

using namespace std::chrono_literals;

constexpr Instant untilPortHasRoom = 10ms;
constexpr int mostPiecesOfCommands = 16; // others want their turn, too

std::optional<Instant> ServedCanBus::serve(Instant now)
{
    if (m_port.clientLeft()) {
        m_port.dropUnfetched();
        m_adapter.restart();
    }
    m_adapter.advance(now);
    for (int piece = 0; piece < mostPiecesOfCommands; ++piece) {
        const QByteArray bytes = m_port.read();
        if (bytes.isEmpty())
            break;
        m_adapter.take(bytes, now);
    }
    if (!m_adapter.unfetched().isEmpty())
        m_adapter.fetched(m_port.write(m_adapter.unfetched()));
    const std::optional<Instant> next = m_bus.nextEvent();
    if (m_adapter.unfetched().isEmpty())
        return next;
    return std::min(next.value_or(Instant::max()), now + untilPortHasRoom);
}

constexpr Instant longestPause{500'000};   // at the port
constexpr Instant longestListenTo{20'000}; // at an interface, which no signal wakes

class RealTime
{
public:
    Instant operator()() const
    {
        using std::chrono::steady_clock;
        return std::chrono::duration_cast<Instant>(steady_clock::now() - m_begin);
    }

private:
    std::chrono::steady_clock::time_point m_begin = std::chrono::steady_clock::now();
};

canopen::SimulatedCanopenPlant plantOf(ServeCanPlan plan)
{
    for (canopen::CanopenEncoderPlan &encoder : plan.encoders)
        encoder.rate = plan.rate;
    canopen::SimulatedCanopenPlant plant(plan.encoders, plan.seed);
    plant.bus()->setFaults(plan.faults);
    plant.setBackground(plan.background);
    for (const std::size_t which : plan.silent)
        plant.withEncoder(which, [](canopen::SimulatedNode &node) { node.setOn(false); });
    return plant;
}

Instant pauseUntil(std::optional<Instant> next, Instant now, Instant longest)
{
    return std::clamp(next.value_or(now + longest) - now, Instant{}, longest);
}

Checked<Answer> serveAtPort(const Call &call, const ServeCanPlan &plan)
{
    auto port = PseudoTerminal::make();
    if (!port)
        return tl::unexpected(noPseudoTerminal());
    const canopen::SimulatedCanopenPlant plant = plantOf(plan);
    SimulatedSlcanAdapter adapter(plant.bus());
    ServedCanBus served(*plant.bus(), adapter, *port);
    StopSignals stop;
    call.terminal.print(port->path() + u'\n');
    const RealTime clock;
    while (call.terminal.canPrint() && !stop.came()) { // otherwise nobody knows the port
        const Instant now = clock();
        port->wait(stop.descriptor(), pauseUntil(served.serve(now), now, longestPause));
    }
    return Answer{{}, {{QStringLiteral("port"), port->path()}}};
}

// At the rate of the interface, where the system tells it.
Checked<Answer> serveAtInterface(const Call &call, ServeCanPlan plan)
{
    const std::unique_ptr<CanLink> link = canLinkTo({.where = *plan.interface});
    if (const auto opened = link->open(CanUse::operate); !opened)
        return tl::unexpected(complaintAbout(opened.error()));
    if (!call.arguments.has("--rate"))
        plan.rate = link->status().rate.value_or(plan.rate);
    const canopen::SimulatedCanopenPlant plant = plantOf(plan);
    SimulatedCanLink near(plant.bus(), plan.rate, RealTime());
    if (const auto opened = near.open(CanUse::operate); !opened)
        return tl::unexpected(complaintAbout(opened.error()));
    CanBridge bridge(*link, near);
    StopSignals stop;
    call.terminal.print(*plan.interface + u'\n');
    while (call.terminal.canPrint() && !stop.came()) {
        const Instant pause = pauseUntil(plant.bus()->nextEvent(), plant.bus()->now(), longestListenTo);
        if (const auto carried = bridge.carry(pause); !carried)
            return tl::unexpected(complaintAbout(carried.error()));
    }
    return Answer{{}, {{QStringLiteral("interface"), *plan.interface}}};
}

Checked<Answer> serveCanBus(const Call &call)
{
    return serveCanPlan(call.arguments).and_then([&](const ServeCanPlan &plan) {
        return plan.interface ? serveAtInterface(call, plan) : serveAtPort(call, plan);
    });
}

} // namespace

const Service canBusService{"canopen", serveCanOptions(), serveCanBus};

} // namespace codewheel
