// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/places.h"
#include "tests/widgets/training_bus_session.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/inline_message.h"
#include "widgets/monitor/monitor_area.h"
#include "widgets/monitor/number_field.h"
#include "widgets/monitor/word_monitor.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLatin1Char>
#include <QMenu>
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
        for (const WordMonitor *monitor : area.monitors())
            names << monitor->place().toString() + QLatin1Char(' ') + monitorKindText(monitor->kind());
        return names;
    }

    test::TrainingBusSession ring;
    MonitorArea area{ring.buses};
};

TEST_F(MonitorAreaTest, EmptyItSaysHowToOpenAMonitor)
{
    const auto *empty = area.findChild<EmptyState *>();
    EXPECT_TRUE(empty->isVisible());
    area.openMonitor(fraba, MonitorKind::in32);
    EXPECT_FALSE(empty->isVisible());
    area.closeMonitor(fraba, MonitorKind::in32);
    EXPECT_TRUE(empty->isVisible());
}

TEST_F(MonitorAreaTest, AtFirstStartBothWordsOfTheFirstEncoderAreOpen)
{
    area.openFirst();
    EXPECT_EQ(open(), (QStringList{QStringLiteral("1.0 IN 32"), QStringLiteral("1.0 OUT 32")}));
}

TEST_F(MonitorAreaTest, OpensEachMonitorOnce)
{
    area.openMonitor(fraba, MonitorKind::in32);
    area.openMonitor(baumer, MonitorKind::out32);
    area.openMonitor(fraba, MonitorKind::in32);
    EXPECT_EQ(open(), (QStringList{QStringLiteral("1.0 IN 32"), QStringLiteral("2.0 OUT 32")}));
}

TEST_F(MonitorAreaTest, ADeviceThatIsNotThereIsRefusedWithASentence)
{
    area.openMonitor("7.0"_ring, MonitorKind::in32);
    EXPECT_TRUE(open().isEmpty());
    EXPECT_EQ(area.findChild<InlineMessage *>()->sentence(),
              QStringLiteral("7.0 has no word IN 32 to show. Choose another device or word."));
}

TEST_F(MonitorAreaTest, OpensTheWordsADeviceHas)
{
    area.openWords(test::singleTurn);
    area.openWords(test::multiTurn);
    area.openWords(test::onLoop);
    EXPECT_EQ(open(), (QStringList{QStringLiteral("3.0 IN 16"), QStringLiteral("4.0 IN 32"),
                                   QStringLiteral("6.1 IN 32"), QStringLiteral("6.1 OUT 32")}));
    EXPECT_TRUE(area.findChild<InlineMessage *>()->isHidden());
    EXPECT_EQ(area.monitor(test::singleTurn, MonitorKind::in16)->hexText(), QStringLiteral("03E9"));
}

TEST_F(MonitorAreaTest, WhereThereIsNoOutWordItSaysSo)
{
    const QString name = QStringLiteral("noOut");
    area.openWords(test::singleTurn);
    area.openWords(fraba);
    const auto *note = area.monitor(test::singleTurn, MonitorKind::in16)->findChild<QLabel *>(name);
    ASSERT_NE(note, nullptr);
    EXPECT_EQ(note->text(), QStringLiteral("3.0 has no OUT word: nothing can be sent to it."));
    EXPECT_EQ(area.monitor(fraba, MonitorKind::in32)->findChild<QLabel *>(name), nullptr);

    const auto *message = area.findChild<InlineMessage *>(QString(), Qt::FindDirectChildrenOnly);
    area.openMonitor(test::multiTurn, MonitorKind::out32);
    EXPECT_EQ(message->sentence(),
              QStringLiteral("FRABA OCD-IB K2 has no OUT word: nothing can be sent to it."));
    area.openWords(test::busTerminal);
    EXPECT_EQ(message->sentence(),
              QStringLiteral("6.0 has no words to show: it takes no part in the process data."));
}

