// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "cli/call/command_line.h"
#include "cli/call/stop_signals.h"
#include "cli/commands.h"
#include "cli/kinds/interbus/ring_access.h"
#include "kinds/interbus/ring/ring_session.h"
#include "tests/cli/cli_run.h"
#include "tests/support/scripted_link.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sstream>

namespace codewheel {
namespace {

using testing::HasSubstr;

// A ring without a plan: an encoder of unnamed make, and a digital input.
class CliForeignRing : public testing::Test
{
protected:
    CliForeignRing()
        : m_link(new ScriptedLink(
              RingStructure{{NodeId("1.0"), 0x0237, 2, 2, {}}, {NodeId("2.0"), 0x81BE, 1, 0, {}}}))
        , m_bus(std::unique_ptr<ScriptedLink>(m_link), m_catalog,
                QDateTime(QDate(2026, 3, 1), QTime(14, 2), Qt::UTC))
    {
        EXPECT_TRUE(m_bus.open(RingSession::Start::operating));
    }

    CliRun run(const Subcommand &command, const QStringList &rest)
    {
        std::istringstream in;
        std::ostringstream out;
        std::ostringstream err;
        RingAccess ring(m_bus);
        const int exit =
            runOn(command, {.rest = rest, .options = {}}, m_catalog, {&ring}, Terminal{in, out, err});
        return {exit, out.str(), err.str()};
    }

    ScriptedLink *m_link; // owned by the bus
    const Catalog m_catalog = Catalog::builtIn();
    RingSession m_bus;
};

TEST_F(CliForeignRing, AMonitorOfWordsEndsWithItsLink)
{
    m_link->failAt(500);
    const CliRun run = this->run(monitorCommand, {QStringLiteral("1.0")});
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.err, HasSubstr("The link failed: "));
    EXPECT_THAT(run.out, HasSubstr("OUT means")) << "what was seen until then";
    EXPECT_LT(m_link->exchanges(), 1'000);
}

TEST_F(CliForeignRing, CtrlCEndsAMonitorOfWords)
{
    StopSignals held; // so that only the command gets it
    m_link->answerWith([this](std::size_t, Word) {
        if (m_link->exchanges() == 500)
            std::raise(SIGINT);
        return Word{0};
    });
    EXPECT_EQ(run(monitorCommand, {QStringLiteral("1.0")}).exit, 0);
    EXPECT_LT(m_link->exchanges(), 1'000);
}

TEST_F(CliForeignRing, ScanDoesNotGuessTheMake)
{
    EXPECT_EQ(run(scanCommand, {}).out,
              "place  ID code    device code  IN words  OUT words  profile  device\n"
              "1.0    37h (55)   0237h               2          2  K3       make not known\n"
              "2.0    BEh (190)  81BEh               1          0  -        make not known\n"
              "\n"
              "Master:         not reached by this link\n");
}

TEST_F(CliForeignRing, ADeviceThatIsNoEncoderIsNotDriven)
{
    EXPECT_EQ(run(monitorCommand, {QStringLiteral("1.0")}).exit, 0);
    const CliRun input = run(monitorCommand, {QStringLiteral("2.0")});
    EXPECT_EQ(input.exit, 2);
    EXPECT_THAT(input.err, HasSubstr("2.0 is not an encoder this program can drive"));
}

TEST_F(CliForeignRing, AnEncoderThatDoesNotAnswerIsExit1)
{
    const CliRun words = run(wordsCommand, {QStringLiteral("1.0"), QStringLiteral("020000FF")});
    EXPECT_EQ(words.exit, 1);
    EXPECT_THAT(words.err, HasSubstr("did not answer within 2 s"));
}

TEST_F(CliForeignRing, ALinkThatFailsIsExit1)
{
    ASSERT_EQ(run(monitorCommand, {QStringLiteral("1.0")}).exit, 0);
    m_link->failAt(5);
    const CliRun words = run(wordsCommand, {QStringLiteral("1.0"), QStringLiteral("020000FF")});
    EXPECT_EQ(words.exit, 1);
    EXPECT_NE(words.err, "");
}

} // namespace
} // namespace codewheel
