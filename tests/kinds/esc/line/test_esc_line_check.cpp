// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/esc_line_check.h"
#include "kinds/esc/simulator/simulated_esc_line_link.h"
#include "tests/kinds/esc/line/scripted_line.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using enum CheckOutcome;

std::vector<EscLineFinding> run(ByteLink &link, const std::vector<EscLineAddress> &addresses,
                                const EscLineSettings &settings = {})
{
    EscLineCheck check(link, settings, addresses);
    std::vector<EscLineFinding> findings;
    while (!check.isDone())
        findings.push_back(check.next());
    return findings;
}

std::vector<CheckOutcome> outcomesOf(const std::vector<EscLineFinding> &findings)
{
    std::vector<CheckOutcome> all;
    for (const EscLineFinding &finding : findings)
        all.push_back(finding.outcome);
    return all;
}

TEST(EscLineCheck, TellsThePositionOfEachEncoderOfTheProject)
{
    SimulatedEscLineLink link(std::make_shared<SimulatedEscLine>());
    const auto findings = run(link, {{3}, {5}});
    EXPECT_EQ(outcomesOf(findings), (std::vector{passed, passed, passed, passed, passed}));
    ASSERT_EQ(findings.size(), 5U);
    EXPECT_EQ(findings.back().step, EscLineStep::encoder);
    EXPECT_EQ(findings.back().address, EscLineAddress{5});
    EXPECT_TRUE(findings.back().sentence.contains(u"(00001235h)")) << findings.back().sentence.toStdString();
}

TEST(EscLineCheck, AsksAnybodyWhereNoEncoderIsPlanned)
{
    SimulatedEscLineLink link(std::make_shared<SimulatedEscLine>(std::vector{trainingLine().front()}));
    const auto findings = run(link, {});
    EXPECT_EQ(outcomesOf(findings), (std::vector{passed, passed, passed, passed}));
    EXPECT_TRUE(findings.back().address.isMaster());
}

TEST(EscLineCheck, SaysWhichEncoderIsSilentAndGoesOn)
{
    SimulatedEscLineLink link(std::make_shared<SimulatedEscLine>());
    const auto findings = run(link, {{4}, {5}});
    EXPECT_EQ(outcomesOf(findings), (std::vector{passed, passed, passed, failed, passed}));
    EXPECT_TRUE(findings[3].sentence.startsWith(u"Nothing came."));
}

TEST(EscLineCheck, SaysThatBytesMakeNoSenseAtThisRate)
{
    ScriptedLink scripted;
    scripted.answers["\x1b"
                     "03P\r\n"] = QByteArray("\xf3\x80\x1c", 3);
    const auto findings = run(scripted, {{3}});
    EXPECT_EQ(outcomesOf(findings), (std::vector{passed, passed, passed, failed}));
    EXPECT_TRUE(findings.back().sentence.startsWith(u"9 bytes came, but"))
        << findings.back().sentence.toStdString();
}

TEST(EscLineCheck, KnowsAnEchoFromAnAnswer)
{
    ScriptedLink link;
    link.answers["\x1b"
                 "03P\r\n"] = QByteArray("\x1b"
                                         "03P\r\n");
    const auto findings = run(link, {{3}});
    EXPECT_TRUE(findings.back().sentence.startsWith(u"Only the request came back"));
}

TEST(EscLineCheck, AsksNothingWhereSomebodyTalks)
{
    ScriptedLink link;
    link.chatter = "\x1b"
                   "03P\r\n";
    const auto findings = run(link, {{3}});
    EXPECT_EQ(outcomesOf(findings), (std::vector{passed, passed, failed, skipped}));
    EXPECT_TRUE(findings[2].sentence.startsWith(u"36 bytes came before"))
        << findings[2].sentence.toStdString();
    EXPECT_TRUE(link.sent.empty());
}

TEST(EscLineCheck, EndsWithThePortThatIsMissing)
{
    ScriptedLink link;
    link.unplugged = true;
    const auto findings = run(link, {{3}});
    EXPECT_EQ(outcomesOf(findings), (std::vector{failed, skipped, skipped, skipped}));
    ASSERT_TRUE(findings.front().why);
    EXPECT_EQ(findings.front().why->id, RefusalId::portNotFound);
}

TEST(EscLineCheck, SaysThatTheAdapterGrantsNoLowLatency)
{
    ScriptedLink link;
    link.latency = LowLatency::refused;
    EXPECT_TRUE(run(link, {{3}})[1].sentence.contains(u"16 ms"));
}

TEST(EscLineCheck, AsksNothingOnceItWasEnded)
{
    ScriptedLink link;
    EscLineCheck check(link, {}, {{3}, {4}});
    std::vector<EscLineFinding> findings{check.next()};
    check.interrupt();
    while (!check.isDone())
        findings.push_back(check.next());
    EXPECT_EQ(outcomesOf(findings), (std::vector{passed, skipped, skipped, skipped, skipped}));
    EXPECT_TRUE(link.sent.empty());
}

} // namespace
} // namespace codewheel
