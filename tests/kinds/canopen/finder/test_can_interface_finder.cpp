// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/simulator/simulated_can_link.h"
#include "kinds/canopen/finder/can_interface_finder.h"
#include "kinds/canopen/finder/slcan_spoken_protocol.h"
#include "kinds/canopen/simulator/simulated_canopen_plant.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using Kind = FinderNews::Kind;

FinderNews searched(const std::shared_ptr<SimulatedCanBus> &bus, int rate = 125'000)
{
    CanInterfaceFinder finder(std::make_unique<SimulatedCanLink>(bus, rate));
    FinderNews last;
    while (!finder.isDone())
        last = finder.next();
    return last;
}

std::string sentenceOf(const HeardOnCan &heard)
{
    return heard.sentence().toStdString();
}

// A line of encoders may be behind others.
TEST(SlcanProtocol, IsAskedAtPortsThatAreNamedAsAnAdapterOnly)
{
    const auto protocol = makeSlcanProtocol();
    using Fit = SpokenProtocol::Fit;
    EXPECT_EQ(protocol->fitsAt(QStringLiteral("/dev/ttyACM0")), Fit::first);
    EXPECT_EQ(protocol->fitsAt(QStringLiteral("/dev/serial/by-id/usb-LAWICEL_CANUSB_LWTE3QJ8-if00-port0")),
              Fit::first);
    EXPECT_EQ(protocol->fitsAt(QStringLiteral("/dev/ttyUSB0")), Fit::none);
    EXPECT_EQ(protocol->fitsAt(QStringLiteral("/dev/serial/by-id/usb-FTDI_USB-RS485_FT0-if00-port0")),
              Fit::none);
    EXPECT_TRUE(protocol->announcement().contains(QStringLiteral("ttyUSB0")));
}

TEST(CanInterfaceFinder, TellsWhichNodesAreHeard)
{
    const FinderNews news = searched(canopen::SimulatedCanopenPlant().bus());
    ASSERT_EQ(news.kind, Kind::found);
    EXPECT_EQ(news.sentence, QStringLiteral("CANopen nodes are heard: 5, 6, 7."));
    EXPECT_EQ(news.found->kind, QStringLiteral("canopen"));
    EXPECT_FALSE(news.found->isMasterAtWork);
}

TEST(CanInterfaceFinder, SaysWhyNobodyIsHeard)
{
    EXPECT_EQ(searched(std::make_shared<SimulatedCanBus>()).kind, Kind::nobody);
    const FinderNews wrong = searched(canopen::SimulatedCanopenPlant().bus(), 250'000);
    EXPECT_EQ(wrong.kind, Kind::nobody);
    EXPECT_TRUE(wrong.sentence.startsWith(u"Only errors are heard")) << wrong.sentence.toStdString();
}

TEST(CanInterfaceFinder, EndsWhenItIsToldTo)
{
    CanInterfaceFinder finder(std::make_unique<SimulatedCanLink>(std::make_shared<SimulatedCanBus>()));
    finder.interrupt();
    EXPECT_EQ(finder.next().kind, Kind::nobody);
    EXPECT_TRUE(finder.isDone());
}

TEST(HeardOnCan, NodesAreThoseThatSend)
{
    HeardOnCan heard;
    heard.take({.id = 0x605, .length = 8});
    heard.take({.id = 0x705, .isRemote = true});
    EXPECT_EQ(sentenceOf(heard), "Frames are heard, but none of a CANopen node. Another master is at work.");
    heard.take({.id = 0x189, .length = 4});
    EXPECT_EQ(sentenceOf(heard), "CANopen node 9 is heard. Another master is at work.");
}

TEST(HeardOnCan, J1939IsNoCanopen)
{
    HeardOnCan heard;
    heard.take({.id = 0x0CFF'E0E0, .isExtended = true, .length = 8});
    EXPECT_EQ(sentenceOf(heard), "Only frames of 29 bits are heard: J1939, not CANopen.");
}

} // namespace
} // namespace codewheel
