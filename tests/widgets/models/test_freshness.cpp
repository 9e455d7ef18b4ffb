// SPDX-License-Identifier: GPL-3.0-or-later
// Live values look live and old ones look old, in every view.
#include "tests/widgets/cams/cam_editor_test.h"
#include "tests/widgets/rod_bus.h"
#include "tests/widgets/training_bus_session.h"
#include "vocabulary/known_words.h"
#include "widgets/dial/code_disc.h"
#include "widgets/dial/dial_panel.h"
#include "widgets/dial/rod_view.h"
#include "widgets/models/age_timer.h"
#include "widgets/monitor/bar_view.h"
#include "widgets/monitor/number_field.h"
#include "widgets/monitor/word_card.h"
#include "widgets/monitor/word_view.h"
#include "widgets/parameters/parameter_model.h"
#include "widgets/parameters/wanted_values.h"
#include "widgets/project/project_document.h"
#include "widgets/structure/structure_model.h"

#include <QLabel>
#include <QLocale>
#include <QTest>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::fraba;

// The shaft of 1.0 turns at 60 rpm, and everything is known.
class FreshnessTest : public testing::Test
{
protected:
    FreshnessTest()
    {
        EncoderSession &encoder = ring.encoder(fraba);
        encoder.tell(Parameter::startUpMode, 1);
        encoder.tell(Parameter::steps, 8192);
        encoder.tell(Parameter::revolutions, 1);
        encoder.tell(Parameter::direction, 3);
        ring.controls->setSpeed(fraba.node, 60);
        advance(500);
    }
    void advance(int milliseconds)
    {
        for (; milliseconds > 0; milliseconds -= 20)
            ring.bus.advance(20);
    }
    // As displayed: more than a day ago, with date and time.
    QString lastSeen() const
    {
        const QDateTime seen = ring.bus.dateTime(ring.encoder(fraba).freshness().seen());
        return QLocale().toString(seen.toLocalTime(), QLocale::ShortFormat);
    }

    test::TrainingBusSession ring;
};

