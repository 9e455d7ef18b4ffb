// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "kinds/interbus/ring/master_link.h"
#include "kinds/interbus/simulator/planned_ring.h"
#include "kinds/interbus/words/device_number.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::ElementsAre;

class PlannedRing : public testing::Test
{
protected:
    void add(DeviceNumber number, const QString &key, unsigned deviceCode, int inWords, int outWords)
    {
        ProjectDevice device;
        device.participant = RingDevice{.number = number.node(),
                                        .deviceCode = deviceCode,
                                        .inWords = inWords,
                                        .outWords = outWords,
                                        .deviceKey = key};
        m_project.devices.push_back(device);
    }
    std::vector<Word> exchange(const std::vector<Word> &out)
    {
        std::vector<Word> in(out.size());
        EXPECT_TRUE(m_bus->link->exchange(out, in));
        return in;
    }
    void simulate()
    {
        m_bus = makePlannedRing(m_project, firstBus, m_catalog);
        const auto structure = m_bus->link->open();
        ASSERT_TRUE(structure);
        EXPECT_EQ(structure->size(), m_project.devices.size());
    }

    Catalog m_catalog = Catalog::builtIn();
    Project m_project;
    std::optional<TrainingBus> m_bus;
};

TEST_F(PlannedRing, HasTheDevicesOfTheProjectAtTheirPlaces)
{
    add({1, 0}, QStringLiteral("fraba-ocd-ib"), 0x0237, 2, 2);
    add({2, 0}, QStringLiteral("baumer-gxp6w"), 0x0237, 2, 2);
    add({3, 0}, {}, 0x000C, 0, 0);
    add({3, 1}, QStringLiteral("fraba-ocd-ib-loop2"), 0x02B3, 2, 2);
    m_project.devices[0].label.stepsPerTurn = 4'096;
    simulate();
    const auto shafts = m_bus->controls->shafts();
    ASSERT_EQ(shafts.size(), 3U);
    EXPECT_EQ(shafts[0].stepsPerTurn, 4'096) << "as its label says";
    EXPECT_TRUE(shafts[1].hasBattery) << "as a Baumer has";
    EXPECT_EQ(shafts[2].number, NodeId("3.1"));
    EXPECT_GT(shafts[0].revolutionsPerMinute, 0);
}

TEST_F(PlannedRing, AK3OfUnknownMakeIsOne)
{
    add({1, 0}, {}, 0x0237, 2, 2);
    simulate();
    ASSERT_EQ(m_bus->controls->shafts().size(), 1U);
    EXPECT_TRUE(m_bus->controls->shafts()[0].hasParameters);
}

TEST_F(PlannedRing, ADeviceThatNobodySimulatesShowsItsOutWord)
{
    add({1, 0}, {}, 0x0103, 1, 1);
    add({2, 0}, {}, 0x0203, 2, 2);
    add({3, 0}, {}, 0x0102, 1, 0);
    simulate();
    exchange({0x12345678, 0x12345678, 0});
    EXPECT_THAT(exchange({0, 0, 0}), ElementsAre(0x5678U, 0x12345678U, 0U));
}

TEST_F(PlannedRing, IsThatOfItsBus)
{
    add({1, 0}, {}, 0x0237, 2, 2);
    m_project.buses.push_back({{7}, QString::fromLatin1(interbusKind), QStringLiteral("Other"), {}});
    setRingPlan(m_project, {7}, {});
    EXPECT_TRUE(makePlannedRing(m_project, {7}, m_catalog).controls->places().empty());
}

} // namespace
} // namespace codewheel
