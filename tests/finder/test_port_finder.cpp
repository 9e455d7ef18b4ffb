// SPDX-License-Identifier: GPL-3.0-or-later
#include "finder/port_finder.h"
#include "kinds/esc/plan/esc_line_plan.h"
#include "kinds/esc/simulator/simulated_esc_line_link.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "tests/kinds/esc/line/scripted_line.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using Kind = FinderNews::Kind;

std::vector<FinderNews> run(ByteLink &link, bool mayAsk)
{
    PortFinder finder(link, mayAsk);
    std::vector<FinderNews> all;
    while (!finder.isDone() && all.size() < 1'000)
        all.push_back(finder.next());
    return all;
}

std::vector<Found> foundIn(const std::vector<FinderNews> &news)
{
    std::vector<Found> found;
    for (const FinderNews &one : news)
        if (one.found)
            found.push_back(*one.found);
    return found;
}

EscEncoderPlan encoderAt(std::uint8_t address, int baudRate)
{
    EscEncoderPlan plan = trainingLine().front();
    plan.address = EscLineAddress{address};
    plan.baudRate = baudRate;
    return plan;
}

TEST(PortFinder, OnlyListensUnlessItMayAsk)
{
    ScriptedLink link;
    PortFinder finder(link, false);
    const FinderNews listens = finder.next();
    EXPECT_EQ(listens.kind, Kind::looking);
    EXPECT_TRUE(listens.sentence.contains(u"19200 Bd, 8N2. Nothing is sent"))
        << listens.sentence.toStdString();
    const FinderNews news = finder.next();
    EXPECT_TRUE(finder.isDone());
    EXPECT_TRUE(finder.isSilent());
    EXPECT_EQ(news.kind, Kind::nobody);
    EXPECT_TRUE(link.sent.empty());
    EXPECT_EQ(link.opened, 1) << "a silent line is silent with any settings";
}

TEST(PortFinder, FindsEveryEncoderOfALineAtTheRateTheyHave)
{
    SimulatedEscLineLink link(
        std::make_shared<SimulatedEscLine>(std::vector{encoderAt(3, 9'600), encoderAt(18, 9'600)}));
    const auto found = foundIn(run(link, true));
    ASSERT_EQ(found.size(), 2U);
    for (const Found &one : found) {
        EXPECT_EQ(one.kind, QStringLiteral("esc"));
        EXPECT_EQ(one.settings, QStringLiteral("9600 Bd, 8N2"));
        EXPECT_EQ(one.certainty, Certainty::certain);
        EXPECT_FALSE(one.isMasterAtWork);
        ASSERT_NE(one.plan.as<EscLinePlan>(), nullptr);
        EXPECT_EQ(one.plan.as<EscLinePlan>()->settings.serial.baudRate, 9'600);
        EXPECT_TRUE(one.link.endsWith(QStringLiteral(",baud=9600")));
    }
    EXPECT_TRUE(found[1].sentence.contains(u"12h (18)")) << found[1].sentence.toStdString();
}

TEST(PortFinder, SendsOnlyReads)
{
    ScriptedLink link;
    const auto news = run(link, true);
    EXPECT_EQ(news.back().kind, Kind::nobody);
    ASSERT_FALSE(link.sent.empty());
    for (const ScriptedLink::Sent &sent : link.sent) {
        if (sent.bytes.startsWith('\x1B')) {
            const auto request =
                esc::parseRequest(QByteArrayView(sent.bytes).sliced(1, sent.bytes.size() - 3));
            ASSERT_TRUE(request);
            EXPECT_FALSE(esc::shapeOf(request->command).writes);
        } else {
            ASSERT_EQ(sent.bytes.size(), 8);
            EXPECT_TRUE(sent.bytes[1] == 3 || sent.bytes[1] == 4);
        }
    }
}

TEST(PortFinder, FindsAModbusUnitAndTheAreaThatItHas)
{
    ScriptedLink link;
    link.answersAt = 9'600;
    link.answers[QByteArray::fromHex("02040000000131f9")] = QByteArray::fromHex("0204021234f047");
    const auto found = foundIn(run(link, true));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].kind, QStringLiteral("interbus"));
    EXPECT_EQ(found[0].settings, QStringLiteral("9600 Bd, 8E1"));
    EXPECT_EQ(found[0].link, QStringLiteral("modbus-rtu:scripted line,baud=9600,unit=2"));
    ASSERT_NE(found[0].plan.as<ProjectLink>(), nullptr);
    EXPECT_EQ(found[0].plan.as<ProjectLink>()->kind, QStringLiteral("modbus-rtu"));
}

