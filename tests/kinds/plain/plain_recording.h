// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/buses.h"
#include "history/histories.h"
#include "recording/bus_recorder.h"
#include "tests/kinds/plain/plain_bus.h"
#include "tests/recording/recording_file.h"

namespace codewheel::test {

// A second of a bus of the tests' own kind, in which one encoder is given a number below zero and a text.
class PlainRecording : public RecordingFile
{
public:
    explicit PlainRecording(const Catalog &catalog,
                            const std::vector<PlainStation> &stations = plainStations())
    {
        PlainBus bus(catalog, stations);
        const Place first = stations.front().place;
        Buses buses;
        buses.add(bus);
        const Histories histories(buses);
        QObject::connect(&bus, &EncoderBus::trafficPassed, &bus,
                         [this](const TrafficRow &row) { rows << text(row); });
        const auto clock = [&bus] { return bus.dateTime(bus.now()); };
        auto recorder = BusRecorder::begin(buses, histories, {.settings = settings()}, clock);
        EXPECT_TRUE(recorder);
        bus.setOperate(true);
        bus.advance(500ms);
        EXPECT_TRUE(bus.encoder(first)->start(
            WriteParameters{.values = {{plainFilter(), -5}, {plainName(), Value(QStringLiteral("Hoist 2"))}},
                            .previous = {}}));
        bus.advance(500ms);
        position = bus.encoder(first)->latest().position;
        (*recorder)->end();
        buses.remove(&bus);
    }
    static QString text(const TrafficRow &row)
    {
        return rowKindWord(*row.kind) + u' ' + QString::fromUtf8(row.bytes) + QStringLiteral(": ") +
               row.meaning();
    }

    QStringList rows; // as they passed
    std::optional<std::int64_t> position{};
};

} // namespace codewheel::test
