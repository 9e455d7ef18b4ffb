// SPDX-License-Identifier: GPL-3.0-or-later
// The start page: when it is seen, and what its entries do.
#include "app/window/buses/plant.h"
#include "app/window/connect/start.h"
#include "app/window/files/project_files.h"
#include "app/window/kinds/esc/esc_line_at_work.h"
#include "app/window/look/bottom_fold.h"
#include "app/window/program.h"
#include "cams/cam_file.h"
#include "kinds/interbus/gateway/gateway_settings.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "project/file_access.h"
#include "project/project_file.h"
#include "tests/app/question.h"
#include "tests/app/window_test.h"
#include "widgets/look/inline_message.h"
#include "widgets/parameters/parameter_model.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_table.h"
#include "widgets/start/recent_list.h"
#include "widgets/start/start_page.h"
#include "widgets/structure/structure_model.h"
#include "widgets/structure/structure_view.h"

#include <QAction>
#include <QApplication>
#include <QFile>
#include <QMenu>
#include <QPushButton>
#include <QTimer>
#include <QTreeView>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::Question;

constexpr int longestWait = 60'000; // ms

class StartPageTest : public test::WindowTest
{
protected:
    void disconnectAll()
    {
        ringActions().disconnectBus->trigger();
        lineActions().disconnectBus->trigger();
        advance(5);
    }
    StartPage &start() { return *window().findChild<StartPage *>(); }
    bool isSeen() { return page() == &start(); }
    QPushButton &entry(const char *name) { return *start().findChild<QPushButton *>(QLatin1String(name)); }
    RecentList &recent() { return *start().findChild<RecentList *>(); }
    QString save(const char *name)
    {
        const QString path = folder.filePath(QString::fromLatin1(name));
        EXPECT_TRUE(saveProject(shown->project().project(), path));
        return path;
    }
    QString replaceNotice()
    {
        const auto *notice = window().findChild<InlineMessage *>(QStringLiteral("replaceNotice"));
        return notice->isVisible() ? notice->sentence() : QString();
    }
    bool waitForRow(int row, const QString &text)
    {
        return QTest::qWaitFor([&] { return recent().item(row)->text().contains(text); }, longestWait);
    }
};

TEST_F(StartPageTest, StandsInPlaceOfTheMonitorsWhileNoBusIsConnected)
{
    EXPECT_EQ(page(), &monitors());
    ringActions().disconnectBus->trigger();
    advance(5);
    EXPECT_EQ(page(), &monitors()) << "the line is connected";
    lineActions().disconnectBus->trigger();
    advance(5);
    EXPECT_TRUE(isSeen());
    actions().monitors->trigger();
    EXPECT_TRUE(isSeen());
    ringActions().connectBus->trigger();
    advance(50);
    EXPECT_EQ(page(), &monitors());
}

// The value is typed where the first click goes, and the review is confirmed by Return.
TEST_F(StartPageTest, ItsKeysWorkAsSoonAsTheLastBusIsDisconnected)
{
    window().findChild<StructureView *>()->setFocus();
    disconnectAll();
    ASSERT_NE(QApplication::focusWidget(), nullptr);
    EXPECT_TRUE(start().isAncestorOf(QApplication::focusWidget()));
}

TEST_F(StartPageTest, ThreeClicksToTheFirstWrittenParameter)
{
    disconnectAll();
    QTest::mouseClick(&entry("startTraining"), Qt::LeftButton);
    advance(50);

    const auto &panel = *window().findChild<ParameterPanel *>();
    const auto *table = panel.findChild<ParameterTable *>();
    const QModelIndex steps = table->model()->index(0, ParameterModel::wantedColumn);
    QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualRect(steps).center());
    QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("4096"));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);

    QTest::mouseClick(panel.findChild<QPushButton *>(QStringLiteral("writeParameters")), Qt::LeftButton);
    advance(50);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    advance(3'000);
    const QModelIndex known = steps.siblingAtColumn(ParameterModel::knownColumn);
    EXPECT_EQ(known.data().toString(), QStringLiteral("4096"));
}

