// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "kinds/interbus/words/profiles.h"
#include "project/project.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

ProjectDevice planned(unsigned deviceCode, const QString &key)
{
    ProjectDevice device;
    device.participant.deviceCode = deviceCode;
    device.participant.deviceKey = key;
    return device;
}

TEST(PlannedDevice, IsWhatItIsNamed)
{
    const Catalog catalog = Catalog::builtIn();
    const auto named = plannedDescription(planned(0x0237, QStringLiteral("fraba-ocd-ib")), catalog);
    ASSERT_TRUE(named);
    EXPECT_EQ(*named, *catalog.find(u"fraba-ocd-ib"));
}

TEST(PlannedDevice, OfAMakeThatIsNotKnownIsGeneric)
{
    const Catalog catalog = Catalog::builtIn();
    for (const QString &key : {QString(), QStringLiteral("a-device-of-another-computer")}) {
        const auto generic = plannedDescription(planned(0x0237, key), catalog);
        ASSERT_TRUE(generic);
        EXPECT_TRUE(generic->isGeneric());
        EXPECT_EQ(generic->profile, profile::k3);
    }
    EXPECT_FALSE(plannedDescription(planned(0x81BE, {}), catalog)) << "a digital input";
}

TEST(PlannedDevice, HasTheResolutionOfItsLabel)
{
    const Catalog catalog = Catalog::builtIn();
    ProjectDevice device = planned(0x0237, QStringLiteral("fraba-ocd-ib"));
    device.label.turns = 16;
    auto described = plannedDescription(device, catalog);
    ASSERT_TRUE(described);
    EXPECT_EQ(described->physicalTurns, 16);
    EXPECT_EQ(described->physicalStepsPerTurn, catalog.find(u"fraba-ocd-ib")->physicalStepsPerTurn);
    device.label.stepsPerTurn = 1024;
    EXPECT_EQ(plannedDescription(device, catalog)->physicalStepsPerTurn, 1024);
}

} // namespace
} // namespace codewheel
