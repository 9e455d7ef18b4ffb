// SPDX-License-Identifier: GPL-3.0-or-later
// How often the position of one encoder is asked for on a serial line at 19200 8N2, compared with what the
// line allows: 18 characters both ways, and never less than the 10 ms of the manual. The other end keeps the
// line's timing.
#include "catalog/catalog.h"
#include "kinds/esc/line/esc_line_runner.h"
#include "kinds/esc/simulator/simulated_esc_line_link.h"
#include "kinds/interbus/make_driver.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace {

using namespace codewheel;
using Clock = std::chrono::steady_clock;

constexpr int charactersThereAndBack = 18;
constexpr std::chrono::milliseconds notUnder{10};

Instant steadyNow()
{
    return std::chrono::duration_cast<Instant>(Clock::now().time_since_epoch());
}

double milliseconds(Instant time)
{
    return std::chrono::duration<double, std::milli>(time).count();
}

void measure(const char *what, SimulatedEscLineLink::Clock clock, Instant duration)
{
    const Catalog catalog = Catalog::builtIn();
    const DeviceDescription &device = *catalog.find(u"kuebler-esc-rs485");
    const SerialSettings settings;
    SimulatedEscLineLink link(std::make_shared<SimulatedEscLine>(), std::move(clock));
    if (!link.open(settings))
        return;
    EscLineRunner runner(link, settings, {});
    runner.post(line_command::AddDevice{makeRequestDriver(device, {5}), device.fullName()});
    runner.post(line_command::SetRunning{true});

    std::vector<Instant> positions; // when they were asked for
    const Instant end = link.now() + duration;
    while (link.now() < end) {
        runner.turn(std::min(end, link.now() + std::chrono::milliseconds(50)));
        for (const EscLineEvent &event : runner.takeEvents()) {
            const auto *row = std::get_if<esc::EscLineRow>(&event.what);
            if (row && row->kind == esc::EscLineRow::Kind::sent && row->bytes.contains('P'))
                positions.push_back(row->at);
        }
    }
    const auto latest = runner.takeLatest();
    if (!latest || positions.size() < 2)
        return;
    const EscLineFigures &figures = latest->devices.front().figures;
    const double allowed = milliseconds(std::max<Instant>(settings.timeOf(charactersThereAndBack), notUnder));
    const double every =
        milliseconds(positions.back() - positions.front()) / static_cast<double>(positions.size() - 1);
    Instant shortest = duration;
    for (std::size_t i = 1; i < positions.size(); ++i)
        shortest = std::min(shortest, positions[i] - positions[i - 1]);
    std::printf(
        "%s: a position every %.2f ms, %.1f %% of what the line allows (%.2f ms); never under %.2f ms;\n"
        "  %llu requests, %llu answers, answer time %.2f / %.2f / %.2f ms (shortest, median, longest)\n",
        what, every, 100 * allowed / every, allowed, milliseconds(shortest),
        static_cast<unsigned long long>(figures.requests), static_cast<unsigned long long>(figures.answers),
        milliseconds(figures.answerTime->shortest), milliseconds(figures.answerTime->median),
        milliseconds(figures.answerTime->longest));
}

} // namespace

int main()
{
    measure("virtual time", {}, std::chrono::seconds(60));
    measure("real time", steadyNow, std::chrono::seconds(5));
    return 0;
}
