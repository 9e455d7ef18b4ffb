// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/screenshots/kinds/canopen/canopen_pictures.h"

#include "app/screenshots/scene.h"
#include "app/window/kinds/canopen/canopen_at_work.h"
#include "app/window/window_actions.h"
#include "kinds/canopen/protocol/nmt.h"
#include "widgets/connect/connect_page.h"
#include "widgets/kinds/canopen/can_search_page.h"
#include "widgets/kinds/canopen/can_settings_form.h"
#include "widgets/kinds/canopen/dictionary/dictionary_view.h"
#include "widgets/kinds/canopen/setup/node_setup_page.h"
#include "widgets/kinds/canopen/setup/node_setup_view.h"
#include "widgets/structure/structure_view.h"
#include "widgets/why/why_page.h"

#include <QAction>
#include <QDockWidget>
#include <QSpinBox>

namespace codewheel {
namespace {

using namespace scene;

constexpr QSize tallBus(1280, 1150);
constexpr QSize wideBus(1920, 1150);
constexpr int nodeSingleTurn = 5; // the nodes of the training bus
constexpr int nodeMultiTurn = 6;
constexpr int nodeLinear = 7;
constexpr int untilHeard = 1'500;     // ms
constexpr int untilAllRead = 5'000;   // ms, all objects
constexpr int untilAllFound = 20'000; // ms
constexpr int untilNumbered = 30'000; // ms

Place placeOf(int node)
{
    return {firstCanBus, CanopenAddress{node}.place()};
}

CanopenSession &connected(TrainingWindow &shown)
{
    auto &bus = *shown.plant().first<CanopenAtWork>();
    if (!bus.isOpen()) {
        shown.window().findChild<QAction *>(QStringLiteral("canTraining"))->trigger();
        shown.advance(untilHeard);
    }
    return *bus.session();
}

void command(TrainingWindow &shown, canopen::NmtCommand command, int node)
{
    connected(shown).send(canopen::NmtRequest{command, node}.frame());
    shown.advance(whileMilliseconds);
}

// Two of its nodes run; one of them is chosen, and read.
void atWork(TrainingWindow &shown)
{
    for (const int node : {nodeSingleTurn, nodeMultiTurn})
        command(shown, canopen::NmtCommand::start, node);
    choose(shown, placeOf(nodeMultiTurn));
    readAll(shown, placeOf(nodeMultiTurn));
    shown.advance(untilAllRead);
}

QWidget *openedDock(TrainingWindow &shown, const char *name)
{
    QDockWidget *its = dock(shown, name);
    its->show();
    its->raise();
    shown.advance(whileMilliseconds);
    return its;
}

// With room for its table.
QWidget *wideDock(TrainingWindow &shown, const char *name)
{
    constexpr int beside = 300; // px
    constexpr int high = 560;
    QWidget *its = openedDock(shown, name);
    shown.window().resizeDocks({dock(shown, "structureDock"), dock(shown, "parametersDock")},
                               {beside, beside}, Qt::Horizontal);
    shown.window().resizeDocks({dock(shown, name)}, {high}, Qt::Vertical);
    shown.advance(whileMilliseconds);
    return its;
}

QWidget *windowWithCan(TrainingWindow &shown)
{
    atWork(shown);
    openedDock(shown, "canTrafficDock");
    openedDock(shown, "canBusDock");
    return &shown.window();
}

// One of them was stopped.
QWidget *nodesAtWork(TrainingWindow &shown)
{
    atWork(shown);
    command(shown, canopen::NmtCommand::stop, nodeLinear);
    choose(shown, placeOf(nodeLinear));
    return openedDock(shown, "canBusDock");
}

QWidget *trafficAtWork(TrainingWindow &shown)
{
    connected(shown);
    openedDock(shown, "canTrafficDock");
    atWork(shown);
    return wideDock(shown, "canTrafficDock");
}

QWidget *objectsAtWork(TrainingWindow &shown)
{
    atWork(shown);
    QWidget *seen = wideDock(shown, "canObjectsDock");
    for (QAction *action : seen->findChildren<QAction *>())
        if (action->text() == DictionaryView::tr("Read all"))
            action->trigger();
    shown.advance(untilAllFound);
    return seen;
}

QWidget *searchOfNodes(TrainingWindow &shown)
{
    connected(shown);
    shown.window().findChild<QAction *>(QStringLiteral("canSearch"))->trigger();
    shown.advance(whileMilliseconds);
    auto *page = shown.window().findChild<CanSearchPage *>();
    click(shown, "canSearch");
    press(*page, CanSearchPage::tr("&Ask now"));
    shown.advance(untilAllFound);
    return page;
}

// The encoder without a number has been found, and got one.
QWidget *numberGiven(TrainingWindow &shown)
{
    connected(shown);
    shown.window().findChild<QAction *>(QStringLiteral("canUnnumbered"))->trigger();
    shown.advance(whileMilliseconds);
    click(shown, "nodeSetupFind");
    shown.advance(untilAllFound);
    auto *page = shown.window().findChild<NodeSetupPage *>();
    page->findChild<QSpinBox *>(QStringLiteral("nodeSetupNumber"))->setValue(9);
    click(shown, "nodeSetupWrite");
    press(*page, NodeSetupView::tr("&Send"));
    shown.advance(untilNumbered);
    return page;
}

QWidget *settingsOfInterface(TrainingWindow &shown)
{
    shown.window().findChild<QAction *>(QStringLiteral("canSettings"))->trigger();
    auto *page = shown.window().findChild<ConnectPage *>(QStringLiteral("canSettings"));
    // Whatever this computer has.
    for (auto *form : page->findChildren<CanSettingsForm *>())
        form->setInterfaces({.rows = {{QStringLiteral("can0"), QStringLiteral("SocketCAN"), {}}}});
    shown.advance(whileMilliseconds);
    return page;
}

QWidget *trainingOfTheBus(TrainingWindow &shown)
{
    connected(shown);
    QWidget *its = openedDock(shown, "trainingDock");
    shown.window().findChild<StructureView *>()->choose(firstCanBus);
    shown.advance(whileMilliseconds);
    return its;
}

QWidget *whyItIsSilent(TrainingWindow &shown)
{
    atWork(shown);
    command(shown, canopen::NmtCommand::stop, nodeMultiTurn);
    shown.window().actions().whyNoData->trigger();
    shown.advance(whileMilliseconds);
    return shown.window().findChild<WhyPage *>();
}

} // namespace

std::vector<Picture> canopenPictures()
{
    return {
        pictureOf("can", windowWithCan),
        pictureOf("can-small", windowWithCan, {1024, 640}),
        pictureOf("can-nodes", nodesAtWork, tallBus),
        pictureOf("can-traffic", trafficAtWork, wideBus),
        pictureOf("can-objects", objectsAtWork, wideBus),
        pictureOf("can-search", searchOfNodes),
        pictureOf("can-number", numberGiven),
        pictureOf("can-training", trainingOfTheBus, tallBus),
        pictureOf("can-settings", settingsOfInterface),
        pictureOf("can-why", whyItIsSilent),
    };
}

} // namespace codewheel
