// SPDX-License-Identifier: GPL-3.0-or-later
// Modes, FRABA preset and reset through the parameter panel's menu, with the mouse.
#include "tests/app/question.h"
#include "tests/widgets/training_bus_session.h"
#include "widgets/dial/code_disc.h"
#include "widgets/look/inline_message.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/wanted_values.h"
#include "widgets/project/project_document.h"

#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QPoint>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vector>

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;
using test::Question;
using testing::ElementsAre;

class EncoderFunctionsTest : public testing::Test
{
protected:
    EncoderFunctionsTest()
    {
        m_panel.resize(290, 480);
        m_panel.show();
        show(fraba);
    }
    void show(Place number)
    {
        m_number = number;
        m_panel.setEncoder(&encoder());
        m_ring.bus.advance(33);
        QObject::connect(&encoder(), &EncoderSession::exchanged, &m_panel, [this](const Exchange &row) {
            if (m_sent.empty() || m_sent.back() != row.out)
                m_sent.push_back(row.out);
        });
    }
    void isInPositionMode()
    {
        encoder().tell(Parameter::startUpMode, 1);
        m_ring.bus.advance(33);
    }
    EncoderSession &encoder() { return m_ring.encoder(m_number); }
    QAction &action(const char *name)
    {
        for (QAction *found : m_panel.functionActions())
            if (found->objectName() == QLatin1String(name))
                return *found;
        throw std::logic_error(name);
    }
    void click(const char *name)
    {
        QMenu *menu = m_panel.findChild<QMenu *>(QStringLiteral("moreMenu"));
        ASSERT_NE(menu, nullptr);
        menu->popup(m_panel.mapToGlobal(QPoint(0, 0)));
        QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(&action(name)).center());
    }
    void finishJobs()
    {
        for (int i = 0; i < 200; ++i)
            m_ring.bus.advance(10);
        ASSERT_FALSE(encoder().runningJob());
    }
    QString message()
    {
        return m_panel.findChild<InlineMessage *>(QStringLiteral("panelMessage"))->sentence();
    }

    test::TrainingBusSession m_ring;
    ProjectDocument m_project;
    WantedValues m_wanted{m_project};
    ParameterPanel m_panel{m_ring.buses, m_wanted};
    Place m_number;
    std::vector<Word> m_sent;
};

