// SPDX-License-Identifier: GPL-3.0-or-later
// The comparison of what a fault of the ring has changed, and with what the master keeps.
#include "kinds/interbus/plan/project_take_over.h"
#include "tests/app/window_test.h"
#include "tests/support/places.h"
#include "widgets/kinds/interbus/master/ring_comparison.h"
#include "widgets/look/inline_message.h"

#include <QAbstractItemView>
#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QTest>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::baumer;

class ComparisonPageTest : public test::WindowTest
{
protected:
    ComparisonPageTest()
    {
        window().showComparison();
        advance(40);
    }

    RingComparison &page() { return *window().findChild<RingComparison *>(); }
    QTableView &table() { return *page().findChild<QTableView *>(); }
    void click(const char *button)
    {
        auto *found = page().findChild<QPushButton *>(QLatin1String(button));
        ASSERT_TRUE(found->isEnabled()) << button;
        QTest::mouseClick(found, Qt::LeftButton);
        advance(200);
    }
    void otherDeviceAt(Place place)
    {
        shown->controls().setFault(TrainingFault::wrongDevice, place.node, 1);
        advance(60);
        click("readIn");
    }
    std::optional<KeptConfiguration> kept()
    {
        std::optional<KeptConfiguration> told;
        const auto connection = QObject::connect(
            &bus(), &RingSession::keptConfigurationTold,
            [&](const std::optional<KeptConfiguration> &configuration) { told = configuration; });
        bus().askKeptConfiguration();
        advance(40);
        QObject::disconnect(connection);
        return told;
    }
    // The message, and its first button.
    InlineMessage &message()
    {
        return *page().findChild<InlineMessage *>(QStringLiteral("comparisonMessage"));
    }
};

TEST_F(ComparisonPageTest, AnotherDeviceIsToldAfterReadingInAndTakenOver)
{
    EXPECT_EQ(page().differences(), 0);
    otherDeviceAt(baumer);
    ASSERT_EQ(page().differences(), 1);
    EXPECT_EQ(page().findChild<QLabel *>(QStringLiteral("comparisonSummary"))->text(),
              QStringLiteral("1 lines differ."));
    EXPECT_TRUE(table().model()->index(1, 2).data().toString().contains(QStringLiteral("found")))
        << table().model()->index(1, 2).data().toString().toStdString();
    table().selectRow(1);
    click("linesIntoProject");
    EXPECT_EQ(page().differences(), 0);
    EXPECT_EQ(shown->project().device(baumer).participant.deviceCode, 0x0236U);
    shown->project().undoStack().undo();
    EXPECT_EQ(page().differences(), 1);
}

