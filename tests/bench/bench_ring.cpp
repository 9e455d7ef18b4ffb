// SPDX-License-Identifier: GPL-3.0-or-later
// The duration of one cycle of a simulated ring with 128 moving K3 encoders, including drivers and snapshot,
// in position mode and in cam mode.
#include "catalog/catalog.h"
#include "kinds/interbus/make_driver.h"
#include "kinds/interbus/ring/cycle_time.h"
#include "kinds/interbus/ring/ring_runner.h"
#include "kinds/interbus/simulator/training_bus.h"
#include "kinds/interbus/words/k3_cam_word.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace {

using namespace codewheel;
using Clock = std::chrono::steady_clock;

constexpr int encoders = 128; // all that 4096 points allow
constexpr int warmUp = 2'000;
constexpr int cycles = 100'000;
constexpr int cyclesPerFrame = 33; // a window takes 30 snapshots a second

double microseconds(Clock::duration duration)
{
    return std::chrono::duration<double, std::micro>(duration).count();
}

// The ring as the program runs it: a driver for each encoder, and a reader that takes the frames.
class Ring
{
public:
    explicit Ring(const DeviceDescription &device)
        : m_structure(m_bus.link->open().value())
        , m_runner(*m_bus.link)
    {
        (void)m_runner.open({});
        m_runner.post(command::UseRing{m_structure, m_bus.link->readBackOut().value(), driversFor(device)});
        m_runner.post(command::StartBus{});
        m_runner.post(command::SetOperate{true});
    }

    const RingStructure &structure() const { return m_structure; }

    Clock::duration cycle()
    {
        m_now += std::chrono::milliseconds(1);
        const Clock::time_point begin = Clock::now();
        m_runner.cycle(m_now);
        const Clock::duration duration = Clock::now() - begin;
        if (++m_cycle % cyclesPerFrame == 0) {
            m_runner.takeLatest();
            m_runner.takeEvents();
        }
        return duration;
    }

    // Puts the word into every OUT until all encoders have processed it.
    void send(Word word)
    {
        constexpr int untilDealtWith = 10;
        for (std::size_t i = 0; i < m_structure.size(); ++i)
            m_runner.post(command::SetOut{i, word});
        for (int i = 0; i < untilDealtWith; ++i)
            cycle();
    }

private:
    std::vector<command::UseRing::Driver> driversFor(const DeviceDescription &device) const
    {
        std::vector<command::UseRing::Driver> drivers;
        for (std::size_t i = 0; i < m_structure.size(); ++i)
            drivers.push_back({makeDriver(device), {}});
        return drivers;
    }

    TrainingBus m_bus = makeMovingRing(encoders);
    RingStructure m_structure;
    RingRunner m_runner;
    Instant m_now{};
    int m_cycle = 0;
};

// All eight cams of program 1, each over part of the range.
void enterCamMode(Ring &ring)
{
    constexpr Word cams = 8;
    constexpr Word distance = 1'000;
    ring.send(k3::programWord | 1);
    for (Word cam = 0; cam < cams; ++cam) {
        ring.send(k3::presetBit | k3::withNumber(cam) | cam * distance);
        ring.send(k3::presetBit | k3::manufacturerBit | k3::withNumber(cam) |
                  (cam * distance + distance / 2));
    }
    ring.send(k3::camConfigurationWord | 0xFF);
    ring.send(k3::run);
    ring.send(k3::normalRunning);
}

void measure(Ring &ring, const char *what)
{
    std::vector<double> times;
    times.reserve(cycles);
    for (int i = 0; i < warmUp; ++i)
        ring.cycle();
    for (int i = 0; i < cycles; ++i)
        times.push_back(microseconds(ring.cycle()));
    std::ranges::sort(times);
    std::printf("%d moving K3 encoders%s, %d cycles: median %.2f us, 99 %% below %.2f us\n", encoders, what,
                cycles, times[times.size() / 2], times[times.size() * 99 / 100]);
}

void printTimeOnTheWire(const RingStructure &structure)
{
    const RingLoad load = ringLoad(structure);
    const auto milliseconds = [&](CycleTimeForm form) {
        return cycleTime(load, bitAt2MBd, form).count() / 1000;
    };
    std::printf("the same ring on the wire at 2 MBd: about %.1f ms (G3 form), about %.1f ms (G4 form)\n",
                milliseconds(CycleTimeForm::g3), milliseconds(CycleTimeForm::g4));
}

} // namespace

int main()
{
    const Catalog catalog = Catalog::builtIn();
    Ring ring(*catalog.find(u"fraba-ocd-ib"));
    measure(ring, "");
    enterCamMode(ring);
    measure(ring, " with eight cams each");
    printTimeOnTheWire(ring.structure());
    return 0;
}