// The training bus, the encoder, More, "Set the position...": what is typed is reviewed, and confirmed by
// Return.
TEST_F(StartPageTest, FourClicksToAPresetOnALine)
{
    const Place onLine = placeOnLine({5});
    disconnectAll();
    QTest::mouseClick(&entry("startTraining"), Qt::LeftButton);
    advance(200);
    auto &tree = *window().findChild<QTreeView *>(QStringLiteral("structure"));
    const QModelIndex row = static_cast<const StructureModel *>(tree.model())->indexOf(onLine);
    tree.scrollTo(row);
    QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, tree.visualRect(row).center());
    advance(50);

    auto &panel = *window().findChild<ParameterPanel *>();
    auto &menu = *panel.findChild<QMenu *>(QStringLiteral("moreMenu"));
    bool isChosen = false;
    QTimer::singleShot(0, &menu, [&] { // while the menu is open
        for (QAction *action : menu.actions())
            if (QString(action->text()).remove(u'&').startsWith(QStringLiteral("Set the position"))) {
                QTest::mouseClick(&menu, Qt::LeftButton, {}, menu.actionGeometry(action).center());
                isChosen = true;
            }
    });
    QTest::mouseClick(static_cast<QWidget *>(menu.parent()), Qt::LeftButton);
    ASSERT_TRUE(isChosen);
    EncoderSession &encoder = *shown->line().session()->encoder(onLine);
    const int before = encoder.eepromCount().writes;
    QTest::keyClicks(window().focusWidget(), QStringLiteral("1000"));
    QTest::keyClick(window().focusWidget(), Qt::Key_Return);
    advance(500);
    EXPECT_EQ(encoder.eepromCount().writes, before) << "it is reviewed first";
    QTest::keyClick(window().focusWidget(), Qt::Key_Return);
    advance(3'000);
    EXPECT_EQ(encoder.latest().position, 1000);
    EXPECT_EQ(encoder.eepromCount().writes, before + 1);
}

TEST_F(StartPageTest, HasTheHeightOfThePanelsAtTheBottom)
{
    resizeTo({1280, 800});
    const int before = start().parentWidget()->height();
    disconnectAll();
    EXPECT_TRUE(QTest::qWaitFor([&] { return start().height() > before + 100; })) << start().height();
    ringActions().connectBus->trigger();
    advance(50);
    EXPECT_TRUE(QTest::qWaitFor([&] { return monitors().height() == before; })) << monitors().height();
}

TEST_F(StartPageTest, BetweenItAndAPageThePanelsStayAsTheUserHasThem)
{
    resizeTo({1280, 800});
    disconnectAll();
    const int high = start().height();
    window().findChild<BottomFold *>()->unfold(); // as a click on a tab does
    advance(50);
    ASSERT_LT(start().height(), high - 100);
    actions().structureEditor->trigger();
    advance(50);
    actions().closePage->trigger();
    advance(50);
    EXPECT_LT(start().height(), high - 100);
    ringActions().connectBus->trigger();
    advance(50);
    disconnectAll();
    EXPECT_TRUE(QTest::qWaitFor([&] { return start().height() == high; })) << "the next time they are folded";
}

TEST_F(StartPageTest, ItsKeysWorkAgainAfterAPageWasClosed)
{
    disconnectAll();
    actions().structureEditor->trigger();
    actions().closePage->trigger();
    ASSERT_EQ(page(), &start());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_1);
    advance(50);
    EXPECT_TRUE(bus().isOpen()) << "the training bus";
}

TEST_F(StartPageTest, LeavesAPageThatIsOpenInItsPlace)
{
    actions().structureEditor->trigger();
    const QWidget *editor = page();
    disconnectAll();
    EXPECT_EQ(page(), editor);
    actions().monitors->trigger();
    EXPECT_TRUE(isSeen());
}

TEST_F(StartPageTest, TheTrainingBusOfThePlantIsConnectedByItsKeyAndThePlanStays)
{
    shown->project().editDevice(test::fraba, QStringLiteral("Station"),
                                [](ProjectDevice &device) { device.station = QStringLiteral("Hoist"); });
    disconnectAll();
    actions().monitors->trigger();
    start().setFocus();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_1);
    advance(50);
    EXPECT_EQ(shown->buses().open().size(), 2u);
    EXPECT_EQ(shown->project().device(test::fraba).station, QStringLiteral("Hoist"));
    EXPECT_EQ(page(), &monitors());
}

