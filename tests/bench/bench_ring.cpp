// SPDX-License-Identifier: GPL-3.0-or-later
// The time of one cycle of a simulated ring with 128 moving K3 encoders, drivers and snapshot included; and
// that of the hand-over of a snapshot.
#include "catalog/catalog.h"
#include "drivers/make_driver.h"
#include "ring/cycle_time.h"
#include "ring/ring_runner.h"
#include "simulator/training_bus.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace {

using namespace codewheel;
using Clock = std::chrono::steady_clock;

constexpr int encoders = 128; // all that 4096 points allow
constexpr int warmUp = 2'000;
constexpr int cycles = 100'000;
constexpr int cyclesPerPicture = 33; // a window takes 30 snapshots a second

double microseconds(Clock::duration duration)
{
    return std::chrono::duration<double, std::micro>(duration).count();
}

} // namespace

int main()
{
    const Catalog catalog = Catalog::builtIn();
    const DeviceDescription &fraba = *catalog.find(u"fraba-ocd-ib");
    TrainingBus bus = makeMovingRing(encoders);
    const RingStructure structure = bus.link->open().value();
    RingRunner::Drivers drivers;
    for (std::size_t i = 0; i < structure.size(); ++i)
        drivers.push_back(makeDriver(fraba));
    RingRunner runner(*bus.link, structure, std::move(drivers), bus.link->readBackOut().value());
    runner.post(command::StartBus{});

    std::vector<double> times;
    times.reserve(cycles);
    Instant now{};
    for (int i = 0; i < warmUp + cycles; ++i) {
        now += std::chrono::milliseconds(1);
        const Clock::time_point begin = Clock::now();
        runner.cycle(now);
        if (i >= warmUp)
            times.push_back(microseconds(Clock::now() - begin));
        if (i % cyclesPerPicture == 0) {
            runner.takeLatest();
            runner.takeEvents();
        }
    }
    std::ranges::sort(times);
    const std::size_t middle = times.size() / 2;
    const std::size_t high = times.size() * 99 / 100;
    std::printf("%d moving K3 encoders, %d cycles: median %.2f us, 99 %% below %.2f us\n", encoders, cycles,
                times[middle], times[high]);
    const RingLoad load = ringLoad(structure);
    const auto milliseconds = [&](CycleTimeForm form) {
        return cycleTime(load, bitAt2MBd, form).count() / 1000;
    };
    std::printf("the same ring on the wire at 2 MBd: about %.1f ms (G3 form), about %.1f ms (G4 form)\n",
                milliseconds(CycleTimeForm::g3), milliseconds(CycleTimeForm::g4));
    return 0;
}
