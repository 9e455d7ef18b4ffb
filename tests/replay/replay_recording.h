// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"
#include "recording/recorded_device.h"
#include "replay/replay_bus.h"
#include "tests/recording/recording_file.h"

namespace codewheel::test {

inline const Catalog &replayCatalog()
{
    static const Catalog catalog = Catalog::builtIn();
    return catalog;
}

inline constexpr Place hoist = "1.0"_ring;
inline constexpr Place trolley = "2.0"_ring;
inline constexpr Place atTheGate = Place{firstLine, NodeId("esc:05")};

inline QByteArray frabaWith(ParameterValues known)
{
    return toJson({.key = QStringLiteral("fraba-ocd-ib"),
                   .name = QStringLiteral("FRABA OCD-IB K3"),
                   .turns = 4096,
                   .stepsPerTurn = 4096,
                   .known = std::move(known)});
}

// What an encoder with words shows each 10 ms from then on: the position is in IN.
inline RecordedValues turning(Place place, Instant from, std::size_t count, std::int64_t first)
{
    RecordedValues values{place, {}};
    for (std::size_t i = 0; i < count; ++i) {
        const std::int64_t position = first + static_cast<std::int64_t>(i);
        values.values.push_back({.at = from + 10ms * i,
                                 .position = position,
                                 .stepsPerSecond = 100.0,
                                 .words = ExchangedWords{static_cast<Word>(position), 0}});
    }
    return values;
}

// Ten seconds: the hoist turns for two, shows nothing for four, and turns on for four; the trolley stands for
// all ten; the encoder of a line answers each 100 ms for one second.
class ReplayRecording : public RecordingFile
{
public:
    ReplayRecording()
    {
        auto writer = begin();
        writer->add(RecordedBus{firstBus, QStringLiteral("Crane")});
        writer->add(RecordedBus{firstLine, QStringLiteral("Gate")});
        writer->add(RecordedClock{noon, noon});
        writer->add(RecordedDescription{hoist, noon, frabaWith({{Parameter::steps, 4096}})});
        writer->add(RecordedDescription{trolley, noon, frabaWith({})});
        writer->add(RecordedDescription{atTheGate, noon,
                                        toJson({.key = QStringLiteral("kuebler-esc-rs485"),
                                                .name = QStringLiteral("Kübler"),
                                                .known = {}})});
        writer->add(turning(hoist, noon, 200, 1'000));
        writer->add(RecordedInterruption{hoist, noon + 2s});
        writer->add(RecordedDescription{hoist, noon + 5s, frabaWith({{Parameter::steps, 8192}})});
        writer->add(turning(hoist, noon + 6s, 400, 5'000));
        RecordedValues stands = turning(trolley, noon, 1, 77);
        stands.values.push_back(stands.values.front());
        stands.values.back().at = noon + 10s;
        writer->add(stands);
        RecordedValues answers{atTheGate, {}};
        for (int i = 0; i < 10; ++i)
            answers.values.push_back({.at = noon + 100ms * i, .position = 40 + i});
        writer->add(answers);
        writer->add(RecordedInterruption{atTheGate, noon + 1s});
        for (const Instant at : {noon + 500ms, noon + 7s})
            writer->add(RecordedTraffic{
                at, firstBus, {.at = at, .place = hoist, .cycle = 7, .out = 0, .in = 0x80000003}});
        writer->add(RecordedMessage{
            noon + 6500ms,
            {.at = {}, .place = hoist, .severity = Severity::attention, .id = MessageId::valuesForgotten}});
        writer->end();
    }
    std::shared_ptr<Playback> playback() const
    {
        auto opened = Playback::open(path);
        EXPECT_TRUE(opened);
        return opened ? std::move(*opened) : nullptr;
    }
};

inline Place replayed(Place place, int bus = 1'001)
{
    return {{bus}, place.node};
}

} // namespace codewheel::test
