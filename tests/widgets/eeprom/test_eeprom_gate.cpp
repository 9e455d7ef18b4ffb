// SPDX-License-Identifier: GPL-3.0-or-later
// A FRABA of the training bus whose ledger says that it was written too often: every place that starts a job.
#include "tests/app/question.h"
#include "tests/widgets/training_bus_session.h"
#include "widgets/eeprom/eeprom_gate.h"
#include "widgets/eeprom/eeprom_question.h"
#include "widgets/job/cancel_question.h"
#include "widgets/job/job_strip.h"
#include "widgets/look/appearance.h"
#include "widgets/look/label_text.h"
#include "widgets/monitor/word_card.h"
#include "widgets/monitor/word_field.h"
#include "widgets/parameters/write_review.h"

#include <QApplication>
#include <QCheckBox>
#include <QDate>
#include <QDateTime>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTime>
#include <QTimer>
#include <QWidget>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;

class EepromGateTest : public testing::Test
{
protected:
    void count(int writes, Place place = fraba)
    {
        ring.encoder(place).setEepromCount(
            {.writes = writes, .since = QDateTime(QDate(2026, 3, 1), QTime(12, 0)), .by = CountedBy::place});
    }
    template <typename Widget>
    static Widget &find(QWidget &parent, const char *name)
    {
        auto *found = parent.findChild<Widget *>(QString::fromLatin1(name));
        if (found == nullptr)
            std::abort();
        return *found;
    }

    test::TrainingBusSession ring;
};

TEST_F(EepromGateTest, SaysByWhatItIsCountedAndAsksNothing)
{
    EepromGate gate;
    count(12);
    gate.setWrites(ring.encoder(fraba), 4);
    EXPECT_TRUE(gate.isOpen());
    EXPECT_EQ(
        find<QLabel>(gate, "eepromCount").text(),
        QStringLiteral("EEPROM writes by this program since 1 Mar 2026: 12, counted by its place, since the "
                       "serial number is not known."));
    EXPECT_FALSE(find<QLabel>(gate, "eepromConcern").isVisibleTo(&gate));
    EXPECT_FALSE(find<QCheckBox>(gate, "writeNevertheless").isVisibleTo(&gate));
}

TEST_F(EepromGateTest, WarnsAndAsksFromThreeQuartersOn)
{
    EepromGate gate;
    count(145);
    gate.setWrites(ring.encoder(fraba), 4);
    EXPECT_TRUE(gate.isOpen());
    count(146);
    EXPECT_FALSE(gate.isOpen());
    EXPECT_TRUE(find<QLabel>(gate, "eepromConcern").isVisibleTo(&gate));
    EXPECT_FALSE(find<QLabel>(gate, "eepromConcern").text().contains(QStringLiteral("used up")));
    find<QCheckBox>(gate, "writeNevertheless").click();
    EXPECT_TRUE(gate.isOpen());
}

TEST_F(EepromGateTest, HasToBeTickedBeyondTheBudget)
{
    EepromGate gate;
    count(200);
    gate.setWrites(ring.encoder(fraba), 1);
    EXPECT_FALSE(gate.isOpen());
    find<QCheckBox>(gate, "writeNevertheless").click();
    EXPECT_TRUE(gate.isOpen());
    gate.setWrites(ring.encoder(fraba), 2);
    EXPECT_TRUE(gate.isOpen()); // the same concern
    count(500);
    EXPECT_FALSE(gate.isOpen()); // a different one
}

TEST_F(EepromGateTest, WhatWasAgreedToIsNotHeldForAnotherEncoderAtTheSamePlace)
{
    EepromGate gate;
    count(200);
    gate.setWrites(ring.encoder(fraba), 1);
    find<QCheckBox>(gate, "writeNevertheless").click();
    ASSERT_TRUE(gate.isOpen());
    test::TrainingBusSession other;
    other.encoder(fraba).setEepromCount({.writes = 200, .by = CountedBy::place});
    gate.setWrites(other.encoder(fraba), 1);
    EXPECT_FALSE(gate.isOpen());
}

TEST_F(EepromGateTest, WantsThePlaceBeyondTheLimit)
{
    EepromGate gate;
    QSignalSpy changes(&gate, &EepromGate::changed);
    count(500);
    gate.setWrites(ring.encoder(fraba), 1);
    auto &place = find<QLineEdit>(gate, "typedPlace");
    QTest::keyClicks(&place, QStringLiteral("1."));
    EXPECT_FALSE(gate.isOpen());
    QTest::keyClicks(&place, QStringLiteral("0"));
    EXPECT_TRUE(gate.isOpen());
    EXPECT_EQ(changes.size(), 3);
}

