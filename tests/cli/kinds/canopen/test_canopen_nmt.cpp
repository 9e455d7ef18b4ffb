// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/kinds/canopen/shared_can_bus.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using canopen::NmtState;
using testing::HasSubstr;

TEST(CliNmt, AsksAndTellsWhatTheNodeShowsThen)
{
    SharedCanBus bus;
    EXPECT_EQ(bus.runLine(QStringLiteral("nmt start can:6"), {true, "n\n"}).exit, 2);
    EXPECT_EQ(bus.stateOf6(), NmtState::preOperational);
    const CliRun run = bus.runLine(QStringLiteral("nmt start can:6"), {true, "y\n"});
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, HasSubstr("Start node 6 (06h)?"));
    EXPECT_THAT(run.out, HasSubstr("Node 6 (06h) is operational."));
    EXPECT_EQ(bus.stateOf6(), NmtState::operational);
    EXPECT_EQ(bus.runLine(QStringLiteral("nmt stop can:6 --yes")).exit, 0);
    EXPECT_EQ(bus.stateOf6(), NmtState::stopped);
    const QJsonObject json = bus.runLine(QStringLiteral("nmt pre-operational can:6 --yes --json")).json();
    EXPECT_EQ(json[u"state"], QStringLiteral("preOperational"));
    EXPECT_EQ(json[u"node"], 6);
    EXPECT_EQ(json[u"place"], QStringLiteral("can:6"));
}

TEST(CliNmt, WithoutAPlaceIsForAll)
{
    SharedCanBus bus;
    EXPECT_EQ(bus.runLine(QStringLiteral("nmt start --yes")).exit, 0);
    EXPECT_EQ(bus.stateOf6(), NmtState::operational);
    EXPECT_THAT(bus.runLine(QStringLiteral("nmt stop"), {true, "n\n"}).out, HasSubstr("Stop all nodes?"));
}

TEST(CliNmt, ANodeThatTellsNoStateIsNotTakenToHaveDoneIt)
{
    SharedCanBus bus;
    const CliRun run = bus.runLine(QStringLiteral("nmt stop can:5 --yes"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.err, HasSubstr("Sent. Node 5 (05h) does not tell its state"));
}

TEST(CliNmt, AfterAResetTheNodeHasToReport)
{
    SharedCanBus bus;
    EXPECT_EQ(bus.runLine(QStringLiteral("nmt reset can:6 --yes")).out, "Node 6 (06h) is back.\n");
    const CliRun gone = bus.runLine(QStringLiteral("nmt reset can:50 --yes --json"));
    EXPECT_EQ(gone.exit, 1);
    EXPECT_EQ(errorKey(gone), "notBackAfterReset");
}

TEST(CliNmt, WrongCallsAreRefused)
{
    SharedCanBus bus;
    EXPECT_EQ(errorKey(bus.runLine(QStringLiteral("nmt go --json"))), "nmtCommandWrong");
    EXPECT_EQ(errorKey(bus.runLine(QStringLiteral("nmt start --json"))), "noConsent");
    EXPECT_EQ(errorKey(runLine(QStringLiteral("nmt start --yes --json --link interbus:training"))),
              "noSuchBus");
}

TEST(CliNmt, ARunningNodeShowsItsPositionsWithoutBeingAsked)
{
    SharedCanBus bus;
    EXPECT_EQ(bus.runLine(QStringLiteral("nmt start can:5 --yes")).exit, 0) << "by a PDO";
    const CliRun run = bus.runLine(QStringLiteral("monitor can:5 --for 1"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, HasSubstr("PDO1 88 13 00 00, which is position 5000 if it is mapped"));
    EXPECT_THAT(run.out, HasSubstr("Sent: 0."));
}

} // namespace
} // namespace codewheel
