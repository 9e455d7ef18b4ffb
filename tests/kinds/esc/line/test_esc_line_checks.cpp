// SPDX-License-Identifier: GPL-3.0-or-later
// Why there is no data of a serial line: what each cause makes differ first, and what is said about it.
#include "bus/data_check.h"
#include "catalog/catalog.h"
#include "kinds/esc/driver/esc_driver.h"
#include "kinds/esc/line/esc_line_session.h"
#include "kinds/esc/simulator/simulated_esc_line_link.h"
#include "tests/kinds/esc/line/scripted_line.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr EscLineAddress asked{5};

class EscLineChecks : public testing::Test
{
protected:
    void open(const SerialSettings &settings = {})
    {
        EXPECT_TRUE(
            session.open(settings, {}, EscLineSession::Start::watching, EscLineSession::Drive::byHand));
        for (const EscLineAddress address : line->addresses())
            EXPECT_TRUE(session.add(address, QStringLiteral("kuebler-esc-rs485")));
        session.advance(2s);
    }
    DataChecks of(NodeId node = asked.node()) const { return session.dataChecks(node, planned); }
    void expectFirst(NodeId node, DataCheck::Id id, const char *remedy, DataCheck::Action action) const
    {
        const DataChecks checks = of(node);
        const DataCheck *first = firstDifference(checks);
        ASSERT_NE(first, nullptr);
        EXPECT_EQ(first->id, id) << first->what.toStdString();
        EXPECT_TRUE(first->remedy.startsWith(QLatin1String(remedy))) << first->remedy.toStdString();
        EXPECT_EQ(first->action, action);
    }

    const Catalog catalog = Catalog::builtIn();
    const std::shared_ptr<SimulatedEscLine> line = std::make_shared<SimulatedEscLine>();
    EscLineSession session{std::make_unique<SimulatedEscLineLink>(line), catalog,
                           QDateTime(QDate(2026, 11, 21), QTime(12, 0)),
                           [](const DeviceDescription &device, EscLineAddress address) {
                               return std::make_unique<EscDriver>(device, address);
                           }};
    std::vector<Participant> planned{};
};

TEST_F(EscLineChecks, WhereDataComesOnlyWatchIsWorthARemark)
{
    open();
    const DataChecks checks = of();
    EXPECT_EQ(firstDifference(checks), nullptr);
    EXPECT_EQ(findCheck(checks, DataCheck::Id::writing)->outcome, DataCheck::Outcome::remark);
    EXPECT_EQ(findCheck(checks, DataCheck::Id::position)->outcome, DataCheck::Outcome::asExpected);
}

TEST_F(EscLineChecks, ALineThatIsNotConnectedSaysSoFirst)
{
    expectFirst({}, DataCheck::Id::link, "The bus is not connected.", DataCheck::Action::connectBus);
}

TEST_F(EscLineChecks, AnAdapterThatWasUnpluggedIsTold)
{
    open();
    line->setUnplugged(true);
    session.advance(2s);
    expectFirst(asked.node(), DataCheck::Id::link, "The serial port ", DataCheck::Action::connection);
    const DataChecks checks = of();
    ASSERT_TRUE(firstDifference(checks)->why);
    EXPECT_EQ(firstDifference(checks)->why->id, RefusalId::portLost);
}

TEST_F(EscLineChecks, WhereNoEncoderIsPlannedNoneIsAsked)
{
    EXPECT_TRUE(session.open({}, {}, EscLineSession::Start::watching, EscLineSession::Drive::byHand));
    session.advance(2s);
    expectFirst({}, DataCheck::Id::devices, "No device is planned on this bus", DataCheck::Action::search);
    EXPECT_EQ(findCheck(of({}), DataCheck::Id::bytes), nullptr) << "nobody knows";
}

TEST_F(EscLineChecks, PositionsThatNobodyAsksForAreTold)
{
    open();
    session.setRunning(false);
    session.advance(1s);
    expectFirst(asked.node(), DataCheck::Id::running, "Nobody asks for positions", DataCheck::Action::start);
}

TEST_F(EscLineChecks, NoBytesAtAllAreTold)
{
    open();
    line->setSilent(true);
    session.advance(30s);
    for (const NodeId node : {asked.node(), NodeId()})
        expectFirst(node, DataCheck::Id::bytes, "No encoder answers on ", DataCheck::Action::connection);
}

