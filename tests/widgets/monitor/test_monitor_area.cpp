// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/places.h"
#include "tests/widgets/training_bus_session.h"
#include "widgets/look/empty_state.h"
#include "widgets/monitor/monitor_area.h"
#include "widgets/monitor/number_field.h"
#include "widgets/monitor/word_card.h"
#include "widgets/structure/structure_model.h"

#include <QCoreApplication>
#include <QDragEnterEvent>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QMimeData>
#include <QTest>
#include <QToolButton>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;

class MonitorAreaTest : public testing::Test
{
protected:
    MonitorAreaTest()
    {
        area.resize(560, 480);
        area.show();
    }
    QStringList open() const
    {
        QStringList names;
        for (const WordCard *card : area.cards())
            names << card->place().toString() + (card->isPinned() ? QStringLiteral(" pinned") : QString());
        return names;
    }
    void press(const char *name)
    {
        QCoreApplication::processEvents();
        for (auto *button : area.findChildren<QToolButton *>())
            if (button->accessibleName() == QLatin1String(name) && button->isVisible()) {
                QTest::mouseClick(button, Qt::LeftButton);
                return;
            }
        ADD_FAILURE() << "no " << name;
    }
    QString note() const
    {
        const auto *label = area.findChild<QLabel *>(QStringLiteral("whyNoMonitor"));
        return label->isHidden() ? QString() : label->text();
    }

    test::TrainingBusSession ring;
    MonitorArea area{ring.buses};
};

TEST_F(MonitorAreaTest, EmptyItSaysHowToOpenAMonitor)
{
    const auto *empty = area.findChild<EmptyState *>();
    EXPECT_TRUE(empty->isVisible());
    area.follow(fraba);
    EXPECT_FALSE(empty->isVisible());
    area.close(fraba);
    EXPECT_TRUE(empty->isVisible());
}

TEST_F(MonitorAreaTest, OneMonitorFollowsTheChoice)
{
    area.follow(fraba);
    EXPECT_EQ(open(), QStringList{QStringLiteral("1.0")});
    area.follow(baumer);
    EXPECT_EQ(open(), QStringList{QStringLiteral("2.0")});
    area.follow({});
    EXPECT_TRUE(open().isEmpty());
}

TEST_F(MonitorAreaTest, APinnedMonitorStaysAndTheNextChoiceIsANewOneAboveIt)
{
    area.follow(fraba);
    press("Pin monitor 1.0");
    EXPECT_EQ(open(), QStringList{QStringLiteral("1.0 pinned")});
    WordCard *pinned = area.card(fraba);
    area.follow(baumer);
    EXPECT_EQ(open(), (QStringList{QStringLiteral("2.0"), QStringLiteral("1.0 pinned")}));
    EXPECT_EQ(area.card(fraba), pinned);
    area.follow(fraba);
    EXPECT_EQ(open(), QStringList{QStringLiteral("1.0 pinned")}) << "it is there";
    press("Pin monitor 1.0");
    EXPECT_EQ(open(), QStringList{QStringLiteral("1.0")}) << "it follows again";
    area.pin(baumer);
    press("Pin monitor 2.0");
    EXPECT_EQ(open(), QStringList{QStringLiteral("1.0")}) << "another device is chosen";
}