TEST_F(StartPageTest, TheTrainingBusLeavesAProjectThatWasOpened)
{
    const QString path = save("crane.codewheel");
    disconnectAll();
    ASSERT_TRUE(window().files().open(path));
    entry("startTraining").click();
    advance(50);
    EXPECT_TRUE(shown->project().file().isEmpty());
    EXPECT_FALSE(shown->project().project().devices.empty()) << "it is that of the plant";
    EXPECT_EQ(shown->buses().open().size(), 2u);
    const auto *notice = window().findChild<InlineMessage *>(QStringLiteral("notice"));
    EXPECT_TRUE(notice->isVisible());
    EXPECT_TRUE(notice->sentence().startsWith(QStringLiteral("The project crane.codewheel was closed")))
        << notice->sentence().toStdString();
}

// As after a gateway was connected without saving.
TEST_F(StartPageTest, TheTrainingBusAsksBeforeItReplacesWhatIsPlannedForAGateway)
{
    disconnectAll();
    Project planned = shown->project().project();
    RingPlan ring = ringPlan(planned, firstBus);
    ring.link = {QString::fromLatin1(modbusTcpLink),
                 {{QStringLiteral("host"), QStringLiteral("gateway.hall")}}};
    setRingPlan(planned, firstBus, ring);
    shown->project().edit(planned, QStringLiteral("Connection"));
    {
        const auto question = Question::answeredBy(QStringLiteral("Cancel"));
        entry("startTraining").click();
        EXPECT_TRUE(question.wasAsked());
    }
    EXPECT_TRUE(shown->buses().open().empty());
    const auto question = Question::answeredBy(QStringLiteral("Discard"));
    entry("startTraining").click();
    advance(50);
    EXPECT_EQ(shown->buses().open().size(), 2u);
    EXPECT_TRUE(bus().isSimulated());
    EXPECT_EQ(bus().encoder(test::fraba)->known(Parameter::startUpMode)->value, 1) << "as its plan tells";
}

TEST_F(StartPageTest, ConnectOffersTheBusesOfAPlanOrAll)
{
    disconnectAll();
    entry("startConnect").click(); // only the ring is planned
    advance(50);
    EXPECT_TRUE(bus().isOpen());
    disconnectAll();
    shown->project().setProject({}, {});
    entry("startConnect").click();
    auto *menu = start().findChild<QMenu *>();
    ASSERT_NE(menu, nullptr);
    ASSERT_EQ(menu->actions().size(), 3); // a ring, a serial line, a CAN bus
    menu->actions().at(1)->trigger();
    EXPECT_EQ(page()->objectName(), QStringLiteral("lineSettings")) << "nothing is opened unasked";
    EXPECT_TRUE(shown->buses().open().empty());
    delete menu;
}

TEST_F(StartPageTest, RecentProjectsAreOpenedAndTakenOffTheList)
{
    const QString first = save("first.codewheel");
    const QString second = save("second.codewheel");
    ASSERT_TRUE(window().files().open(first));
    ASSERT_TRUE(window().files().open(second));
    ASSERT_TRUE(QFile::remove(first));
    disconnectAll();
    actions().structureEditor->trigger();
    actions().monitors->trigger(); // checks the files again
    ASSERT_EQ(recent().count(), 2);
    ASSERT_TRUE(waitForRow(1, QStringLiteral("not there any more")));
    recent().setFocus();
    recent().setCurrentRow(1);
    QTest::keyClick(&recent(), Qt::Key_Return);
    advance(5);
    EXPECT_EQ(shown->project().file(), second) << "what is not there is not opened";
    QTest::keyClick(&recent(), Qt::Key_Delete);
    ASSERT_EQ(recent().count(), 1);
    QTest::keyClick(&recent(), Qt::Key_Return);
    advance(5);
    EXPECT_EQ(shown->project().file(), second);
}

TEST_F(StartPageTest, TheProjectOfTheSessionBeforeIsOffered)
{
    const QString path = save("crane.codewheel");
    disconnectAll();
    EXPECT_FALSE(entry("startReopen").isVisible());
    window().start().offer(path);
    EXPECT_TRUE(entry("startReopen").isVisible());
    EXPECT_TRUE(entry("startReopen").accessibleName().contains(QStringLiteral("crane.codewheel")));
    entry("startReopen").click();
    EXPECT_EQ(shown->project().file(), path);
    EXPECT_FALSE(entry("startReopen").isVisible());
    EXPECT_TRUE(shown->buses().open().empty()) << "nothing is connected unasked";
}

