// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/simulator/training_plan.h"
#include "tests/support/breakage.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

// A valid plan; each test breaks one part of it.
const QByteArray sound = R"({
  "participants": [
    {"place": "1.0", "device": "fraba-ocd-ib", "position": 12345, "serialNumber": 7, "operatingTime": 60,
     "known": [{"parameter": "start-up-mode", "value": 1}]},
    {"place": "2.0", "device": "fraba-ocd-ib-k1", "revolutionsPerMinute": -3},
    {"place": "3.0", "busTerminal": true},
    {"place": "3.1", "device": "baumer-gxp6w", "knownInWindow": [{"parameter": "coding", "value": 4}]},
    {"place": "4.0", "device": "tr-la66", "rodMillimetres": 300, "millimetres": 20, "millimetresPerSecond": -5}
  ]
}
)";

class BrokenTrainingPlan : public testing::TestWithParam<Breakage>
{};

TEST_P(BrokenTrainingPlan, IsRefusedWithLineKeyAndReason)
{
    const Catalog catalog = Catalog::builtIn();
    const auto plan = readTrainingPlan(brokenBy(GetParam(), sound), QStringLiteral("plant.json"), catalog);
    ASSERT_FALSE(plan);
    expectNamed(GetParam(), plan.error(), QStringLiteral("plant.json"));
}

constexpr Breakage breakages[] = {
    {R"(true})", R"(true)", 7, "", "not valid JSON"},
    {R"("participants")", R"("devices")", 2, "devices", "not known"},
    {R"("2.0")", R"("two")", 5, "participants[1].place", "6.1"},
    {R"("2.0")", R"("1.0")", 5, "participants[1].place", "order of the ring"},
    {R"("3.1")", R"("4.1")", 7, "participants[3].place", "needs a bus terminal before it: 4.0"},
    {R"(true})", R"(false, "device": "fraba-ocd-ib-k1"})", 7, "participants[3].place", "bus terminal"},
    {R"(true})", R"(true, "position": 5})", 6, "participants[2].position", "no encoder"},
    {R"("busTerminal": true)", R"("rack": true)", 6, "participants[2].rack", "not known"},
    {R"("baumer-gxp6w")", R"("baumer")", 7, "participants[3].device", "no device \"baumer\""},
    {R"("baumer-gxp6w")", R"("generic-k3")", 7, "participants[3].device", "cannot be simulated"},
    {R"("baumer-gxp6w")", R"("twk-k4")", 7, "participants[3].device", "cannot be simulated"},
    {R"("position": 12345)", R"("position": 33554432)", 3, "participants[0].position", "33554431"},
    {R"("position": 12345)", R"("position": -1)", 3, "participants[0].position", "between 0 and"},
    {R"("revolutionsPerMinute": -3)", R"("position": 4096)", 5, "participants[1].position", "4095"},
    {R"("revolutionsPerMinute": -3)", R"("revolutionsPerMinute": -12001)", 5,
     "participants[1].revolutionsPerMinute", "between -12000 and 12000"},
    {R"("revolutionsPerMinute": -3)", R"("serialNumber": 3)", 5, "participants[1].serialNumber",
     "Only a FRABA K3"},
    {R"("rodMillimetres": 300)", R"("position": 300)", 8, "participants[4].position", "no shaft"},
    {R"("rodMillimetres": 300, )", "", 8, "participants[4].rodMillimetres", "missing"},
    {R"("millimetres": 20)", R"("millimetres": 301)", 8, "participants[4].millimetres", "between 0 and 300"},
    {R"("revolutionsPerMinute": -3)", R"("millimetres": 3)", 5, "participants[1].millimetres", "has a rod"},
    {R"("start-up-mode")", R"("coding")", 4, "participants[0].known[0].parameter", "no parameter \"coding\""},
    {R"("value": 4)", R"("value": 7)", 7, "participants[3].knownInWindow[0].value", "between 1 and 6"},
    {R"("value": 1)", R"("value": 11)", 4, "participants[0].known[0].value", "between 0 and 10"},
};

INSTANTIATE_TEST_SUITE_P(TrainingPlan, BrokenTrainingPlan, testing::ValuesIn(breakages));

TEST(TrainingPlan, TellsEachParticipant)
{
    const Catalog catalog = Catalog::builtIn();
    const auto plan = readTrainingPlan(sound, QStringLiteral("plant.json"), catalog);
    ASSERT_TRUE(plan);
    ASSERT_EQ(plan->size(), 5U);
    const TrainingParticipant &fraba = plan->at(0);
    EXPECT_EQ(fraba.number, (NodeId("1.0")));
    EXPECT_EQ(fraba.device, catalog.find(u"fraba-ocd-ib"));
    EXPECT_EQ(fraba.position, 12'345);
    EXPECT_EQ(fraba.serialNumber, 7);
    EXPECT_EQ(fraba.operatingTime, 60);
    EXPECT_EQ(fraba.known, (ParameterValues{{Parameter::startUpMode, 1}}));
    EXPECT_EQ(plan->at(1).revolutionsPerMinute, -3);
    EXPECT_EQ(plan->at(1).position, 0);
    EXPECT_EQ(plan->at(2).device, nullptr);
    EXPECT_EQ(plan->at(3).number, (NodeId("3.1")));
    EXPECT_TRUE(plan->at(3).known.empty());
    EXPECT_EQ(plan->at(3).knownInWindow, (ParameterValues{{Parameter::coding, 4}}));
    EXPECT_EQ(plan->at(4).rodMillimetres, 300);
    EXPECT_EQ(plan->at(4).millimetres, 20);
    EXPECT_EQ(plan->at(4).millimetresPerSecond, -5);
}

} // namespace
} // namespace codewheel
