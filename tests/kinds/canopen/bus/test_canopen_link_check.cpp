// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_refusals.h"
#include "kinds/canopen/bus/canopen_link_check.h"
#include "tests/kinds/canopen/bus/canopen_plant.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using Step = CanopenLinkStep;

// The encoders of the training bus, and an adapter to be tested.
struct CheckedBus
{
    canopen::SimulatedCanopenPlant plant;
    std::shared_ptr<test::Talker> talker = std::make_shared<test::Talker>();
    test::WatchedCanLink link{plant.bus()};

    CheckedBus() { plant.bus()->add(talker); }
    std::vector<CanopenLinkFinding> check(const std::vector<CanopenAddress> &nodes = {})
    {
        CanopenLinkCheck check(link, 125'000, nodes);
        std::vector<CanopenLinkFinding> findings;
        while (!check.isDone())
            findings.push_back(check.next());
        return findings;
    }
};

TEST(CanopenLinkCheck, OpensTheAdapterListensAndTellsWhoIsHeard)
{
    CheckedBus bus;
    const auto found = bus.check();
    ASSERT_EQ(found.size(), 3U);
    for (const CanopenLinkFinding &one : found)
        EXPECT_EQ(one.outcome, CheckOutcome::passed) << one.sentence.toStdString();
    EXPECT_NE(found[0].sentence.indexOf(QStringLiteral("125 kBit/s")), -1);
    EXPECT_EQ(found[2].sentence, QStringLiteral("Heard: 5 (05h), 6 (06h), 7 (07h)."));
    EXPECT_EQ(bus.link.uses, std::vector{CanUse::watch});
    EXPECT_TRUE(bus.link.sent.empty());
}

TEST(CanopenLinkCheck, AsksForThePlannedNodesOneByOne)
{
    CheckedBus bus;
    const auto found = bus.check({{6}, {9}});
    ASSERT_EQ(found.size(), 4U);
    EXPECT_EQ(CanopenLinkCheck::stepText(found[2].step, found[2].address), QStringLiteral("Node 6 (06h)"));
    EXPECT_EQ(found[2].outcome, CheckOutcome::passed);
    EXPECT_EQ(found[2].sentence, QStringLiteral("It is heard: pre-operational."));
    EXPECT_EQ(found[3].outcome, CheckOutcome::skipped); // it may tell nothing by itself
}

TEST(CanopenLinkCheck, EndsWithAnAdapterThatCannotBeOpened)
{
    CheckedBus bus;
    bus.link.isGone = true;
    const auto found = bus.check();
    EXPECT_EQ(found[0].outcome, CheckOutcome::failed);
    ASSERT_TRUE(found[0].why);
    EXPECT_EQ(found[0].why->id, CanRefusalId::interfaceLost);
    EXPECT_EQ(found[2].outcome, CheckOutcome::skipped);
}

TEST(CanopenLinkCheck, TellsErrorsAndAnotherMaster)
{
    CheckedBus bus;
    bus.talker->frames.assign(20, test::canFrame(0x80, {})); // SYNC
    auto found = bus.check();
    EXPECT_TRUE(found[1].sentence.contains(QStringLiteral("Another master is at work (heard: SYNC).")))
        << found[1].sentence.toStdString();
    bus.plant.bus()->setFaults({.damaged = 500});
    found = bus.check();
    EXPECT_EQ(found[1].outcome, CheckOutcome::failed) << found[1].sentence.toStdString();
}

TEST(CanopenLinkCheck, TellsThatTheRateIsNotSure)
{
    CheckedBus bus;
    bus.link.remarked = Refusal{RefusalKind::link, CanRefusalId::rateMayBe750, {QStringLiteral("ttyACM0")}};
    const auto found = bus.check();
    EXPECT_EQ(found[0].outcome, CheckOutcome::passed);
    EXPECT_TRUE(found[0].sentence.contains(QStringLiteral("750"))) << found[0].sentence.toStdString();
}

TEST(CanopenLinkCheck, TellsThatOnlyJ1939IsSpoken)
{
    const auto bus = std::make_shared<SimulatedCanBus>();
    const auto talker = std::make_shared<test::Talker>();
    bus->add(talker);
    bus->add(std::make_shared<test::Talker>()); // acknowledges
    CanFrame frame = test::canFrame(0x0CFFE0E0, {1, 2, 3, 4, 5, 6, 7, 8});
    frame.isExtended = true;
    talker->frames.assign(20, frame);
    test::WatchedCanLink link(bus);
    CanopenLinkCheck check(link, 125'000, {});
    check.next();
    const CanopenLinkFinding found = check.next();
    EXPECT_EQ(found.outcome, CheckOutcome::failed) << found.sentence.toStdString();
    EXPECT_TRUE(found.sentence.contains(QStringLiteral("J1939"))) << found.sentence.toStdString();
}

TEST(CanopenLinkCheck, SkipsWhatIsLeftWhenItIsEnded)
{
    CheckedBus bus;
    CanopenLinkCheck check(bus.link, 125'000, {});
    check.interrupt();
    while (!check.isDone())
        EXPECT_EQ(check.next().outcome, CheckOutcome::skipped);
}

} // namespace
} // namespace codewheel