TEST(PortFinder, AUnitWithoutInputRegistersIsReadFromItsHoldingRegisters)
{
    ScriptedLink link;
    link.answers[QByteArray::fromHex("01040000000131ca")] = QByteArray::fromHex("018402c2c1");
    link.answers[QByteArray::fromHex("010300000001840a")] = QByteArray::fromHex("0103020007f986");
    const auto found = foundIn(run(link, true));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_TRUE(found[0].link.contains(u"in-area=holding")) << found[0].link.toStdString();
}

TEST(PortFinder, LeavesALineAloneOnWhichAMasterWorks)
{
    ScriptedLink esc;
    esc.chatter = "\x1B"
                  "05P\r\n\r\n00001235\r\n";
    const auto heard = foundIn(run(esc, true));
    ASSERT_EQ(heard.size(), 1U);
    EXPECT_TRUE(heard[0].isMasterAtWork);
    EXPECT_EQ(heard[0].kind, QStringLiteral("esc"));
    EXPECT_EQ(heard[0].certainty, Certainty::certain);
    EXPECT_TRUE(esc.sent.empty());

    ScriptedLink modbus;
    modbus.chatter = QByteArray::fromHex("01040000000131ca0104021234b447");
    const auto other = foundIn(run(modbus, true));
    ASSERT_EQ(other.size(), 1U);
    EXPECT_TRUE(other[0].isMasterAtWork);
    EXPECT_EQ(other[0].kind, QStringLiteral("interbus"));
    EXPECT_TRUE(modbus.sent.empty());
}

TEST(PortFinder, ListensWithOtherSettingsWhereBytesMakeNoSense)
{
    ScriptedLink link;
    link.chatter = QByteArray("\xf3\x80\x1c\x00\xfe", 5);
    const auto news = run(link, true);
    const auto first = std::ranges::find(news, Kind::heard, &FinderNews::kind);
    ASSERT_NE(first, news.end());
    EXPECT_TRUE(first->sentence.contains(u"19200 Bd, 8N2"));
    EXPECT_TRUE(std::ranges::any_of(news, [](const FinderNews &one) {
        return one.sentence.startsWith(u"Bytes come, but none that make sense at 9600 Bd, 8N2: next ");
    }));
    EXPECT_EQ(news.back().kind, Kind::nobody);
    EXPECT_TRUE(link.sent.empty()) << "somebody talks";
}

TEST(PortFinder, SaysWhyAPortCannotBeUsed)
{
    ScriptedLink link;
    link.unplugged = true;
    const auto news = run(link, true);
    ASSERT_EQ(news.size(), 1U);
    EXPECT_EQ(news[0].kind, Kind::refused);
    EXPECT_TRUE(news[0].sentence.contains(u"There is no serial port"));
}

TEST(PortFinder, SendsNothingMoreOnceItWasEnded)
{
    ScriptedLink link;
    PortFinder finder(link, true);
    (void)finder.next();
    (void)finder.next();
    const std::size_t sent = link.sent.size();
    finder.interrupt();
    while (!finder.isDone())
        (void)finder.next();
    EXPECT_LE(link.sent.size(), sent + 1) << "the present step";
}

TEST(PortFinder, SaysBeforehandWhatAskingWouldSend)
{
    const QStringList all = askingAnnouncements({QStringLiteral("/dev/ttyUSB0")});
    ASSERT_EQ(all.size(), 2);
    EXPECT_TRUE(all[0].startsWith(u"Kübler ESC: at 19200, 9600 and 4800 Bd"));
    EXPECT_TRUE(all[1].startsWith(u"Modbus RTU: "));
    EXPECT_TRUE(askingAnnouncements({QStringLiteral("/dev/ttyACM0")}).back().startsWith(u"SLCAN: "));
    EXPECT_TRUE(askingAnnouncements({}).isEmpty());
}

} // namespace
} // namespace codewheel
