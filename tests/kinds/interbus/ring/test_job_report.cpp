// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "jobs/job_report.h"
#include "vocabulary/refusal_text.h"

#include <QLocale>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::ElementsAre;
using Arguments = std::vector<RefusalArgument>;

class JobReport : public testing::Test
{
protected:
    std::vector<Message> report(const Job &job) const { return jobReport(job, m_outcome, m_fraba); }
    void refuseWith(RefusalKind kind, RefusalCode id) { m_outcome.result = refuse(kind, id); }

    const Catalog m_catalog = Catalog::builtIn();
    const DeviceDescription &m_fraba = *m_catalog.find(u"fraba-ocd-ib");
    Outcome m_outcome;
};

TEST_F(JobReport, WrittenParametersAreNamed)
{
    m_outcome.written = {{Parameter::steps, 255}, {Parameter::direction, 3}};
    m_outcome.eepromWrites = 2;
    const auto messages = report(WriteParameters{});
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_EQ(messages[0].id, MessageId::parametersWritten);
    EXPECT_EQ(messages[0].arguments[0], RefusalArgument(std::int64_t{2}));
    EXPECT_EQ(messages[0].arguments[1], RefusalArgument(std::int64_t{2}));
    EXPECT_TRUE(
        messageText(messages[0])
            .contains(QStringLiteral("%1 = 255, %2 = cw")
                          .arg(parameterName(Parameter::steps), parameterName(Parameter::direction))));
}

TEST_F(JobReport, NothingIsSaidOfParametersThatWereThereAlready)
{
    m_outcome.alreadyThere = {{Parameter::steps, 255}};
    EXPECT_TRUE(report(WriteParameters{}).empty());
}

TEST_F(JobReport, ReadingTellsHowMany)
{
    m_outcome.read = {{Parameter::steps, 255}, {Parameter::preset, 0}};
    EXPECT_THAT(report(ReadParameters{}), ElementsAre(Message{.id = MessageId::parametersRead,
                                                              .arguments = Arguments{std::int64_t{2}}}));
}

TEST_F(JobReport, APresetTellsThePositionsThatAreKnown)
{
    m_outcome.positionAfter = 100;
    EXPECT_THAT(report(SetPreset{}),
                ElementsAre(Message{.id = MessageId::presetDone,
                                    .arguments = Arguments{QString(), std::int64_t{100}}}));
}

TEST_F(JobReport, WordsAreCounted)
{
    EXPECT_THAT(report(SendWords{{0x020000FF, 0x80000000}}),
                ElementsAre(Message{.id = MessageId::wordsSent, .arguments = Arguments{std::int64_t{2}}}));
}

TEST_F(JobReport, WhatWasWrittenBeforeARefusalIsTold)
{
    m_outcome.written = {{Parameter::steps, 255}};
    refuseWith(RefusalKind::device, RefusalId::verificationFailed);
    const auto messages = report(WriteParameters{});
    ASSERT_EQ(messages.size(), 2u);
    EXPECT_EQ(messages[0].id, MessageId::parametersWritten);
    EXPECT_EQ(messages[1].severity, Severity::fault);
    EXPECT_EQ(messages[1].refusal, m_outcome.result.error());
}

TEST_F(JobReport, ValuesFromBeforeAreToldWithTheirEvidence)
{
    m_outcome.written = {{Parameter::steps, 8192}};
    m_outcome.camsWritten = {CamProgram{.number = 2, .cam = {}, .shift = 0}};
    m_outcome.eepromWrites = 3;
    refuseWith(RefusalKind::stopped, RefusalId::cancelled);
    m_outcome.restored = Evidence::read;
    auto messages = report(WriteParameters{});
    ASSERT_EQ(messages.size(), 2u);
    const QString text = parameterName(Parameter::steps) +
                         QStringLiteral(" = %1, cam program 2").arg(QLocale().toString(8192));
    EXPECT_EQ(messages[0].id, MessageId::restoredReadBack);
    EXPECT_EQ(messages[0].arguments[1], RefusalArgument(std::int64_t{3}));
    EXPECT_TRUE(messageText(messages[0]).contains(text));
    EXPECT_EQ(messages[1].refusal, m_outcome.result.error());
    m_outcome.restored = Evidence::echoed;
    messages = report(WriteParameters{});
    ASSERT_FALSE(messages.empty());
    EXPECT_EQ(messages[0].id, MessageId::restoredConfirmed);
}

TEST_F(JobReport, WhatTheUserStoppedIsNoFault)
{
    refuseWith(RefusalKind::stopped, RefusalId::cancelled);
    m_outcome.leftIn = EncoderState::parameterization;
    const auto messages = report(WriteParameters{});
    ASSERT_EQ(messages.size(), 2u);
    EXPECT_EQ(messages[0].severity, Severity::attention);
    EXPECT_EQ(messages[1].id, MessageId::leftInParameterization);
}

// Run, which otherwise brings an encoder back, would carry out the reset
TEST_F(JobReport, AResetThatWasConfirmedAndNotRunIsTold)
{
    refuseWith(RefusalKind::stopped, RefusalId::alarmStop);
    m_outcome.leftIn = EncoderState::parameterization;
    m_outcome.resetWaits = true;
    const auto messages = report(ResetToDefault{});
    ASSERT_EQ(messages.size(), 2u);
    EXPECT_EQ(messages[1].id, MessageId::resetWaitsForRun);
}

TEST_F(JobReport, AResetThatWasNotSentDoesNotWaitForRun)
{
    refuseWith(RefusalKind::busy, RefusalId::inParameterization);
    m_outcome.leftIn = EncoderState::parameterization;
    m_outcome.foundInParameterization = true;
    const auto messages = report(ResetToDefault{});
    ASSERT_EQ(messages.size(), 1u) << "the refusal says in which state it is";
    EXPECT_EQ(messages[0].refusal, m_outcome.result.error());
}

TEST_F(JobReport, AnEncoderFoundInParameterizationIsStillThere)
{
    m_outcome.leftIn = EncoderState::parameterization;
    m_outcome.foundInParameterization = true;
    const auto messages = report(ReadParameters{});
    ASSERT_EQ(messages.size(), 2u);
    EXPECT_EQ(messages[1].id, MessageId::stillInParameterization);
}

TEST_F(JobReport, AnEncoderBroughtBackIsTold)
{
    m_outcome.leftIn = EncoderState::operation;
    EXPECT_THAT(report(EndParameterization{}), ElementsAre(Message{.id = MessageId::broughtBack}));
}

TEST_F(JobReport, ASuccessThatAnEncoderWithoutPowerWouldShowIsMarked)
{
    m_outcome.onlyZeroSinceRun = true;
    EXPECT_THAT(report(EndParameterization{}),
                ElementsAre(Message{.id = MessageId::broughtBack},
                            Message{.severity = Severity::attention, .id = MessageId::onlyZeroSinceRun}));
}

} // namespace
} // namespace codewheel