TEST_F(EepromGateTest, TakesAPlaceOnABusWithBlanksInItsNameAmongOthers)
{
    setBusNames({{fraba.bus, QStringLiteral("Crane, south")}});
    EepromGate gate;
    count(500);
    gate.setWrites({{&ring.encoder(fraba), 1}, {&ring.encoder(baumer), 1}});
    auto &places = find<QLineEdit>(gate, "typedPlace");
    places.setText(QStringLiteral("1.0"));
    EXPECT_FALSE(gate.isOpen());
    places.setText(QStringLiteral("Crane, south/3.0; Crane, south/1.0"));
    EXPECT_TRUE(gate.isOpen());
    EXPECT_TRUE(find<QLabel>(gate, "eepromConcern").text().startsWith(QStringLiteral("Crane, south/1.0: ")));
    EXPECT_FALSE(find<QLabel>(gate, "eepromCount").isVisibleTo(&gate));
    setBusNames({});
}

TEST_F(EepromGateTest, AsksNothingWhereTheManualIsSilent)
{
    EepromGate gate;
    count(10'000, baumer);
    gate.setWrites(ring.encoder(baumer), 4);
    EXPECT_TRUE(gate.isOpen());
    EXPECT_TRUE(find<QLabel>(gate, "eepromCount").isVisibleTo(&gate));
}

TEST_F(EepromGateTest, HoldsBackTheReviewOfParameters)
{
    WriteReview review;
    count(200);
    review.review(ring.encoder(fraba), {{Parameter::steps, 255}});
    auto &write = find<QPushButton>(review, "confirmWrite");
    EXPECT_FALSE(write.isEnabled());
    find<QCheckBox>(review, "writeNevertheless").click();
    EXPECT_TRUE(write.isEnabled());
}

TEST_F(EepromGateTest, AQuestionIsAskedOnlyWhereThereIsOne)
{
    QWidget window;
    count(100);
    EXPECT_TRUE(askForEeprom(&window, ring.encoder(fraba), SetPreset{}));
    count(500);
    EXPECT_TRUE(askForEeprom(&window, ring.encoder(fraba), ReadParameters{{Parameter::steps}}));
    bool wasAsked = false;
    QTimer::singleShot(0, &window, [&] {
        auto *dialog = qobject_cast<QDialog *>(QApplication::activeModalWidget());
        ASSERT_NE(dialog, nullptr);
        wasAsked = true;
        EXPECT_FALSE(find<QPushButton>(*dialog, "writeToEeprom").isEnabled());
        QTest::keyClicks(&find<QLineEdit>(*dialog, "typedPlace"), QStringLiteral("1.0"));
        find<QPushButton>(*dialog, "writeToEeprom").click();
    });
    EXPECT_TRUE(askForEeprom(&window, ring.encoder(fraba), SetPreset{}));
    EXPECT_TRUE(wasAsked);
    QTimer::singleShot(0, &window, [] { QApplication::activeModalWidget()->close(); });
    EXPECT_FALSE(askForEeprom(&window, ring.encoder(fraba), SetPreset{}));
}

TEST_F(EepromGateTest, HoldsBackAWordByHandThatIsStored)
{
    EncoderSession &encoder = ring.encoder(fraba);
    WordCard monitor(ring.channel(fraba), &encoder, &encoder.device());
    count(500);
    const auto send = [&](Word word) {
        ring.channel(fraba).stage(word);
        for (auto *button : monitor.findChildren<QPushButton *>())
            if (button->accessibleName() == QStringLiteral("Write OUT 1.0"))
                button->click();
        ring.bus.advance(1);
        return ring.channel(fraba).out() == word;
    };
    EXPECT_TRUE(send(0x20210001)); // reads
    EXPECT_TRUE(send(0));
    {
        const auto cancels = test::Question::answeredBy(QStringLiteral("Cancel"));
        EXPECT_FALSE(send(0x020000FF));
    }
    const test::Question types([](QWidget &dialog) {
        find<QLineEdit>(dialog, "typedPlace").setText(QStringLiteral("1.0"));
        find<QPushButton>(dialog, "writeToEeprom").click();
    });
    EXPECT_TRUE(send(0x020000FF));
}

// A job that has taken a value, in the wizard, a transfer or on quitting: restoring is one more write.
TEST_F(EepromGateTest, HoldsBackWritingTheValuesFromBeforeAgain)
{
    QWidget window;
    count(500);
    const auto cancel = [&] {
        return askHowToCancel(&window, ring.encoder(fraba),
                              {.taken = {{Parameter::steps, 255}},
                               .canRestore = true,
                               .writesToRestore = 1,
                               .positionNote = {}});
    };
    const auto restoreThen = [&](const char *button) {
        QTimer::singleShot(0, &window, [button] {
            const QPointer<QWidget> first(QApplication::activeModalWidget());
            QTimer::singleShot(0, first, [button] {
                auto &second = *QApplication::activeModalWidget();
                find<QLineEdit>(second, "typedPlace").setText(QStringLiteral("1.0"));
                for (auto *each : second.findChildren<QPushButton *>())
                    if (plainLabel(each->text()) == QLatin1String(button))
                        each->click();
            });
            for (auto *each : first->findChildren<QPushButton *>())
                if (each->text().contains(QStringLiteral("Restore")))
                    each->click();
        });
        return cancel();
    };
    EXPECT_EQ(restoreThen("Cancel"), std::nullopt);
    EXPECT_EQ(restoreThen("Write"), OnCancel::restorePrevious);
    const auto runs = test::Question::answeredBy(QStringLiteral("Run"));
    EXPECT_EQ(cancel(), OnCancel::runWithWhatItHas);
}

// A row is higher where it has less width, and a scroll bar takes width: in no size this goes on for ever.
TEST_F(EepromGateTest, AReviewHasItsSizeWhateverRoomThereIs)
{
    WriteReview review;
    review.review(ring.encoder(fraba), {{Parameter::steps, 4'096},
                                        {Parameter::revolutions, 16},
                                        {Parameter::direction, 4},
                                        {Parameter::preset, 1'000},
                                        {Parameter::zeroOffset, 12'345}});
    review.show();
    for (const bool large : {false, true}) {
        applyAppearance(*qApp, {.scheme = Scheme::light, .largeControls = large});
        for (int width = 180; width <= 420; width += 7)
            for (int height = 120; height <= 480; height += 30) {
                review.resize(width, height);
                QApplication::processEvents();
            }
    }
    applyAppearance(*qApp, {.scheme = Scheme::light});
    EXPECT_TRUE(find<QPushButton>(review, "confirmWrite").isVisible());
}

TEST_F(EepromGateTest, TheQuestionSaysWhetherAndAtWhatCostTheEarlierValuesComeBack)
{
    CancelQuestion question;
    const auto textOf = [&](const CancelSituation &situation) {
        question.ask(ring.encoder(fraba), situation);
        return question.findChild<QLabel *>()->text();
    };
    CancelSituation situation{
        .taken = {{Parameter::steps, 255}}, .canRestore = true, .writesToRestore = 1, .positionNote = {}};
    EXPECT_TRUE(textOf(situation).contains(QStringLiteral("1 at most")));
    EXPECT_FALSE(textOf(situation).contains(QStringLiteral("not all known")));
    situation.canRestore = false;
    EXPECT_TRUE(textOf(situation).contains(QStringLiteral("not all known")));
    situation.setsPosition = true;
    EXPECT_TRUE(textOf(situation).contains(QStringLiteral("position was set")));
    EXPECT_FALSE(textOf(situation).contains(QStringLiteral("not all known")));
}

TEST_F(EepromGateTest, HoldsBackRestoringInTheJobStrip)
{
    JobStrip strip;
    EncoderSession &encoder = ring.encoder(fraba);
    encoder.tell(Parameter::startUpMode, 1);
    encoder.tell(Parameter::steps, 8192);
    strip.setEncoder(&encoder);
    strip.begin();
    strip.show();
    ASSERT_TRUE(encoder.start(
        WriteParameters{.values = {{Parameter::steps, 255}}, .previous = {{Parameter::steps, 8192}}},
        Pace::byHand));
    Progress progress;
    QObject::connect(&encoder, &EncoderSession::progressed, &strip,
                     [&](const Progress &now) { progress = now; });
    for (int i = 0; i < 10 && progress.confirmed.empty(); ++i) {
        ring.bus.advance(100);
        encoder.proceed();
    }
    ASSERT_TRUE(progress.canRestore);
    count(500);
    find<QPushButton>(strip, "cancelJob").click();
    const auto restore = [&] {
        for (auto *each : strip.findChildren<QPushButton *>())
            if (each->text().contains(QStringLiteral("Restore")))
                each->click();
        ring.bus.advance(500);
    };
    {
        const auto cancels = test::Question::answeredBy(QStringLiteral("Cancel"));
        restore();
    }
    EXPECT_TRUE(encoder.runningJob());
    const test::Question types([](QWidget &dialog) {
        find<QLineEdit>(dialog, "typedPlace").setText(QStringLiteral("1.0"));
        find<QPushButton>(dialog, "writeToEeprom").click();
    });
    restore();
    EXPECT_FALSE(encoder.runningJob());
}

} // namespace
} // namespace codewheel