TEST_F(StartPageTest, ReplacingLeadsOverConnectingToTheReplacePage)
{
    disconnectAll();
    entry("startReplace").click();
    EXPECT_TRUE(replaceNotice().contains(QStringLiteral("connect")));
    auto *notice = window().findChild<InlineMessage *>(QStringLiteral("replaceNotice"));
    const auto press = [notice] {
        for (auto *button : notice->findChildren<QPushButton *>())
            if (button->isVisible())
                return button->click();
        ADD_FAILURE() << "no button";
    };
    press();
    advance(50);
    EXPECT_TRUE(bus().isOpen());
    EXPECT_TRUE(replaceNotice().contains(QStringLiteral("choose")));
    press();
    EXPECT_TRUE(replaceNotice().isEmpty());
    EXPECT_EQ(page()->accessibleName(), QStringLiteral("Replace encoder"));
}

class StartOfTheProgram : public testing::Test
{
protected:
    void start(const QString &file = {})
    {
        program.reset();
        program = std::make_unique<Program>(*qApp, folder.filePath(QStringLiteral("program.ini")));
        program->openAtStart(file);
        program->openWindow();
        program->window()->show();
        ASSERT_TRUE(QTest::qWaitFor([this] { return program->plant() != nullptr; }, longestWait));
    }
    void end()
    {
        program->window()->saveWindow();
        program.reset();
    }
    bool isConnected()
    {
        return QTest::qWaitFor([this] { return !program->plant()->buses().open().empty(); }, 1'000);
    }
    StartPage &page() { return *program->window()->findChild<StartPage *>(); }

    QTemporaryDir folder;
    std::unique_ptr<Program> program;
};

TEST_F(StartOfTheProgram, TheFirstIsAliveAndTheNextOffersWhatTheLastHadOpen)
{
    start();
    ASSERT_TRUE(isConnected());
    const QString file = folder.filePath(QStringLiteral("crane.codewheel"));
    ASSERT_TRUE(saveProject({}, file));
    ASSERT_TRUE(program->window()->files().open(file));
    end();
    start();
    EXPECT_TRUE(program->plant()->buses().open().empty());
    EXPECT_TRUE(page().isVisible());
    EXPECT_TRUE(page().reopen->isVisible());
    EXPECT_EQ(program->window()->focusWidget()->objectName(), QStringLiteral("startReopen"));
    EXPECT_EQ(program->window()->windowTitle(), QStringLiteral("Untitled[*]"));
    page().training->trigger();
    ASSERT_TRUE(isConnected());
    EXPECT_FALSE(page().isVisible());
}

TEST_F(StartOfTheProgram, WithAProjectConnectsNothing)
{
    const QString file = folder.filePath(QStringLiteral("crane.codewheel"));
    ASSERT_TRUE(saveProject({}, file));
    start(file);
    EXPECT_EQ(program->window()->windowTitle(), QStringLiteral("crane.codewheel[*]"));
    EXPECT_TRUE(program->plant()->buses().open().empty());
    EXPECT_TRUE(page().isVisible());
    EXPECT_FALSE(page().reopen->isVisible());
}

TEST_F(StartOfTheProgram, WithCamsAsksForTheirEncoder)
{
    const QString file = folder.filePath(QStringLiteral("hoist.cwcams"));
    ASSERT_TRUE(replaceFile(
        file, camFileToJson({.device = QStringLiteral("fraba-ocd-ib"), .totalRange = {}, .programs = {{}}}),
        OldFile::goes));
    start(file);
    const auto *notice = program->window()->findChild<InlineMessage *>(QStringLiteral("waitingCams"));
    EXPECT_TRUE(notice->isVisible());
    EXPECT_TRUE(notice->sentence().startsWith(QStringLiteral("hoist.cwcams has cam programs")));
    EXPECT_TRUE(program->plant()->buses().open().empty());
}

} // namespace
} // namespace codewheel