TEST_F(MonitorAreaTest, WhatIsStagedStaysWithItsDevice)
{
    area.follow(fraba);
    ring.channel(fraba).stage(0x0200'00FF);
    area.follow(baumer);
    EXPECT_EQ(area.card(baumer)->line(WordDirection::out)->shown(), 0U);
    area.follow(fraba);
    EXPECT_EQ(area.card(fraba)->line(WordDirection::out)->shown(), 0x0200'00FFU);
    EXPECT_EQ(ring.channel(fraba).out(), 0U);
}

TEST_F(MonitorAreaTest, AClosedMonitorComesBackWithTheNextChoiceAndWhenItIsAskedFor)
{
    area.follow(fraba);
    press("Close monitor 1.0");
    EXPECT_TRUE(open().isEmpty());
    area.follow(fraba);
    EXPECT_TRUE(open().isEmpty()) << "nobody has chosen anything";
    area.open(fraba);
    EXPECT_EQ(open(), QStringList{QStringLiteral("1.0")});
    press("Close monitor 1.0");
    area.follow(baumer);
    EXPECT_EQ(open(), QStringList{QStringLiteral("2.0")});
}

TEST_F(MonitorAreaTest, OpenedTheMonitorOfAnotherDeviceIsPinned)
{
    area.follow(fraba);
    area.open(baumer);
    EXPECT_EQ(open(), (QStringList{QStringLiteral("1.0"), QStringLiteral("2.0 pinned")}));
    area.open(baumer);
    EXPECT_EQ(open().size(), 2);
}

TEST_F(MonitorAreaTest, ADeviceHasTheWordsThatItHas)
{
    area.follow(test::singleTurn);
    const WordCard *card = area.card(test::singleTurn);
    EXPECT_EQ(card->line(WordDirection::out), nullptr);
    EXPECT_EQ(card->line(WordDirection::in)->hexText(), QStringLiteral("03E9"));
    area.follow(test::multiTurn);
    EXPECT_EQ(area.card(test::multiTurn)->line(WordDirection::in)->hexText().size(), 8);
    EXPECT_EQ(area.card(test::multiTurn)->line(WordDirection::out), nullptr);
    area.follow(test::onLoop);
    EXPECT_NE(area.card(test::onLoop)->line(WordDirection::out), nullptr);
}

TEST_F(MonitorAreaTest, WhereThereAreNoWordsItSaysWhy)
{
    area.follow(test::singleTurn);
    const auto *noOut = area.card(test::singleTurn)->findChild<QLabel *>(QStringLiteral("noOut"));
    ASSERT_NE(noOut, nullptr);
    EXPECT_EQ(noOut->text(), QStringLiteral("3.0 has no OUT word: nothing can be sent to it."));
    area.pin(fraba);
    EXPECT_EQ(area.card(fraba)->findChild<QLabel *>(QStringLiteral("noOut")), nullptr);
    EXPECT_TRUE(note().isEmpty());
    area.follow(test::busTerminal);
    EXPECT_EQ(note(), QStringLiteral("6.0 has no words to show: it takes no part in the process data."));
    area.follow("7.0"_ring);
    EXPECT_EQ(note(), QStringLiteral("7.0 is not connected: its words are shown once it is."));
    area.follow(baumer);
    EXPECT_TRUE(note().isEmpty());
}

TEST_F(MonitorAreaTest, WhatAPositionOnlyEncoderShowsIsExplained)
{
    area.follow(test::singleTurn);
    ring.controls->setSpeed(test::singleTurn.node, 0);
    ring.controls->turnTo(test::singleTurn.node, 4095);
    ring.bus.advance(5);
    const WordLine *in = area.card(test::singleTurn)->line(WordDirection::in);
    EXPECT_EQ(in->hexText(), QStringLiteral("0FFF"));
    EXPECT_EQ(in->meaning(), QStringLiteral("Running, position 4095"));
}

TEST_F(MonitorAreaTest, MonitorsMoveWithTheBus)
{
    area.follow(fraba);
    ring.controls->turnTo(fraba.node, 0x77);
    ring.bus.advance(5);
    EXPECT_EQ(area.card(fraba)->line(WordDirection::in)->hexText(), QStringLiteral("00000077"));
}

TEST_F(MonitorAreaTest, WhatIsPinnedAndShownIsKept)
{
    area.follow(fraba);
    area.pin(baumer);
    area.pin(test::onLoop);
    Q_EMIT area.card(fraba)->displayChosen({.gray = true});
    const QJsonObject state = area.state();

    MonitorArea another(ring.buses);
    another.restoreState(state);
    EXPECT_EQ(another.state(), state);
    ASSERT_EQ(another.cards().size(), 2U);
    EXPECT_EQ(another.cards()[0]->place(), baumer);
    another.follow(fraba);
    const auto fields = another.card(fraba)->findChildren<NumberField *>();
    EXPECT_GE(fields.size(), 3);
    for (const auto *field : fields)
        EXPECT_EQ(field->isHidden(), !field->accessibleName().endsWith(QLatin1String("Gray")) &&
                                         !field->accessibleName().endsWith(QLatin1String("decimal")))
            << field->accessibleName().toStdString();
}

// An older state: one monitor per word, some of devices that are gone, and an invalid one.
TEST_F(MonitorAreaTest, AStateOfBeforeIsRead)
{
    const auto json = QJsonDocument::fromJson(
        R"({"monitors": [{"place": "9.0", "kind": "IN 32"}, {"place": "2.0", "kind": "IN 32"}, 5,
            {"place": "2.0", "kind": "OUT 32"}], "display": {"IN 32": {"gray": true}}})");
    area.restoreState(json.object());
    EXPECT_EQ(open(), QStringList{QStringLiteral("2.0 pinned")});
}

TEST_F(MonitorAreaTest, MonitorsGoAndComeBackWithTheirBus)
{
    area.follow(fraba);
    area.pin(baumer);
    ring.bus.close();
    EXPECT_TRUE(open().isEmpty());
    const QJsonObject kept = area.state();
    EXPECT_TRUE(ring.bus.open(RingSession::Start::watching));
    ring.bus.advance(5);
    EXPECT_EQ(open(), (QStringList{QStringLiteral("1.0"), QStringLiteral("2.0 pinned")}));
    EXPECT_EQ(area.state(), kept);
}

TEST_F(MonitorAreaTest, ADeviceThatIsDroppedOnItIsPinned)
{
    StructureModel structure;
    structure.addBus(ring.bus);
    const auto drop = [&](Place place) {
        const std::unique_ptr<QMimeData> data(structure.mimeData({structure.indexOf(place)}));
        QDragEnterEvent enter({10, 10}, Qt::CopyAction, data.get(), Qt::LeftButton, {});
        enter.ignore();
        QCoreApplication::sendEvent(&area, &enter);
        if (enter.isAccepted()) {
            QDropEvent dropped({10, 10}, Qt::CopyAction, data.get(), Qt::LeftButton, {});
            QCoreApplication::sendEvent(&area, &dropped);
        }
        return enter.isAccepted();
    };
    EXPECT_TRUE(drop(baumer));
    EXPECT_TRUE(open().contains(QStringLiteral("2.0 pinned")));
    EXPECT_FALSE(drop(test::busTerminal)) << "it has no words";
    EXPECT_FALSE(structure.flags(structure.indexOf(firstBus)).testFlag(Qt::ItemIsDragEnabled));
}

} // namespace
} // namespace codewheel