TEST_F(MonitorAreaTest, WhatAPositionOnlyEncoderShowsIsExplained)
{
    area.openWords(test::singleTurn);
    ring.controls->setSpeed(test::singleTurn.node, 0);
    ring.controls->turnTo(test::singleTurn.node, 4095);
    ring.bus.advance(5);
    const WordMonitor *monitor = area.monitor(test::singleTurn, MonitorKind::in16);
    EXPECT_EQ(monitor->hexText(), QStringLiteral("0FFF"));
    EXPECT_EQ(monitor->meaning(), QStringLiteral("Running, position 4095"));
}

TEST_F(MonitorAreaTest, TheMenuOffersEveryWordOfEveryDevice)
{
    auto *menu = area.findChild<QMenu *>();
    QMetaObject::invokeMethod(menu, "aboutToShow");
    ASSERT_EQ(menu->actions().size(), 15) << "K1 has one word, K2 two, a bus terminal none";
    EXPECT_EQ(menu->actions().at(1)->text(), QStringLiteral("1.0  OUT 32  FRABA OCD-IB K3"));
    menu->actions().at(1)->trigger();
    EXPECT_EQ(open(), QStringList{QStringLiteral("1.0 OUT 32")});
}

TEST_F(MonitorAreaTest, MonitorsMoveWithTheBus)
{
    area.openMonitor(fraba, MonitorKind::in32);
    ring.controls->turnTo(fraba.node, 0x77);
    ring.bus.advance(5);
    EXPECT_EQ(area.monitor(fraba, MonitorKind::in32)->hexText(), QStringLiteral("00000077"));
}

TEST_F(MonitorAreaTest, TheCloseButtonClosesItsMonitor)
{
    area.openMonitor(fraba, MonitorKind::in32);
    area.openMonitor(fraba, MonitorKind::out32);
    for (auto *button : area.findChildren<QToolButton *>())
        if (button->accessibleName() == QLatin1String("Close monitor IN 1.0"))
            QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_EQ(open(), QStringList{QStringLiteral("1.0 OUT 32")});
}

TEST_F(MonitorAreaTest, WhatAMonitorShowsIsKeptForItsKind)
{
    area.openMonitor(fraba, MonitorKind::in32);
    area.openMonitor(fraba, MonitorKind::in16);
    area.monitor(fraba, MonitorKind::in16)->setHighHalf(true);
    Q_EMIT area.monitor(fraba, MonitorKind::in32)->displayChosen({.gray = false});
    const QJsonObject state = area.state();

    MonitorArea another(ring.buses);
    another.restoreState(state);
    EXPECT_EQ(another.state(), state);
    EXPECT_TRUE(another.monitor(fraba, MonitorKind::in16)->isHighHalf());
    another.openMonitor(baumer, MonitorKind::in32);
    const auto fields = another.monitor(baumer, MonitorKind::in32)->findChildren<NumberField *>();
    EXPECT_GE(fields.size(), 3);
    for (const auto *field : fields)
        EXPECT_EQ(field->isHidden(), field->accessibleName() == QLatin1String("IN 2.0 Gray"));
}

TEST_F(MonitorAreaTest, AStateFromAnotherBusOpensWhatIsThere)
{
    const auto json = QJsonDocument::fromJson(
        R"({"monitors": [{"place": "9.0", "kind": "IN 32"}, {"place": "2.0", "kind": "IN 32"}, 5,
            {"place": "2.0", "kind": "TREND"}]})");
    area.restoreState(json.object());
    EXPECT_EQ(open(), QStringList{QStringLiteral("2.0 IN 32")});
}

TEST_F(MonitorAreaTest, MonitorsGoAndComeBackWithTheirBus)
{
    area.openMonitor(fraba, MonitorKind::in32);
    ring.bus.close();
    EXPECT_TRUE(open().isEmpty());
    const QJsonObject kept = area.state();
    EXPECT_TRUE(ring.bus.open(RingSession::Start::watching));
    ring.bus.advance(5);
    EXPECT_EQ(open(), QStringList{QStringLiteral("1.0 IN 32")});
    EXPECT_EQ(area.state(), kept);
}

} // namespace
} // namespace codewheel
