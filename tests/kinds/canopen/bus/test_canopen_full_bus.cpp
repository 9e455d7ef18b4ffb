// SPDX-License-Identifier: GPL-3.0-or-later
// Encoders on a bus that others use as well.
#include "kinds/canopen/bus/canopen_checks.h"
#include "tests/kinds/canopen/bus/canopen_plant.h"

#include <gmock/gmock.h>

namespace codewheel {
namespace {

using test::CanopenPlant;
using testing::ElementsAre;
using namespace std::chrono_literals;

class FullCanBus : public CanopenPlant
{
protected:
    // Until the search has ended; how long that took.
    Instant search(Instant atMost)
    {
        found.clear();
        bool isDone = false;
        const auto waiting =
            QObject::connect(bus.get(), &CanopenSession::scanned, bus.get(), [&](const NodesScanned &scan) {
                isDone = scan.isDone && !scan.isCancelled;
                if (isDone)
                    for (const canopen::FoundNode &node : scan.found)
                        found.push_back(node.node);
            });
        bus->scan();
        Instant passed{};
        for (; !isDone && passed < atMost; passed += 50ms)
            bus->advance(50ms);
        QObject::disconnect(waiting);
        return passed;
    }

    std::vector<int> found;
};

TEST_F(FullCanBus, AtALoadOf70PercentItsEncodersAreFoundAndRead)
{
    plant->setBackground({.load = 70});
    operate();
    EXPECT_GT(bus->latest().figures.load, 0.65);
    EXPECT_LT(search(10s), 4s);
    EXPECT_THAT(found, ElementsAre(5, 6, 7));
    const auto outcome = carryOut(six, WriteParameters{.values = {{Parameter::steps, 4096}}, .previous = {}});
    ASSERT_TRUE(outcome);
    EXPECT_TRUE(outcome->result);
    EXPECT_EQ(bus->encoder(six)->known(Parameter::steps)->value, Value(4096));
    EXPECT_TRUE(bus->encoder(five)->latest().position);
    EXPECT_FALSE(bus->latest().heard(5)->isDoubled);
}

TEST_F(FullCanBus, ItsLoadStandsBesideASilentEncoder)
{
    plant->setBackground({.load = 92});
    operate();
    plant->withEncoder(0, [](canopen::SimulatedNode &node) { node.setOn(false); });
    bus->advance(10s);
    const auto fault = canopenFaultOf(*bus, five);
    ASSERT_TRUE(fault);
    EXPECT_THAT(fault->text.toStdString(), testing::HasSubstr("% full"));
}

TEST_F(FullCanBus, BesideAnotherMasterNothingIsSentUnasked)
{
    plant->setBackground({.load = 50, .hasMaster = true});
    operate(); // until it is heard, nobody is known to be there
    EXPECT_GE(countOf(CanopenBusMessageId::otherMasterHeard), 1);
    link->sent.clear();
    bus->advance(3s);
    EXPECT_TRUE(link->sent.empty());
}

} // namespace
} // namespace codewheel
