// SPDX-License-Identifier: GPL-3.0-or-later
// What it costs to keep every cycle: memory and time of a sample, the share of a core that 512 encoders at
// 1000 cycles a second take, and the statistics of ten million samples.
#include "catalog/catalog.h"
#include "history/histories.h"
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/simulator/training_bus.h"
#include "tests/bench/noisy_shaft.h"
#include "tests/bench/processor_time.h"

#include <cstdio>

namespace {

using namespace codewheel;
using namespace std::chrono_literals;

constexpr int samples = 10'000'000;
constexpr int rings = 4;
constexpr int encodersPerRing = 128; // all that one can have
constexpr auto cycle = 1ms;
constexpr int cyclesPerFrame = 33;
constexpr int framesPerSecond = 30;
constexpr std::size_t limit = std::size_t{256} << 20; // of the memory

MemoryHistory measureSamples()
{
    bench::NoisyShaft shaft;
    std::vector<std::int64_t> positions;
    for (int i = 0; i < samples; ++i)
        positions.push_back(shaft.next());
    MemoryHistory history;
    const double seconds = bench::processorSecondsOf([&] {
        Instant at{};
        for (const std::int64_t position : positions)
            history.append({at += cycle, position});
    });
    std::printf("%d samples of a moving position: %.2f bytes each (at most 9), %.0f ns to append one\n",
                samples, static_cast<double>(history.bytes()) / samples, 1e9 * seconds / samples);
    return history;
}

void measureStatistics(const MemoryHistory &history)
{
    double deviation = 0;
    const double seconds =
        bench::processorSecondsOf([&] { deviation = history.statistics(*history.span())->deviation; });
    std::printf("their statistics: %.1f ms (deviation %.0f steps)\n", 1'000 * seconds, deviation);
}

// Several rings, since no single one can have as many encoders. What they show is made up: it turns, with
// position, speed and IN in every cycle.
class Plant
{
public:
    Plant()
    {
        const QDateTime began(QDate(2026, 3, 1), QTime(14, 2), Qt::UTC);
        for (int ring = 0; ring < rings; ++ring) {
            m_rings.push_back(std::make_unique<RingSession>(makeMovingRing(encodersPerRing).link, m_catalog,
                                                            began, nullptr, nullptr,
                                                            BusId{firstLine.number + 1 + ring}));
            m_buses.add(*m_rings.back());
            (void)m_rings.back()->open(EncoderBus::Start::operating);
        }
        for (const Place place : m_buses.places())
            m_encoders.push_back(m_buses.encoder(place));
        m_histories.setLimit(limit);
    }

    std::size_t encoders() const { return m_encoders.size(); }
    std::size_t bytes() const { return m_histories.bytes(); }

    void makeFrame()
    {
        m_frame.clear();
        for (int i = 0; i < cyclesPerFrame; ++i) {
            const std::int64_t position = m_cycle++ * 137 % 8192;
            const auto in = static_cast<Word>(position);
            m_frame.push_back({.at = m_cycle * cycle,
                               .position = position,
                               .stepsPerSecond = 137'000.5 + static_cast<double>(m_cycle % 7),
                               .cams = {},
                               .words = ExchangedWords{in, 0}});
        }
    }
    void show()
    {
        for (EncoderSession *encoder : m_encoders)
            Q_EMIT encoder->shown(m_frame);
        for (const auto &ring : m_rings)
            Q_EMIT m_buses.updated(ring->id());
    }

private:
    const Catalog m_catalog = Catalog::builtIn();
    std::vector<std::unique_ptr<RingSession>> m_rings;
    Buses m_buses;
    Histories m_histories{m_buses};
    std::vector<EncoderSession *> m_encoders;
    ShownSeries m_frame;
    std::int64_t m_cycle = 0;
};

void measureFrames(Plant &plant, const char *what, int seconds)
{
    double used = 0;
    double longest = 0;
    for (int frame = 0; frame < seconds * framesPerSecond; ++frame) {
        plant.makeFrame();
        const double its = bench::processorSecondsOf([&] { plant.show(); });
        used += its;
        longest = std::max(longest, its);
    }
    std::printf("%zu encoders, a cycle of 1 ms, %s: %.1f %% of one core, longest frame %.1f ms\n",
                plant.encoders(), what, 100 * used / seconds, 1'000 * longest);
}

} // namespace

int main()
{
    measureStatistics(measureSamples());
    Plant plant;
    measureFrames(plant, "while the memory fills", 10);
    while (plant.bytes() < limit - limit / 100)
        measureFrames(plant, "while the memory fills", 10);
    measureFrames(plant, "while the oldest is forgotten", 10);
    return 0;
}
