// SPDX-License-Identifier: GPL-3.0-or-later
// A kind of bus that the report does not know.
#include "bus/buses.h"
#include "project/bus_plans.h"
#include "report/html_report.h"
#include "report/live_encoders.h"
#include "report/make_report.h"
#include "report/transfer_report.h"
#include "tests/kinds/plain/plain_bus.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;

TEST(PlainBusReport, HasItsDevicesAndWhatTheyShow)
{
    addBusKind(std::make_unique<test::PlainKind>());
    const Catalog catalog = Catalog::builtIn();
    test::PlainBus bus(catalog);
    Buses buses;
    buses.add(bus);
    ReportInput input;
    planBus(input.project, test::plainId, *busKind(u"plain")).name = QStringLiteral("Yard");
    std::vector<ProjectDevice> devices;
    for (const Place place : bus.places()) {
        ProjectDevice &device = devices.emplace_back();
        device.participant = *bus.found(place);
        device.standAt(place);
        device.set(test::PlainNodeSettings{.heartbeat = 250});
        device.station = place == test::plainHoist ? QStringLiteral("Hoist") : QString();
    }
    setDevicesOn(input.project, test::plainId, std::move(devices));
    input.project.devices.front().wanted = {{test::plainName(), Value(QStringLiteral("Hoist 9"))}};
    bus.setOperate(true);
    EXPECT_TRUE(bus.encoder(test::plainHoist)
                    ->start(WriteParameters{.values = {{test::plainFilter(), -5}}, .previous = {}}));
    bus.advance(std::chrono::milliseconds(20));
    addConnected(input, buses);

    const std::string text = reportAsText(makeReport(input, catalog)).toStdString();
    for (const char *part :
         {"Yard", "Hoist", "n:1", "n:2", "n:3", "Plain P1", "Hoist 9", "250 ms", "read, stored"})
        EXPECT_THAT(text, HasSubstr(part));
}

} // namespace
} // namespace codewheel
