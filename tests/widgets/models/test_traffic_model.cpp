// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/bus/canopen_traffic.h"
#include "kinds/canopen/protocol/frames.h"
#include "widgets/models/traffic_model.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

TEST(TrafficModel, AFrameOnCanIsShownByIdentifierNodeAndData)
{
    TrafficModel model(canTrafficColumns, 100);
    const std::vector<std::uint8_t> position{0x88, 0x13, 0x00, 0x00};
    model.add(CanopenTraffic().row({.frame = canopen::frameOf(0x185, position)}, Instant()));
    model.showWaiting();
    const auto cell = [&](TrafficColumn column) {
        return model.index(0, model.columnOf(column)).data().toString();
    };
    EXPECT_EQ(cell(TrafficColumn::identifier), QStringLiteral("185"));
    EXPECT_EQ(cell(TrafficColumn::who), QStringLiteral("can:5"));
    EXPECT_EQ(cell(TrafficColumn::bytes), QStringLiteral("88 13 00 00"));
    EXPECT_EQ(cell(TrafficColumn::meaning), QStringLiteral("Node 5: TPDO1"));
}

} // namespace
} // namespace codewheel
