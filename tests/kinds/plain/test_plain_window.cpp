// SPDX-License-Identifier: GPL-3.0-or-later
// A kind of bus that the window does not know, added at run time.
#include "tests/kinds/plain/plain_in_window.h"
#include "tests/kinds/plain/plain_recording.h"
#include "widgets/dial/code_disc.h"
#include "widgets/models/traffic_model.h"
#include "widgets/parameters/wanted_values.h"
#include "widgets/trace/trace_view.h"

#include <QAction>
#include <QDockWidget>

#include <gmock/gmock.h>

namespace codewheel {
namespace {

using test::PlainBusInWindow;

TEST_F(PlainBusInWindow, ItsNodesStandInTheTree)
{
    EXPECT_EQ(cell(test::plainHoist, StructureModel::deviceColumn), "n:1  Hoist encoder");
    EXPECT_EQ(cell(test::plainLamp, StructureModel::deviceColumn), "n:3  Lamp");
    EXPECT_EQ(cell(test::plainHoist, StructureModel::positionColumn), "1001");
    advance(500);
    EXPECT_EQ(cell(test::plainHoist, StructureModel::positionColumn), "1501");
}

TEST_F(PlainBusInWindow, ItsEncoderIsOnTheDial)
{
    const auto text = [&] { return window().findChild<CodeDisc *>()->valueText().toStdString(); };
    tree().choose(test::plainGate);
    advance(100);
    EXPECT_THAT(text(), testing::HasSubstr("1101"));
    advance(400);
    EXPECT_THAT(text(), testing::HasSubstr("1501"));
}

TEST_F(PlainBusInWindow, ItsKindBringsAPanel)
{
    ASSERT_NE(plain(), nullptr);
    Q_EMIT tree().busOpened(test::plainId);
    const auto pages = window().findChildren<QLabel *>();
    const auto page = std::ranges::find(pages, QStringLiteral("plain page"), &QLabel::text);
    ASSERT_NE(page, pages.end());
    EXPECT_TRUE((*page)->isVisible());
    EXPECT_FALSE((*page)->visibleRegion().isEmpty());
    EXPECT_NE(window().findChild<QDockWidget *>(QStringLiteral("plainDock")), nullptr);
}

TEST_F(PlainBusInWindow, ItsValuesAreTypedReviewedAndWritten)
{
    const test::PlainNode &node = plainBus().node(test::plainHoist);
    plainBus().setOperate(true);
    tree().choose(test::plainHoist);
    want(test::plainFilter(), QStringLiteral("-5"));
    want(test::plainName(), QStringLiteral("Hoist 2"));
    review();
    EXPECT_TRUE(node.heard().empty()) << "it is only reviewed";
    confirm();
    EXPECT_EQ(node.inForce("2000:1"), "-5");
    EXPECT_EQ(node.inForce("1008"), "Hoist%202");
    EXPECT_EQ(node.writes(), 1);
    EXPECT_TRUE(says(panel(), QStringLiteral("Filter, Device name")) ||
                says(panel(), QStringLiteral("Device name, Filter")));
    panel().showParameter(test::plainFilter());
    const QModelIndex known =
        panel().findChild<ParameterTable *>()->currentIndex().siblingAtColumn(ParameterModel::knownColumn);
    EXPECT_EQ(known.data(ParameterModel::shortDetailRole).toString(), QStringLiteral("read, stored"));
    EXPECT_TRUE(known.data(Qt::ToolTipRole).toString().contains(QStringLiteral("It is stored: ")));
}

TEST_F(PlainBusInWindow, TheWizardTakesItStepByStep)
{
    const test::PlainNode &node = plainBus().node(test::plainHoist);
    plainBus().setOperate(true);
    tree().choose(test::plainHoist);
    window().findChild<WantedValues *>()->set(test::plainHoist, test::plainFilter(), -5);
    actions().wizard->trigger();
    clickInWizard("wizardNext");
    clickInWizard("readAll");
    const auto *nextStep = window().findChild<QAbstractButton *>(QStringLiteral("nextStep"));
    for (int page = 0; page < 6 && !nextStep->isVisible(); ++page)
        clickInWizard("wizardNext");
    for (const QByteArray &line : node.heard())
        EXPECT_TRUE(line.startsWith("get ")) << line.toStdString();
    for (int step = 0; step < 3; ++step) // set, go, keep
        clickInWizard("nextStep");
    advance(200);
    ASSERT_FALSE(window().findChild<ParameterWizard *>()->isBusy());
    EXPECT_EQ(node.inForce("2000:1"), "-5");
    EXPECT_EQ(node.writes(), 1);
}

TEST_F(PlainBusInWindow, ItsRecordingIsShownAsItWas)
{
    const Catalog catalog = Catalog::builtIn();
    const test::PlainRecording recording(catalog);
    ASSERT_TRUE(window().openRecording(recording.path));
    constexpr Place recorded{BusId{100'001}, test::plainHoist.node};
    tree().choose(recorded);
    QTest::keyClick(&window(), Qt::Key_End, Qt::ControlModifier | Qt::AltModifier);
    advance(66);
    EXPECT_EQ(cell(recorded, StructureModel::positionColumn), std::to_string(recording.position.value_or(0)));
    TrafficModel &rows = *window().findChild<TraceView *>()->model(recorded);
    QStringList titles;
    QStringList cells;
    for (int column = 2; column < rows.columnCount(); ++column) {
        titles << rows.headerData(column, Qt::Horizontal).toString();
        cells << rows.index(0, column).data().toString();
    }
    EXPECT_EQ(titles.join(u'|'), QStringLiteral("\u2195|Hex|Meaning|Remark"));
    EXPECT_TRUE(cells.join(u'|').endsWith(QStringLiteral("|Filter := -5, Device name := Hoist 2|")))
        << cells.join(u'|').toStdString();
}

// Nothing meant for other kinds is done to it.
TEST_F(PlainBusInWindow, ChoosingAndOpeningItDoesNoHarm)
{
    tree().choose(test::plainId);
    advance(50);
    EXPECT_TRUE(bus().isOperating());
    actions().watch->trigger();
    EXPECT_TRUE(bus().isOperating()) << "the switch means the chosen bus";
    tree().choose(test::plainHoist);
    Q_EMIT tree().opened(test::plainHoist);
    actions().alarmStop->trigger();
    advance(50);
    EXPECT_EQ(cell(test::plainHoist, StructureModel::positionColumn), "1101");
}

TEST_F(PlainBusInWindow, WhatThePlantHasOfItGoesWithIt)
{
    tree().choose(test::plainHoist);
    plain()->bus()->close();
    Project other = shown->project().project();
    other.title = QStringLiteral("Other");
    std::erase_if(other.buses, [](const PlannedBus &bus) { return bus.id == test::plainId; });
    shown->project().edit(other, QStringLiteral("Without it"));
    advance(50);
    EXPECT_EQ(plain(), nullptr);
    EXPECT_EQ(cell(test::plainHoist, StructureModel::deviceColumn), "");
}

} // namespace
} // namespace codewheel
