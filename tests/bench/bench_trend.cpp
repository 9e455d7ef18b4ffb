// SPDX-License-Identifier: GPL-3.0-or-later
// A frame of the trend: a chart of 1000 x 600 that scrolls by a pixel with each frame, so that its labels
// move, come and go, with ten thousand samples in view and with ten million; then zoomed into the ten
// million.
#include "tests/bench/noisy_shaft.h"
#include "tests/bench/painted_frames.h"
#include "tests/bench/processor_time.h"
#include "widgets/look/appearance.h"
#include "widgets/trend/trend_chart.h"

#include <QApplication>

#include <cstdio>

namespace {

using namespace codewheel;
using namespace std::chrono_literals;

constexpr QSize chartSize(1000, 600);
constexpr int frames = 200;
constexpr int few = 10'000;
constexpr int many = 10'000'000;
constexpr auto cycle = 1ms;
constexpr int framesPerAxis = 10; // after which the labels of the values change as well

using Position = std::function<std::int64_t()>;

// Some more than are seen at once.
MemoryHistory historyOf(int inView, const Position &next)
{
    MemoryHistory history;
    Instant at{};
    for (int i = 0; i < inView + inView / 2; ++i)
        history.append({at += cycle, next()});
    return history;
}

bench::FrameTimes measure(TrendChart &chart, const MemoryHistory &history, int inView)
{
    TrendScene scene{.lanes = {{.curves = {{.track = {},
                                            .scale = {},
                                            .history = &history,
                                            .name = QStringLiteral("1.0 position, steps"),
                                            .color = QColor(0x20, 0x60, 0xC0)}},
                                .unit = QStringLiteral("steps")}},
                     .span = {},
                     .marks = {}};
    TrendLane &lane = scene.lanes.front();
    chart.showScene(scene);
    const Instant length = inView * cycle;
    const double pixel = static_cast<double>(length.count()) / chart.plot().width();
    return bench::timesOf(frames, [&](int frame) {
        const Instant from(std::llround(frame * pixel));
        scene.span = {from, from + length};
        const auto extent = history.extent(scene.span).value();
        const auto spread = static_cast<double>(extent.greatest - extent.least);
        const double margin = spread * (1 + frame / framesPerAxis % 2) / 20;
        lane.low = static_cast<double>(extent.least) - margin;
        lane.high = static_cast<double>(extent.greatest) + margin;
        chart.showScene(scene);
        bench::paint(*chart.viewport());
    });
}

void print(const char *what, const bench::FrameTimes &times)
{
    std::printf("%s: median %.2f ms a frame, longest %.2f ms\n", what, times.median, times.longest);
}

void compare(TrendChart &chart, const char *what, const Position &next)
{
    const MemoryHistory little = historyOf(few, next);
    const MemoryHistory large = historyOf(many, next);
    std::printf("%s\n", what);
    const auto ofFew = measure(chart, little, few);
    const auto ofMany = measure(chart, large, many);
    print("  10 000 samples in view", ofFew);
    print("  10 000 000 in view", ofMany);
    std::printf("  %.2f times\n", ofMany.median / ofFew.median);
    print("  zoomed to 10 000 of them", measure(chart, large, few));
    print("  zoomed to 100 of them", measure(chart, large, few / 100));
}

} // namespace

int main(int argc, char **argv)
{
    QApplication application(argc, argv);
    applyAppearance(application, {});
    TrendChart chart;
    chart.resize(chartSize);
    chart.show();
    QApplication::processEvents();
    compare(chart, "a shaft that wanders by chance",
            [shaft = bench::NoisyShaft()]() mutable { return shaft.next(); });
    compare(chart, "a shaft that turns, 8192 steps a turn",
            [position = 0]() mutable { return std::int64_t{position = (position + 137) % 8192}; });
    return 0;
}
