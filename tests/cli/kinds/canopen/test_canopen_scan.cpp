// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/project_file.h"
#include "tests/cli/kinds/canopen/shared_can_bus.h"

#include <QJsonArray>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

TEST(CliCanScan, ListensToWhoTellsOfItself)
{
    SharedCanBus bus;
    const CliRun run = bus.runLine(QStringLiteral("scan"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_EQ(run.err, "");
    EXPECT_EQ(run.out, "place  state            PDO  errors\n"
                       "can:5  boot-up          -    -\n"
                       "can:6  pre-operational  -    -\n"
                       "can:7  pre-operational  -    -\n");
    const CliRun again = bus.runLine(QStringLiteral("scan")); // can:5 said only that it had started
    EXPECT_THAT(again.out, HasSubstr("can:6"));
    EXPECT_THAT(again.out, Not(HasSubstr("can:5")));
}

TEST(CliCanScan, AsksWhatEachIs)
{
    SharedCanBus bus;
    const CliRun run = bus.runLine(QStringLiteral("scan --ask"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, HasSubstr("can:5  boot-up          -    canopen-406-single-turn  10Dh    13h      "
                                   "10000h    1234321 (12D591h)  -\n"));
    EXPECT_THAT(run.out, HasSubstr("canopen-406-linear"));
}

TEST(CliCanScan, TellsProgramsTheSame)
{
    SharedCanBus bus;
    const QJsonArray nodes = bus.runLine(QStringLiteral("scan --ask --json")).json()[u"nodes"].toArray();
    ASSERT_EQ(nodes.size(), 3);
    EXPECT_EQ(nodes[1].toObject(), (QJsonObject{{QStringLiteral("place"), QStringLiteral("can:6")},
                                                {QStringLiteral("node"), 6},
                                                {QStringLiteral("state"), QStringLiteral("preOperational")},
                                                {QStringLiteral("heartbeat"), QStringLiteral("heard")},
                                                {QStringLiteral("sendsPdos"), false},
                                                {QStringLiteral("doubled"), false},
                                                {QStringLiteral("error"), QJsonValue()},
                                                {QStringLiteral("answers"), true},
                                                {QStringLiteral("deviceType"), 0x2'0196},
                                                {QStringLiteral("vendor"), 0x10D},
                                                {QStringLiteral("product"), 0x25},
                                                {QStringLiteral("revision"), 0x1'0001},
                                                {QStringLiteral("serialNumber"), 1'234'340}}));
}

TEST(CliCanScan, ThatFindsNobodySaysWhatToDo)
{
    SharedCanBus bus(std::vector<canopen::CanopenEncoderPlan>{});
    EXPECT_THAT(bus.runLine(QStringLiteral("scan")).out, HasSubstr("scan --ask asks each"));
    EXPECT_EQ(errorKey(bus.runLine(QStringLiteral("scan --ask --json"))), "nobodyAcknowledges");
    EXPECT_EQ(errorKey(bus.runLine(QStringLiteral("od can:5 read 1000 --json"))), "nobodyAcknowledges");
    EXPECT_EQ(errorKey(bus.runLine(QStringLiteral("read can:5 --json"))), "nobodyAcknowledges");
}

// Says one frame of J1939 after the other.
class J1939Talker final : public CanParticipant
{
public:
    J1939Talker() { m_frame.isExtended = true; }
    int rate() const override { return 125'000; }
    const CanFrame *toSend() const override { return &m_frame; }
    void sent(const CanFrame & /*frame*/, Instant /*now*/) override {}
    void take(const CanFrame & /*frame*/, Instant /*now*/) override {}

private:
    CanFrame m_frame{.id = 0x0CFFE0E0, .length = 8};
};

TEST(CliCanScan, WhereOnlyJ1939IsHeardNothingIsSent)
{
    SharedCanBus bus(std::vector<canopen::CanopenEncoderPlan>{});
    const auto talker = std::make_shared<J1939Talker>();
    bus.plant().bus()->add(talker);
    bus.plant().bus()->add(std::make_shared<J1939Talker>()); // acknowledges
    const CliRun heard = bus.runLine(QStringLiteral("scan"));
    EXPECT_EQ(heard.exit, 0);
    EXPECT_THAT(heard.out, HasSubstr("J1939"));
    for (const char *line : {"scan --ask --json", "od can:5 read 1000 --json", "read can:5 --json",
                             "nmt start can:5 --yes --json"})
        EXPECT_EQ(errorKey(bus.runLine(QString::fromLatin1(line))), "onlyJ1939") << line;
}

TEST(CliCanScan, OnAFullBusItWaitsAndSaysHowFullItIs)
{
    SharedCanBus bus;
    bus.plant().setBackground({.load = 97});
    const CliRun run = bus.runLine(QStringLiteral("scan --ask"));
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("canopen-406-linear"));
    EXPECT_THAT(run.out, HasSubstr("% full"));
    EXPECT_THAT(bus.runLine(QStringLiteral("od can:50 read 1000")).err, HasSubstr("% full"));
    EXPECT_THAT(bus.runLine(QStringLiteral("read can:50 serial-number")).err, HasSubstr("% full"));
}

TEST(CliCanScan, MakesAProjectAndNeverShrinksIt)
{
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("p.codewheel"));
    SharedCanBus bus;
    EXPECT_EQ(bus.runLine(QStringLiteral("scan --ask --save ") + file).exit, 0);
    const auto found = loadProject(file);
    ASSERT_TRUE(found);
    ASSERT_EQ(found->devices.size(), 3U);
    EXPECT_EQ(found->devices[2].participant.deviceKey, QStringLiteral("canopen-406-linear"));
    EXPECT_EQ(found->devices[1].label.serialNumber, QStringLiteral("1234340"));

    SharedCanBus empty(std::vector<canopen::CanopenEncoderPlan>{});
    const CliRun run = empty.runLine(QStringLiteral("scan --yes --save %1 --project %1").arg(file));
    EXPECT_THAT(run.out, HasSubstr("nothing answers there"));
    EXPECT_EQ(loadProject(file)->devices.size(), 3U);
}

TEST(CliCanScan, ItsOptionsAreForCanBuses)
{
    SharedCanBus bus;
    EXPECT_EQ(errorKey(bus.runLine(QStringLiteral("scan --listen 0 --json"))), "optionOutOfRange");
    EXPECT_EQ(errorKey(runLine(QStringLiteral("scan --ask --json --link esc:training"))), "optionOfOtherBus");
}

TEST(CliCanScan, TheTrainingBusesEndWithTheCanBus)
{
    const CliRun run = runLine(QStringLiteral("scan"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, EndsWith("CAN: CAN bus (CANopen)\n"
                                  "place  state            PDO  errors\n"
                                  "can:5  boot-up          -    -\n"
                                  "can:6  pre-operational  -    -\n"
                                  "can:7  pre-operational  -    -\n"));
    EXPECT_THAT(runLine(QStringLiteral("read can:6 serial-number")).out, HasSubstr("1234340"));
}

} // namespace
} // namespace codewheel
