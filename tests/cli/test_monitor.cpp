// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/kinds/interbus/ring_access.h"
#include "tests/cli/cli_run.h"

#include <QJsonArray>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sstream>

namespace codewheel {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<int> cyclesOf(const CliRun &run)
{
    std::vector<int> cycles;
    for (const QJsonValue row : run.json()[u"samples"].toArray())
        cycles.push_back(row[u"cycle"].toInt());
    return cycles;
}

TEST(CliMonitor, AShaftThatStandsStillIsOneRow)
{
    SharedBus shared;
    const CliRun run = shared.runLine(QStringLiteral("monitor 1.0 --json"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(rowsOf(run.json(), "samples"), ElementsAre("00000000 00003039"));
    EXPECT_EQ(shared.bus().latest().cycle, 10'001u);
}

// 10 rpm at 8192 steps: 1365 steps a second.
TEST(CliMonitor, AShaftThatTurnsIsARowEachTenthOfASecond)
{
    const CliRun run = runLine(QStringLiteral("monitor 2.0 --for 1 --json"));
    EXPECT_THAT(cyclesOf(run), ElementsAre(1, 101, 201, 301, 401, 501, 601, 701, 801, 901, 1001));
    EXPECT_EQ(rowsOf(run.json(), "samples").front(), "00000000 000F4240");
    EXPECT_EQ(rowsOf(run.json(), "samples").back(), "00000000 000F4795");
}

// FRABA manual 5.4.2
TEST(CliMonitor, ShowsRevolutionsPerMinuteInVelocityMode)
{
    SharedBus shared;
    shared.controls().setSpeed(NodeId("1.0"), -150);
    shared.runLine(QStringLiteral("velocity 1.0 on"));
    EXPECT_THAT(shared.runLine(QStringLiteral("monitor 1.0 --for 1")).out,
                HasSubstr("00000000  01FFFF6A  Normal running  Running, speed -150 rpm\n"));
}

TEST(CliMonitor, TimeAndIntervalCanBeSet)
{
    EXPECT_THAT(cyclesOf(runLine(QStringLiteral("monitor 2.0 --for 2 --every 1000 --json"))),
                ElementsAre(1, 1001, 2001));
}

TEST(CliMonitor, PrintsWhatTheWordsMean)
{
    EXPECT_THAT(runLine(QStringLiteral("monitor 1.0 --for 1")).out,
                HasSubstr("    1  00000000  00003039  Normal running  Running, position 12345\n"));
}

// A K1 of 12 bits at 3 rpm: 204.8 steps a second; a K2 of 24 bits at -6 rpm: 409.6 steps a second.
TEST(CliMonitor, ShowsEncodersThatHaveOnlyAnInWord)
{
    EXPECT_EQ(runLine(QStringLiteral("monitor 3.0 --for 2 --every 1000")).out,
              "cycle  IN        IN means\n"
              "    1  000003E8  Running, position 1000\n"
              " 1001  000004B4  Running, position 1204\n"
              " 2001  00000581  Running, position 1409\n");
    EXPECT_EQ(runLine(QStringLiteral("monitor 4.0 --for 1 --every 1000")).out,
              "cycle  IN        IN means\n"
              "    1  007A1200  Running, position 8000000\n"
              " 1001  007A1066  Running, position 7999590\n");
}

// Notes the cycle of the bus whenever something is printed.
class PrintsSeen : public std::stringbuf
{
public:
    explicit PrintsSeen(RingSession &bus)
        : m_bus(bus)
    {}
    std::vector<std::uint64_t> cycles;

protected:
    int sync() override
    {
        cycles.push_back(m_bus.latest().cycle);
        return 0;
    }

private:
    RingSession &m_bus;
};

// Somebody watches for an hour, and the rows of an hour are not kept.
TEST(CliMonitor, EachRowIsPrintedAsItComes)
{
    for (const auto &line :
         {QStringLiteral("2.0 --for 1 --every 250"), QStringLiteral("2.0 --for 1 --every 250 --json")}) {
        SharedBus shared;
        PrintsSeen seen(shared.bus());
        std::istringstream in;
        std::ostream out(&seen);
        std::ostringstream err;
        RingAccess ring(shared.bus());
        const auto arguments = parseArguments(line.split(u' '), optionsOf(monitorCommand), {});
        ASSERT_TRUE(arguments);
        EXPECT_EQ(runOn(monitorCommand, *arguments, Catalog::builtIn(), {&ring}, Terminal{in, out, err}), 0);
        EXPECT_THAT(seen.cycles, testing::IsSupersetOf({1u, 251u, 501u, 751u, 1'001u})) << line.toStdString();
    }
}

TEST(CliMonitor, RefusesTimesThatMakeNoSense)
{
    for (const char *option : {"--for 0", "--for soon", "--every 0", "--for 3601"}) {
        const CliRun run = runLine(QStringLiteral("monitor 1.0 %1 --json").arg(QString::fromLatin1(option)));
        EXPECT_EQ(run.exit, 2) << option;
        EXPECT_EQ(errorKey(run), "optionOutOfRange") << option;
    }
}

} // namespace
} // namespace codewheel