TEST_F(EncoderFunctionsTest, VelocityModeIsSwitchedOnAndOffAndTheTickFollowsTheEncoder)
{
    isInPositionMode();
    m_ring.controls->setSpeed(fraba.node, -150);
    EXPECT_TRUE(action("positionMode").isChecked());
    click("velocityMode");
    EXPECT_FALSE(action("velocityMode").isChecked()) << "the encoder has not switched yet";
    finishJobs();
    EXPECT_THAT(m_sent, ElementsAre(0x2040'0001u, 0u));
    EXPECT_EQ(encoder().latest().velocity, -150);
    EXPECT_TRUE(action("velocityMode").isChecked());
    EXPECT_TRUE(action("velocityMode").text().contains(QStringLiteral("now: velocity mode")));
    EXPECT_TRUE(message().contains(QStringLiteral("The encoder is in velocity mode.")))
        << message().toStdString();
    click("velocityMode");
    finishJobs();
    EXPECT_TRUE(action("positionMode").isChecked());
    EXPECT_TRUE(encoder().latest().position);
}

// IN acknowledges the word, as it does a cam word.
TEST_F(EncoderFunctionsTest, AnEncoderInCamModeThatWasToldToBeInPositionModeIsNotSwitched)
{
    ASSERT_TRUE(encoder().start(SwitchMode{.mode = Mode::cam, .camProgram = 1}));
    finishJobs();
    isInPositionMode(); // it is not
    click("velocityMode");
    finishJobs();
    EXPECT_EQ(encoder().latest().in, 0xE040'0001u);
    EXPECT_TRUE(message().contains(QStringLiteral("The encoder is in cam mode: there the word 20400001")))
        << message().toStdString();
    EXPECT_FALSE(message().contains(QStringLiteral("Switch it back"))) << "which keeps what was changed";
    EXPECT_FALSE(action("velocityMode").isChecked());
    EXPECT_EQ(encoder().latest().mode, Mode::cam);
}

TEST_F(EncoderFunctionsTest, AResetThatIsRefusedInParameterizationDoesNotWaitForRun)
{
    isInPositionMode();
    ASSERT_TRUE(encoder().start(SendWords{.words = {0x0200'00FF, 0}}));
    finishJobs();
    ASSERT_EQ(encoder().latest().state, EncoderState::parameterization);
    const Question question = Question::answeredBy(QStringLiteral("Reset"));
    click("resetToDefault");
    finishJobs();
    EXPECT_TRUE(message().contains(QStringLiteral("Nothing was written"))) << message().toStdString();
    EXPECT_FALSE(message().contains(QStringLiteral("waits for run"))) << message().toStdString();
    EXPECT_EQ(encoder().takenWithoutRun(), QStringLiteral("Steps = 255"));
}

TEST_F(EncoderFunctionsTest, AModeThatIsNotKnownIsAskedFor)
{
    EXPECT_TRUE(action("velocityMode").text().contains(QStringLiteral("now: not known")));
    {
        const Question question = Question::answeredBy(QStringLiteral("It is in position mode"));
        click("velocityMode");
        EXPECT_TRUE(question.text().contains(QStringLiteral("20400001 changes which cams are active")))
            << question.text().toStdString();
    }
    finishJobs();
    EXPECT_THAT(m_sent, ElementsAre(0x2040'0001u, 0u));
    EXPECT_EQ(encoder().latest().mode, Mode::velocity);
}

TEST_F(EncoderFunctionsTest, AnUnnamedK3IsToldToBeInPositionMode)
{
    show(baumer);
    EXPECT_FALSE(action("isInPositionMode").isVisible());
    ASSERT_TRUE(m_ring.bus.name(baumer, {}));
    show(baumer);
    EXPECT_TRUE(action("isInPositionMode").isVisible());
    EXPECT_FALSE(action("positionMode").isVisible()) << "which word switches it, only its make tells";
    click("isInPositionMode");
    finishJobs();
    EXPECT_EQ(encoder().latest().mode, Mode::position);
    EXPECT_FALSE(action("isInPositionMode").isVisible());
    EXPECT_TRUE(std::ranges::all_of(m_sent, [](Word out) { return out == 0; }));
}

TEST_F(EncoderFunctionsTest, ItCanBePutIntoPositionModeFirst)
{
    {
        const Question question = Question::answeredBy(QStringLiteral("Put it into position mode"));
        click("velocityMode");
    }
    finishJobs();
    EXPECT_THAT(m_sent, ElementsAre(0x2080'0000u, 0x2040'0000u, 0u, 0x2040'0001u, 0u));
    EXPECT_EQ(encoder().latest().mode, Mode::velocity);
}

TEST_F(EncoderFunctionsTest, CancelSendsNothing)
{
    for (const char *name : {"velocityMode", "frabaPreset", "resetToDefault"}) {
        const Question question = Question::answeredBy(QStringLiteral("Cancel"));
        click(name);
        finishJobs();
        EXPECT_TRUE(m_sent.empty()) << name;
    }
}

TEST_F(EncoderFunctionsTest, TheFrabaPresetStandsForOneCycle)
{
    isInPositionMode();
    {
        const Question question = Question::answeredBy(QStringLiteral("Set position"));
        click("frabaPreset");
        EXPECT_TRUE(question.text().contains(QStringLiteral("EEPROM writes by this: at most 1.")))
            << question.text().toStdString();
        EXPECT_TRUE(question.text().contains(QStringLiteral("not known: read it")));
    }
    finishJobs();
    EXPECT_THAT(m_sent, ElementsAre(0x2021'0004u, 0u, 0x6000'0000u, 0u)) << "the preset is read first";
    EXPECT_EQ(encoder().latest().position, 0);
    EXPECT_EQ(encoder().eepromWrites(), 1);
    EXPECT_TRUE(message().contains(QStringLiteral("Position: 0."))) << message().toStdString();
}

// It takes the preset, and goes on showing its speed.
TEST_F(EncoderFunctionsTest, ASpeedIsNotTakenForThePositionThatWasNotSet)
{
    isInPositionMode();
    ASSERT_TRUE(encoder().start(WriteParameters{.values = {{Parameter::preset, 1'000}}, .previous = {}}));
    finishJobs();
    click("velocityMode");
    finishJobs();
    m_ring.controls->setSpeed(fraba.node, 10);
    isInPositionMode(); // it is not
    {
        const Question question = Question::answeredBy(QStringLiteral("Set position"));
        click("frabaPreset");
    }
    m_ring.bus.advance(2'500);
    finishJobs();
    EXPECT_TRUE(
        message().contains(QStringLiteral("it is not known whether the position was set: position mode "
                                          "would show 1000, but IN is 0000000A")))
        << message().toStdString();
    EXPECT_FALSE(message().contains(QStringLiteral("was not set")));
    EXPECT_EQ(encoder().latest().mode, std::nullopt);
    EXPECT_EQ(encoder().latest().position, std::nullopt);
    EXPECT_TRUE(action("velocityMode").text().contains(QStringLiteral("now: not known")));
}

// Also while the shaft turns; nothing is sent before the answer.
TEST_F(EncoderFunctionsTest, TheQuestionBeforeThePresetShowsNowAndThen)
{
    isInPositionMode();
    for (const auto &[parameter, value] :
         {std::pair(Parameter::steps, 8192), {Parameter::revolutions, 1}, {Parameter::direction, 3}})
        encoder().tell(parameter, value);
    std::vector<DialState> seen;
    {
        const Question question([&](QWidget &box) {
            const auto *disc = box.findChild<CodeDisc *>();
            ASSERT_NE(disc, nullptr);
            EXPECT_TRUE(disc->isVisible());
            seen.push_back(disc->state());
            encoder().tell(Parameter::preset, 1024);
            m_ring.controls->turnTo(fraba.node, 4096);
            m_ring.bus.advance(66);
            seen.push_back(disc->state());
            QTest::keyClick(&box, Qt::Key_Escape);
        });
        click("frabaPreset");
    }
    ASSERT_EQ(seen.size(), 2u);
    EXPECT_EQ(seen[0].position, 12345);
    EXPECT_EQ(seen[0].then, DialState::Then()) << "its preset is not known";
    EXPECT_TRUE(seen[0].note.contains(QStringLiteral("Preset"))) << seen[0].note.toStdString();
    EXPECT_EQ(seen[1].position, 4096);
    EXPECT_EQ(seen[1].then, (DialState::Then{1024, 0.125}));
    EXPECT_TRUE(m_sent.empty());
}

TEST_F(EncoderFunctionsTest, AResetTellsWhatIsLostAndReadsBack)
{
    isInPositionMode();
    ASSERT_TRUE(encoder().start(WriteParameters{.values = {{Parameter::steps, 255}}, .previous = {}}));
    finishJobs();
    {
        const Question question = Question::answeredBy(QStringLiteral("Reset"));
        click("resetToDefault");
        for (const char *part : {"Steps, Revolutions, Direction, Preset, Zero offset", "All cam programs",
                                 "EEPROM writes by this program so far: 1, counted since",
                                 "EEPROM writes by this: at most 1.", "about 200"})
            EXPECT_TRUE(question.text().contains(QLatin1String(part)))
                << part << question.text().toStdString();
    }
    finishJobs();
    EXPECT_EQ(encoder().known(Parameter::steps)->value, 8192);
    EXPECT_EQ(encoder().known(Parameter::steps)->evidence, Evidence::read);
    EXPECT_EQ(encoder().eepromWrites(), 2);
    EXPECT_TRUE(
        message().startsWith(QStringLiteral("The encoder was reset to factory settings (EEPROM writes: 1).")))
        << message().toStdString();
}

TEST_F(EncoderFunctionsTest, ABaumerCanOnlyBeReset)
{
    show(baumer);
    EXPECT_FALSE(action("velocityMode").isVisible());
    EXPECT_FALSE(action("positionMode").isVisible());
    EXPECT_FALSE(action("frabaPreset").isVisible());
    {
        const Question question = Question::answeredBy(QStringLiteral("Reset"));
        click("resetToDefault");
        EXPECT_TRUE(question.text().contains(QStringLiteral("It cannot be read")));
    }
    finishJobs();
    EXPECT_EQ(encoder().known(Parameter::coding)->value, 3);
}

TEST_F(EncoderFunctionsTest, InWatchTheRefusalStandsInThePanel)
{
    isInPositionMode();
    m_ring.bus.setOperate(false);
    m_ring.bus.advance(33);
    QSignalSpy shown(&m_panel, &ParameterPanel::refusalShown);
    click("velocityMode");
    EXPECT_EQ(shown.count(), 1);
    EXPECT_TRUE(message().contains(QStringLiteral("Switch to Operate first"))) << message().toStdString();
    m_ring.bus.setOperate(true);
    m_ring.bus.advance(33);
    EXPECT_TRUE(message().isEmpty());
}

// The mode is not known, so that it would be asked for.
TEST_F(EncoderFunctionsTest, WatchingAsksNothingBeforeItRefuses)
{
    m_ring.bus.setOperate(false);
    m_ring.bus.advance(33);
    QSignalSpy shown(&m_panel, &ParameterPanel::refusalShown);
    const char *const functions[] = {"velocityMode", "positionMode", "frabaPreset", "resetToDefault"};
    bool isAsked = false;
    QTimer answer;
    QObject::connect(&answer, &QTimer::timeout, &m_panel, [&] {
        if (QWidget *question = QApplication::activeModalWidget()) {
            isAsked = true;
            question->close();
        }
    });
    answer.start(10);
    for (const char *function : functions) {
        click(function);
        EXPECT_TRUE(message().contains(QStringLiteral("Switch to Operate first"))) << function;
    }
    EXPECT_FALSE(isAsked);
    EXPECT_EQ(shown.count(), 4);
    EXPECT_TRUE(m_sent.empty());
}

TEST_F(EncoderFunctionsTest, DuringAJobNothingElseCanBeAskedFor)
{
    isInPositionMode();
    ASSERT_TRUE(encoder().start(ReadParameters{{Parameter::steps}}));
    EXPECT_FALSE(action("resetToDefault").isEnabled());
    finishJobs();
    EXPECT_TRUE(action("resetToDefault").isEnabled());
}

} // namespace
} // namespace codewheel