// The encoders do not understand the requests, so nothing comes.
TEST_F(EscLineChecks, AtAWrongRateNothingComesAndTheRateThatIsSetIsNamed)
{
    open({.baudRate = 9'600});
    session.advance(30s);
    expectFirst(asked.node(), DataCheck::Id::bytes, "No encoder answers on training line at 9600 Bd.",
                DataCheck::Action::connection);
    const DataChecks checks = of();
    EXPECT_TRUE(firstDifference(checks)->remedy.endsWith(QStringLiteral("and the baud rate.")));
    EXPECT_TRUE(firstDifference(checks)->came.startsWith(QStringLiteral("none for ")))
        << firstDifference(checks)->came.toStdString();
    EXPECT_EQ(findCheck(checks, DataCheck::Id::sense)->outcome, DataCheck::Outcome::notKnown);
}

// Its answer, as it looks at another rate.
TEST(LineChecksAtAWrongRate, GarbageThatComesIsCountedAndTheRateThatIsSetIsNamed)
{
    const Catalog catalog = Catalog::builtIn();
    auto link = std::make_unique<ScriptedLink>();
    link->answers["\x1B"
                  "05P\r\n"] = "\xF3\x80\xFE\x9C\x80";
    link->answersAt = 9'600;
    EscLineSession session(std::move(link), catalog, QDateTime(QDate(2026, 11, 21), QTime(12, 0)),
                           [](const DeviceDescription &device, EscLineAddress address) {
                               return std::make_unique<EscDriver>(device, address);
                           });
    EXPECT_TRUE(session.open({.baudRate = 9'600}, {}, EscLineSession::Start::watching,
                             EscLineSession::Drive::byHand));
    EXPECT_TRUE(session.add(asked, QStringLiteral("kuebler-esc-rs485")));
    session.advance(30s);
    const DataChecks checks = session.dataChecks(asked.node(), {});
    EXPECT_EQ(findCheck(checks, DataCheck::Id::bytes)->outcome, DataCheck::Outcome::asExpected);
    const DataCheck *first = firstDifference(checks);
    ASSERT_NE(first, nullptr);
    EXPECT_EQ(first->id, DataCheck::Id::sense) << first->what.toStdString();
    EXPECT_TRUE(first->expected.contains(QStringLiteral("9600 Bd"))) << first->expected.toStdString();
    EXPECT_TRUE(first->came.endsWith(QStringLiteral(" bytes that are no answer")))
        << first->came.toStdString();
    EXPECT_TRUE(first->remedy.contains(QStringLiteral("Check baud rate and format")));
    EXPECT_EQ(first->action, DataCheck::Action::connection);
}

TEST_F(EscLineChecks, BytesThatMakeNoSenseAreTold)
{
    open();
    line->setFaults({.doubled = 1'000});
    session.advance(60s);
    expectFirst(asked.node(), DataCheck::Id::sense, "", DataCheck::Action::connection);
    EXPECT_TRUE(firstDifference(of())->remedy.contains(QStringLiteral("Check baud rate and format")));
}

TEST_F(EscLineChecks, AnEchoIsNoAnswer)
{
    open();
    line->setFaults({.echo = true});
    line->setSilent(true);
    session.advance(30s);
    expectFirst(asked.node(), DataCheck::Id::echo, "Only the request came back",
                DataCheck::Action::connection);
}

TEST_F(EscLineChecks, OneThatIsSilentAmongOthersIsLookedForAtItself)
{
    open();
    line->withEncoder(asked, [](SimulatedEscEncoder &encoder) { encoder.condition().mute = true; });
    session.advance(10s);
    expectFirst(asked.node(), DataCheck::Id::answer, "esc:05 does not answer.",
                DataCheck::Action::connection);
}

TEST_F(EscLineChecks, AnAlarmIsToldWithWhatToDo)
{
    open();
    line->withEncoder(asked, [](SimulatedEscEncoder &encoder) { encoder.condition().batteryFlat = true; });
    session.advance(10s);
    expectFirst(asked.node(), DataCheck::Id::alarms, "esc:05 reports an alarm: ", DataCheck::Action::none);
}

TEST_F(EscLineChecks, AnEncoderThatIsOnlyPlannedIsNotThere)
{
    open();
    planned = {{.number = EscLineAddress{9}.node(), .deviceKey = QStringLiteral("kuebler-esc-rs485")}};
    expectFirst(EscLineAddress{9}.node(), DataCheck::Id::kind, "esc:09 is not connected.",
                DataCheck::Action::compare);
}

} // namespace
} // namespace codewheel
