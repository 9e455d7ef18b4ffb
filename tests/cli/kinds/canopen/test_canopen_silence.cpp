// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/kinds/canopen/shared_can_bus.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;
using testing::Not;

// They acknowledge each other, and tell nothing by themselves once they have started.
std::vector<canopen::CanopenEncoderPlan> silentNodes()
{
    auto one = canopen::trainingEncoders().front();
    auto other = one;
    other.node = 8;
    return {one, other};
}

struct SilentCanBus : SharedCanBus
{
    SilentCanBus()
        : SharedCanBus(silentNodes())
    {
        EXPECT_THAT(runLine(QStringLiteral("scan")).out, HasSubstr("can:5"));
    }
    Instant now() { return plant().bus()->now(); }
};

TEST(CliCanSilence, IsAskedAboutBeforeAnythingIsSent)
{
    SilentCanBus bus;
    const Instant before = bus.now();
    const CliRun declined = bus.runLine(QStringLiteral("read can:5 serial-number"), {true, "n\n"});
    EXPECT_EQ(declined.exit, 2);
    EXPECT_THAT(declined.out + declined.err, HasSubstr("Nothing was heard on the bus for 2 s"));
    EXPECT_THAT(declined.err, HasSubstr("Nothing was sent."));
    EXPECT_GE(bus.now() - before, std::chrono::seconds(2));
    const CliRun agreed = bus.runLine(QStringLiteral("read can:5 serial-number"), {true, "y\n"});
    EXPECT_EQ(agreed.exit, 0) << agreed.err;
}

TEST(CliCanSilence, IsToldWhereNobodyCanBeAsked)
{
    SilentCanBus bus;
    for (const QString &line :
         {QStringLiteral("read can:5 serial-number --json"), QStringLiteral("scan --ask"),
          QStringLiteral("od can:5 read 1000"), QStringLiteral("nmt start can:5 --yes --json")})
        EXPECT_THAT(bus.runLine(line).err, HasSubstr("Nothing was heard on the bus for 2 s before sending."))
            << line.toStdString();
}

TEST(CliCanSilence, EndsWithTheFirstFrame)
{
    SharedCanBus bus;
    bus.runLine(QStringLiteral("scan")); // boot-ups are over: heartbeats come once a second
    for (const QString &line : {QStringLiteral("od can:5 read 1000"), QStringLiteral("nmt start can:6 --yes"),
                                QStringLiteral("read can:6 serial-number")})
        EXPECT_THAT(bus.runLine(line).err, Not(HasSubstr("Nothing was heard"))) << line.toStdString();
}

} // namespace
} // namespace codewheel
