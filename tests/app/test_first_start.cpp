// SPDX-License-Identifier: GPL-3.0-or-later
// The first start of all, as the program makes it: the training plant, with what turns pinned in the dial.
#include "app/window/buses/plant.h"
#include "app/window/kinds/interbus/ring_at_work.h"
#include "app/window/program.h"
#include "bus/word_channel.h"
#include "tests/app/window_test.h"
#include "widgets/dial/code_disc.h"
#include "widgets/dial/dial_panel.h"
#include "widgets/start/start_page.h"
#include "widgets/structure/structure_view.h"

#include <QApplication>
#include <QDockWidget>
#include <QFile>
#include <QLocale>
#include <QToolButton>

namespace codewheel {
namespace {

constexpr int soonEnough = 60'000; // ms; sanitizers are slow

class FirstStart : public testing::Test
{
protected:
    ~FirstStart() override { QLocale::setDefault(QLocale::c()); }

    void start(QSize size = {1280, 800})
    {
        program.reset();
        program = std::make_unique<Program>(*qApp, file());
        program->openWindow();
        program->window()->resize(size);
        program->window()->show();
        EXPECT_TRUE(waitFor([this] { return program->plant() != nullptr; }));
        test::waitUntilSettled(window());
    }
    static bool waitFor(const std::function<bool()> &what) { return QTest::qWaitFor(what, soonEnough); }
    QString file() const { return folder.filePath(QStringLiteral("first.ini")); }
    MainWindow &window() { return *program->window(); }
    const QWidget &panel(const char *name) { return *window().findChild<QDockWidget *>(QLatin1String(name)); }
    int bottomHeight() // of what is in front there
    {
        int height = 0;
        for (auto *each : window().findChildren<QDockWidget *>())
            if (window().dockWidgetArea(each) == Qt::BottomDockWidgetArea && !each->visibleRegion().isEmpty())
                height = std::max(height, each->height());
        return height;
    }
    const CodeDisc &disc() { return *window().findChild<DialPanel *>()->findChild<CodeDisc *>(); }
    bool isPinned() { return window().findChild<QToolButton *>(QStringLiteral("pinDial"))->isChecked(); }
    bool dialIsInSight()
    {
        return waitFor([this] { return !disc().visibleRegion().isEmpty(); });
    }

    QTemporaryDir folder;
    std::unique_ptr<Program> program;
};

TEST_F(FirstStart, TheDialOf20IsPinnedInSightBesideTheMonitorOf10AndTurns)
{
    start();
    EXPECT_TRUE(dialIsInSight());
    EXPECT_TRUE(isPinned());
    EXPECT_EQ(disc().accessibleName(), QStringLiteral("Dial of 2.0"));
    EXPECT_EQ(window().findChild<StructureView *>()->current(), test::fraba);
    const WordCard *card = window().findChild<MonitorArea *>()->card(test::fraba);
    ASSERT_NE(card, nullptr);
    EXPECT_FALSE(card->visibleRegion().isEmpty());
    ASSERT_TRUE(waitFor([this] { return disc().state().turnFraction.has_value(); }));
    const auto before = disc().state().turnFraction;
    EXPECT_TRUE(waitFor([&] { return disc().state().turnFraction != before; }));
    EXPECT_TRUE(waitFor([this] { return disc().state().rpm.value_or(0) != 0; }));
    for (const Place place : {test::fraba, test::baumer})
        EXPECT_EQ(program->plant()->buses().channel(place)->out(), 0U) << "nothing was sent for it";
}

TEST_F(FirstStart, InTheSmallestWindowTheDialIsInFrontAndTheMonitorKeepsItsPlace)
{
    start({1024, 640});
    EXPECT_TRUE(dialIsInSight());
    EXPECT_TRUE(panel("parametersDock").visibleRegion().isEmpty()) << "behind it";
    const WordCard *card = window().findChild<MonitorArea *>()->card(test::fraba);
    ASSERT_NE(card, nullptr);
    EXPECT_EQ(card->visibleRegion().boundingRect(), card->rect());
}

TEST_F(FirstStart, TheDialStaysPinnedInAnotherLanguage)
{
    start();
    Q_EMIT window().languageChosen(QStringLiteral("de"));
    EXPECT_TRUE(waitFor([this] { return window().windowTitle().startsWith(QStringLiteral("Unbenannt")); }));
    EXPECT_TRUE(isPinned());
}

TEST_F(FirstStart, IsKeptAsSoonAsItHappened)
{
    EXPECT_TRUE(WindowSettings(file()).isFirstStart());
    start();
    const QString atThatMoment =
        folder.filePath(QStringLiteral("killed.ini")); // as a program that is killed leaves it
    ASSERT_TRUE(QFile::copy(file(), atThatMoment));
    EXPECT_FALSE(WindowSettings(atThatMoment).isFirstStart());
}

TEST_F(FirstStart, TheSecondOneConnectsNothingAndPinsNothing)
{
    start();
    window().saveWindow();
    start();
    EXPECT_TRUE(program->plant()->buses().open().empty());
    EXPECT_TRUE(waitFor([this] { return window().findChild<StartPage *>()->isVisible(); }));
    EXPECT_TRUE(waitFor([this] { return bottomHeight() < 10; })) << "the page has its height";
    EXPECT_FALSE(isPinned());
}

TEST_F(FirstStart, WhatTheUserPinsIsThereAtTheNextStart)
{
    start();
    auto *pin = window().findChild<QToolButton *>(QStringLiteral("pinDial"));
    pin->click();
    EXPECT_FALSE(isPinned());
    EXPECT_EQ(disc().accessibleName(), QStringLiteral("Dial of 1.0"));
    pin->click();
    window().saveWindow();
    start();
    EXPECT_TRUE(isPinned());
    program->plant()->openTraining();
    EXPECT_TRUE(dialIsInSight());
    EXPECT_EQ(disc().accessibleName(), QStringLiteral("Dial of 1.0"));
}

} // namespace
} // namespace codewheel