TEST_F(FreshnessTest, TheDialShowsWhereTheShaftWasAndNoSpeed)
{
    DialPanel panel;
    panel.show();
    panel.setEncoder(&ring.encoder(fraba));
    advance(500);
    const DialState &shown = panel.findChild<CodeDisc *>()->state();
    ASSERT_TRUE(shown.rpm);
    EXPECT_FALSE(shown.isLastKnown);
    EXPECT_TRUE(shown.age.isEmpty());

    ring.bus.alarmStop();
    advance(20'000);
    const auto last = ring.encoder(fraba).latest().position;
    ASSERT_TRUE(last);
    EXPECT_EQ(shown.position, last);
    EXPECT_TRUE(shown.isLastKnown);
    EXPECT_FALSE(shown.rpm);
    EXPECT_EQ(shown.role, Role::inactive);
    EXPECT_EQ(shown.age, lastSeen());
    EXPECT_EQ(shown.note, QStringLiteral("Not up to date: The bus does not run."));
    EXPECT_TRUE(panel.findChild<CodeDisc *>()->valueText().startsWith(QStringLiteral("Last position")));

    ring.bus.setRunning(true);
    advance(500);
    EXPECT_FALSE(shown.isLastKnown);
    EXPECT_TRUE(shown.rpm);
    EXPECT_TRUE(shown.age.isEmpty());
}

// This needs nothing from the bus.
TEST_F(FreshnessTest, TheAgeGoesOnByItself)
{
    RingSession bus(makeTrainingBus(ring.catalog).link, ring.catalog,
                    QDateTime::currentDateTime().addSecs(-30));
    ASSERT_TRUE(bus.open(RingSession::Start::watching));
    bus.advance(10);
    DialPanel panel;
    panel.show();
    panel.setEncoder(bus.encoder(fraba));
    bus.close();
    const DialState &shown = panel.findChild<CodeDisc *>()->state();
    const QString age = shown.age;
    EXPECT_TRUE(age.endsWith(QStringLiteral(" s ago"))) << age.toStdString();
    EXPECT_TRUE(QTest::qWaitFor([&] { return shown.age != age; }));
    EXPECT_EQ(shown.note, QStringLiteral("Not up to date: Not connected."));
}

// Two views that began to show it at different times change together.
TEST(AgeTimer, TicksWhenTheAgeHasBecomeAnotherSecond)
{
    const QDateTime seen(QDate(2026, 3, 1), QTime(14, 2, 7, 300));
    EXPECT_EQ(AgeTimer::untilNextSecond(seen, seen), std::chrono::milliseconds(1000));
    EXPECT_EQ(AgeTimer::untilNextSecond(seen, seen.addMSecs(20'400)), std::chrono::milliseconds(600));
    EXPECT_EQ(AgeTimer::untilNextSecond(seen, seen.addMSecs(20'999)), std::chrono::milliseconds(1));
    EXPECT_EQ(AgeTimer::untilNextSecond(seen, seen.addMSecs(-5)), std::chrono::milliseconds(1000));
}

TEST_F(FreshnessTest, ARodToo)
{
    test::TrainingBusSession rod(RingSession::Start::operating, test::makeRodBus);
    DialPanel panel;
    panel.show();
    panel.setEncoder(&rod.encoder(test::rodPlace));
    rod.bus.advance(100);
    const RodState &shown = panel.findChild<RodView *>()->state();
    EXPECT_FALSE(shown.isLastKnown);
    rod.bus.setRunning(false);
    rod.bus.advance(100);
    EXPECT_TRUE(shown.isLastKnown);
    EXPECT_FALSE(shown.age.isEmpty());
    EXPECT_FALSE(shown.stepsPerSecond);
}

TEST_F(FreshnessTest, TheTreeShowsOldPositionsGreyAndSaysSo)
{
    StructureModel model;
    model.addBus(ring.bus);
    advance(40);
    const auto cell = [&](Place number) {
        return model.indexOf(number).siblingAtColumn(StructureModel::positionColumn);
    };
    EXPECT_FALSE(cell(fraba).data(Qt::ForegroundRole).isValid());
    ring.bus.alarmStop();
    advance(40);
    EXPECT_EQ(cell(fraba).data(Qt::ForegroundRole).value<QBrush>(),
              QGuiApplication::palette().brush(QPalette::PlaceholderText));
    EXPECT_TRUE(
        cell(fraba).data(Qt::AccessibleTextRole).toString().endsWith(QStringLiteral("not up to date")));
    EXPECT_TRUE(
        cell(fraba)
            .data(Qt::ToolTipRole)
            .toString()
            .contains(QStringLiteral("The bus does not run. Shown is how it was %1.").arg(lastSeen())));
    ring.bus.setRunning(true);
    advance(40);
    EXPECT_FALSE(cell(fraba).data(Qt::ForegroundRole).isValid());
}

TEST_F(FreshnessTest, WhereNoPositionIsKnownTheTreeShowsADashAndTellsWhy)
{
    StructureModel model;
    model.addBus(ring.bus);
    advance(40);
    const QModelIndex baumer = model.indexOf(test::baumer).siblingAtColumn(StructureModel::positionColumn);
    const QString dash(QChar(0x2013));
    const QString why =
        QStringLiteral("The coding is not known: write it, or set it manually under Parameters.");
    EXPECT_EQ(baumer.data().toString(), dash);
    EXPECT_TRUE(baumer.data(Qt::ToolTipRole).toString().contains(why));
    const QModelIndex terminal =
        model.indexOf(test::busTerminal).siblingAtColumn(StructureModel::positionColumn);
    EXPECT_EQ(terminal.data().toString(), QString()) << "it has none";
    ring.encoder(test::baumer).tell(Parameter::coding, 3);
    advance(40);
    EXPECT_NE(baumer.data().toString(), dash);
    EXPECT_FALSE(baumer.data(Qt::ToolTipRole).toString().contains(why));
}

TEST_F(FreshnessTest, HowAValueIsKnownSaysWhatWouldMakeItSurer)
{
    const auto words = [](Evidence evidence, bool reads) {
        return known_words::explanation(Known{Parameter::steps, 255, evidence, {}}, reads);
    };
    EXPECT_TRUE(words(Evidence::echoed, true).endsWith(QStringLiteral("but not read back since: read it.")));
    EXPECT_TRUE(words(Evidence::echoed, false).endsWith(QStringLiteral("cannot be read.")));
    EXPECT_TRUE(words(Evidence::told, true).endsWith(QStringLiteral("read it.")));
    EXPECT_TRUE(known_words::explanation({}, true).endsWith(QStringLiteral("read it from the encoder.")));
    EXPECT_TRUE(
        known_words::explanation({}, false).endsWith(QStringLiteral("set it manually, or write it.")));
}

TEST_F(FreshnessTest, AMonitorShowsOldBitsAndNumbersGrey)
{
    WordCard card(ring.channel(fraba), &ring.encoder(fraba), &ring.encoder(fraba).device());
    card.setDisplay({.bar = true});
    const WordLine &in = *card.line(WordDirection::in);
    const WordLine &out = *card.line(WordDirection::out);
    const auto show = [&] { card.showFrame(ring.bus.now()); };
    const auto ink = [](const WordLine &line) {
        return line.findChild<NumberField *>()->palette().color(QPalette::Active, QPalette::Text);
    };
    const auto &bits = *card.findChild<WordView *>();
    const int outBits = 0;
    const int inBits = 1;
    show();
    const QColor live = ink(in);
    EXPECT_FALSE(bits.isOld(inBits));
    ring.bus.setRunning(false);
    advance(40);
    show();
    EXPECT_TRUE(bits.isOld(inBits));
    EXPECT_FALSE(bits.isOld(outBits)) << "it goes out when the bus runs again";
    EXPECT_EQ(ink(in), card.palette().color(QPalette::Active, QPalette::PlaceholderText));
    EXPECT_EQ(ink(out), live);
    EXPECT_TRUE(in.meaning().startsWith(QStringLiteral("Bus stopped, %1: ").arg(lastSeen())))
        << in.meaning().toStdString();
    EXPECT_TRUE(card.findChild<BarView *>()->valueText().endsWith(QStringLiteral("not up to date")));

    ring.bus.setRunning(true);
    advance(40);
    show();
    EXPECT_FALSE(bits.isOld(inBits));
    EXPECT_EQ(ink(in), live);
    ring.bus.close();
    show();
    EXPECT_TRUE(bits.isOld(outBits)) << "nobody knows what stands there now";
}

TEST_F(FreshnessTest, KnownParametersAreOfBefore)
{
    ProjectDocument project;
    WantedValues wanted(project);
    ParameterModel model(wanted);
    model.setEncoder(&ring.encoder(fraba));
    const auto steps = [&](int role) {
        for (int row = 0; row < model.rowCount(); ++row)
            if (model.rowAt(row).parameter.parameter == Parameter::steps)
                return model.index(row, ParameterModel::knownColumn).data(role);
        return QVariant();
    };
    EXPECT_EQ(steps(ParameterModel::isPaleRole), false);
    ring.bus.setRunning(false);
    advance(40);
    EXPECT_EQ(steps(ParameterModel::isPaleRole), true);
    EXPECT_TRUE(steps(Qt::ToolTipRole).toString().contains(QStringLiteral("The bus does not run.")));
    ring.bus.setRunning(true);
    advance(40);
    EXPECT_EQ(steps(ParameterModel::isPaleRole), false);
}

class OldCams : public test::CamEditorTest
{
protected:
    bool sees(const char *beginning)
    {
        const auto labels = editor.findChildren<QLabel *>();
        return std::ranges::any_of(labels, [&](const QLabel *label) {
            return label->isVisible() && label->text().startsWith(QLatin1String(beginning));
        });
    }
};

TEST_F(OldCams, WhichCamsAreOnIsNotKnownAnyMore)
{
    tellAll();
    setManualCam();
    advance(40);
    ASSERT_TRUE(sheet().isOn(test::manualCam));
    ring.bus.alarmStop();
    advance(40);
    EXPECT_TRUE(sheet().live().isOld);
    EXPECT_TRUE(sheet().live().position) << "where it was";
    EXPECT_FALSE(sheet().isOn(test::manualCam));
    EXPECT_TRUE(sees("Not up to date: The bus does not run. Shown is how it was "));
    ring.bus.setRunning(true);
    advance(40);
    EXPECT_TRUE(sheet().isOn(test::manualCam));
}

} // namespace
} // namespace codewheel
