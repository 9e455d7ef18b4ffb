// SPDX-License-Identifier: GPL-3.0-or-later
// The plan of a serial line compared with what is connected, and taken over from it (project/plan_rules.h).
#include "catalog/catalog.h"
#include "kinds/esc/protocol/esc_line_address.h"
#include "project/bus_kind.h"
#include "project/bus_plans.h"
#include "project/plan_rules.h"

#include <array>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

class PlanComparison : public testing::Test
{
protected:
    PlanComparison()
    {
        planBus(project, firstLine, *busKind(u"esc"));
        std::vector<ProjectDevice> planned(3);
        constexpr std::array addresses{EscLineAddress{1}, EscLineAddress{2}, EscLineAddress{3}};
        for (std::size_t i = 0; i < planned.size(); ++i) {
            planned[i].standAt(placeOnLine(addresses.at(i)));
            planned[i].participant.deviceKey = QStringLiteral("kuebler-esc-rs485");
            planned[i].station = QStringLiteral("station %1").arg(i + 1);
            planned[i].label.serialNumber = QStringLiteral("77");
        }
        setDevicesOn(project, firstLine, planned);
        for (const EscLineAddress address : {EscLineAddress{1}, EscLineAddress{2}, EscLineAddress{9}})
            connected.devices.push_back(
                {.number = address.node(), .deviceKey = QStringLiteral("kuebler-esc-rs422")});
        connected.others.emplace(
            EscLineAddress{2}.node(),
            Refusal{RefusalKind::link, RefusalId::serialDiffers, {QStringLiteral("esc:02"), {}, {}}});
    }
    Comparison compare() const { return rules.compare(project, firstLine, connected); }
    EditedPlan takenOver(std::initializer_list<std::size_t> lines) const
    {
        return rules.takenOver(project, firstLine, connected, compare(), std::vector(lines));
    }

    Project project;
    ConnectedBus connected;
    const PlanRules &rules = busKind(u"esc")->planRules();
};

TEST_F(PlanComparison, GoesPlaceByPlace)
{
    QStringList kinds;
    for (const ComparisonLine &line : compare())
        kinds << comparisonKindKey(line.kind);
    EXPECT_EQ(kinds.join(u' '), QStringLiteral("same differs missing additional"));
    EXPECT_EQ(rules.comparisonText(compare()[3], project, firstLine, connected, Catalog::builtIn()),
              QStringLiteral("esc:09: Kübler 5882 / 5862 / 9081 RS-422 is additional: it is not configured"));
}

TEST_F(PlanComparison, TakesOverTheChosenLinesAndKeepsWhatBelongsToThePlace)
{
    const EditedPlan all = takenOver({0, 1, 2, 3});
    ASSERT_EQ(all.devices.size(), 3U);
    EXPECT_EQ(all.devices[0], devicesOn(project, firstLine)[0]) << "the same";
    EXPECT_EQ(all.devices[1].station, QStringLiteral("station 2"));
    EXPECT_EQ(all.devices[1].label, DeviceLabel());
    EXPECT_EQ(all.devices[1].participant.deviceKey, QStringLiteral("kuebler-esc-rs422"));
    EXPECT_EQ(all.devices[2].place(), placeOnLine({9}));
    EXPECT_EQ(all.from[2], std::nullopt);
    const EditedPlan additional = takenOver({3});
    ASSERT_EQ(additional.devices.size(), 4U);
    EXPECT_EQ(additional.devices[1], devicesOn(project, firstLine)[1]) << "not chosen";
}

} // namespace
} // namespace codewheel