// Nobody hears of the devices while the bus stands: the comparison is of before, and says so.
TEST_F(ComparisonPageTest, OfABusThatDoesNotRunItSaysHowItWas)
{
    const auto &summary = *page().findChild<QLabel *>(QStringLiteral("comparisonSummary"));
    const auto cell = [&](int row, int role) { return table().model()->index(row, 1).data(role); };
    EXPECT_EQ(summary.text(), QStringLiteral("The bus is as configured."));
    EXPECT_FALSE(cell(0, Qt::ForegroundRole).isValid());
    bus().setRunning(false);
    advance(1'200);
    const QString old =
        QStringLiteral("The bus was as configured. The bus does not run. Shown is how it was ");
    EXPECT_TRUE(summary.text().startsWith(old)) << summary.text().toStdString();
    EXPECT_TRUE(cell(0, Qt::ForegroundRole).isValid());
    EXPECT_TRUE(cell(0, Qt::AccessibleTextRole).toString().endsWith(QStringLiteral("not up to date")));
    EXPECT_TRUE(cell(0, Qt::ToolTipRole).toString().contains(QStringLiteral("The bus does not run.")));
    bus().setRunning(true);
    advance(1'200);
    EXPECT_EQ(summary.text(), QStringLiteral("The bus is as configured."));
    bus().alarmStop();
    advance(1'200);
    EXPECT_TRUE(summary.text().startsWith(old)) << summary.text().toStdString();
}

TEST_F(ComparisonPageTest, WhatLiesBehindAFaultIsNamed)
{
    bus().switchSegment(4, false);
    advance(1'200);
    const QString text = page().findChild<QLabel *>(QStringLiteral("comparisonSummary"))->text();
    EXPECT_TRUE(text.startsWith(QStringLiteral("The bus was as configured. 4.0"))) << text.toStdString();
    EXPECT_TRUE(text.contains(QStringLiteral("The device is not on the bus."))) << text.toStdString();
    EXPECT_FALSE(table().model()->index(0, 1).data(Qt::ForegroundRole).isValid()) << "1.0 is there";
    EXPECT_TRUE(table().model()->index(3, 1).data(Qt::ForegroundRole).isValid());
}

TEST_F(ComparisonPageTest, TheProjectIsDownloadedLoadedBackAndTakenBack)
{
    const auto before = kept();
    shown->project().setFile(folder.filePath(QStringLiteral("crane.codewheel")));
    otherDeviceAt(baumer);
    click("allIntoMaster");
    ASSERT_TRUE(kept());
    EXPECT_EQ(kept()->fileName, QStringLiteral("crane.codewheel"));
    EXPECT_EQ(kept()->structure.at(1).deviceCode, 0x0237U) << "as it is planned";
    EXPECT_TRUE(message().sentence().contains(QStringLiteral("crane.codewheel with 7 devices")))
        << message().sentence().toStdString();
    if (!before)
        return; // nothing to restore
    QTest::mouseClick(message().findChild<QPushButton *>(), Qt::LeftButton);
    advance(200);
    EXPECT_EQ(kept(), before);
}

TEST_F(ComparisonPageTest, WhatTheMasterKeepsIsLoadedIntoTheProject)
{
    auto *load = page().findChild<QPushButton *>(QStringLiteral("keptIntoProject"));
    EXPECT_FALSE(load->isEnabled()) << "the project is the same";
    Project other = shown->project().project();
    other.devices.at(0).station = QStringLiteral("Hoist");
    other.devices.erase(other.devices.begin() + 1, other.devices.end());
    shown->project().setProject(other, {});
    EXPECT_EQ(page().differences(), 6);
    click("keptIntoProject");
    EXPECT_EQ(structureOf(shown->project().project()).size(), kept()->structure.size());
    EXPECT_EQ(page().differences(), 0);
    EXPECT_EQ(shown->project().device(test::fraba).station, QStringLiteral("Hoist"))
        << "what stayed keeps it";
    EXPECT_TRUE(message().sentence().contains(QStringLiteral("training.json")));
    EXPECT_FALSE(load->isEnabled());
    shown->project().undoStack().undo();
    EXPECT_EQ(shown->project().project().devices.size(), 1U);
}

TEST_F(ComparisonPageTest, InWatchNothingIsDownloaded)
{
    const auto before = kept();
    actions().watch->trigger();
    advance(40);
    for (const char *button : {"allIntoMaster", "readIn"}) {
        click(button);
        EXPECT_TRUE(message().sentence().contains(QStringLiteral("Switch to Operate first"))) << button;
    }
    EXPECT_EQ(kept(), before);
    actions().operate->trigger();
    advance(40);
    EXPECT_FALSE(message().isVisible());
}

TEST_F(ComparisonPageTest, NoDifferenceIsCutOffInASmallWindow)
{
    window().resize(1024, 640);
    otherDeviceAt("3.0"_ring);
    const QString longest = table().model()->index(2, 2).data().toString();
    ASSERT_TRUE(longest.contains(QStringLiteral("configured"))) << longest.toStdString();
    for (const int width : {table().width(), table().width() - 150}) {
        table().setFixedWidth(width);
        advance(20);
        for (int row = 0; row < table().model()->rowCount(); ++row)
            EXPECT_GE(table().rowHeight(row), static_cast<QAbstractItemView &>(table()).sizeHintForRow(row))
                << row << " at " << width;
    }
}

} // namespace
} // namespace codewheel
