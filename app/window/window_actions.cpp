// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/window_actions.h"

#include "app/window/alarm_stop.h"
#include "encoder/refusal_text.h"
#include "widgets/look/appearance.h"
#include "widgets/look/icons.h"
#include "widgets/models/shown_encoder.h"

#include <QAction>
#include <QActionGroup>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>
#include <QUndoStack>

namespace codewheel {
namespace {

QAction *checkable(QAction *action)
{
    action->setCheckable(true);
    return action;
}

QAction *choice(QActionGroup *group, const QString &text, const QVariant &data, const QString &toolTip)
{
    QAction *action = checkable(new QAction(text, group));
    action->setData(data);
    action->setToolTip(toolTip);
    return action;
}

QAction *described(QAction *action, const QKeySequence &key, const QString &what)
{
    action->setShortcut(key);
    action->setStatusTip(what);
    action->setToolTip(
        key.isEmpty() ? what : QStringLiteral("%1 (%2)").arg(what, key.toString(QKeySequence::NativeText)));
    return action;
}

} // namespace

WindowActions::WindowActions(QMainWindow &window, QUndoStack &undoStack)
    : QObject(&window)
    , m_window(window)
{
    makeFileMenu();
    makeEditMenu(undoStack);
    makeBusMenu();
    makeDeviceMenu();
    makeViewMenu();
    makeHelpMenu();
    makeToolBar();
}

void WindowActions::makeFileMenu()
{
    QMenu *menu = m_window.menuBar()->addMenu(tr("&File"));
    newProject = described(menu->addAction(tr("&New")), QKeySequence::New, tr("Begins an empty project"));
    openProject = described(menu->addAction(lineIcon(Icon::open), tr("&Open...")), QKeySequence::Open,
                            tr("Opens a project"));
    recentFiles = menu->addMenu(tr("&Recent files"));
    recentFiles->setToolTipsVisible(true);
    saveProject = described(menu->addAction(lineIcon(Icon::save), tr("&Save")), QKeySequence::Save,
                            tr("Saves the project"));
    saveProjectAs = described(menu->addAction(tr("Save &as...")), Qt::CTRL | Qt::SHIFT | Qt::Key_S,
                              tr("Saves the project in another file"));
    projectPage = described(menu->addAction(lineIcon(Icon::information), tr("&Project...")),
                            Qt::SHIFT | Qt::Key_F4, tr("Title, note and link of the project"));
    menu->addSeparator();
    exportReport =
        described(menu->addAction(lineIcon(Icon::exportData), tr("&Commissioning report...")), {},
                  tr("Saves the commissioning report of the project as a PDF or a web page; sends nothing"));
    exportTrace = described(menu->addAction(lineIcon(Icon::exportData), tr("Export handshake &trace...")), {},
                            tr("Saves the handshake trace as a CSV file"));
    exportMessages = described(menu->addAction(lineIcon(Icon::exportData), tr("Export &messages...")), {},
                               tr("Saves the messages as a CSV file"));
    menu->addSeparator();
    quit = described(menu->addAction(tr("&Quit")), QKeySequence::Quit, tr("Ends the program"));
}

// What the next step would be stands behind the word.
void WindowActions::makeEditMenu(QUndoStack &undoStack)
{
    QMenu *menu = m_window.menuBar()->addMenu(tr("&Edit"));
    undo = undoStack.createUndoAction(this, tr("&Undo"));
    redo = undoStack.createRedoAction(this, tr("&Redo"));
    menu->addAction(described(undo, QKeySequence::Undo, tr("Takes back the last change of the project")));
    menu->addAction(described(redo, QKeySequence::Redo, tr("Does again what was taken back")));
    undo->setIcon(lineIcon(Icon::turnLeft));
    redo->setIcon(lineIcon(Icon::turnRight));
    menu->addSeparator();
    structureEditor = described(menu->addAction(lineIcon(Icon::ring), tr("&Bus structure")), Qt::Key_F4,
                                tr("Edits the planned bus"));
    compare = described(menu->addAction(lineIcon(Icon::compare), tr("&Compare with the bus")), Qt::Key_F9,
                        tr("Shows what is configured for the chosen bus beside what is connected"));
}

void WindowActions::makeBusMenu()
{
    QMenu *menu = m_window.menuBar()->addMenu(tr("&Bus"));
    connectBus = described(menu->addAction(lineIcon(Icon::ring), tr("&Connect")), Qt::CTRL | Qt::Key_F5,
                           tr("Connects to the ring; nothing is sent"));
    disconnectBus = described(menu->addAction(lineIcon(Icon::cancel), tr("&Disconnect")),
                              Qt::CTRL | Qt::SHIFT | Qt::Key_F5, tr("Leaves the ring: work goes on offline"));
    readIn = described(menu->addAction(lineIcon(Icon::read), tr("&Read in the ring")),
                       Qt::CTRL | Qt::SHIFT | Qt::Key_R,
                       tr("The master finds the devices of the ring anew; data cycles stop meanwhile. "
                          "Needs Operate."));
    menu->addSeparator();
    auto *mode = new QActionGroup(this);
    watch = described(choice(mode, tr("&Watch"), {}, {}), Qt::CTRL | Qt::Key_W, tr("Watch: nothing is sent"));
    watch->setIcon(lineIcon(Icon::watch));
    operate = described(choice(mode, tr("&Operate"), {}, {}), Qt::CTRL | Qt::SHIFT | Qt::Key_W,
                        tr("Operate: writing is allowed"));
    operate->setIcon(lineIcon(Icon::operate));
    menu->addActions(mode->actions());
    menu->addSeparator();
    start = described(menu->addAction(lineIcon(Icon::start), tr("&Start")), Qt::Key_F5,
                      tr("Starts the bus: data cycles run"));
    stop = described(menu->addAction(lineIcon(Icon::stop), tr("S&top")), Qt::SHIFT | Qt::Key_F5,
                     tr("Stops the bus: no more data cycles"));
    menu->addSeparator();
    confirmDiagnostics =
        described(menu->addAction(lineIcon(Icon::ok), tr("&Confirm diagnostics")), Qt::CTRL | Qt::Key_F9,
                  tr("Confirms peripheral faults; one whose cause is still there comes back. Needs "
                     "Operate."));
    switchSegment = described(
        menu->addAction(lineIcon(Icon::power), tr("Switch se&gment off or on")), Qt::SHIFT | Qt::Key_F9,
        tr("Takes the segment of the chosen device, and what is behind it, out of the data "
           "cycles, after asking, or puts it back. Needs Operate."));
    menu->addSeparator();
    transfer = described(menu->addAction(lineIcon(Icon::parameters), tr("T&ransfer")), Qt::CTRL | Qt::Key_T,
                         tr("Values of several encoders: written from the project, stored in it, given from "
                            "one to others"));
    makeLineMenu(*menu);
    menu->addSeparator();
    alarmStop =
        described(menu->addAction(lineIcon(Icon::alarmStop), tr("&ALARM STOP")), alarmStopKey(), QString());
    showAlarmStop({});
}

void WindowActions::showAlarmStop(const QStringList &buses)
{
    const auto count = static_cast<int>(buses.size());
    const QString text = count == 0   ? tr("&ALARM STOP")
                         : count == 1 ? tr("&ALARM STOP %1", "name of a bus").arg(buses.front())
                                      : tr("&ALARM STOP %n buses", nullptr, count);
    if (alarmStop->text() != text)
        alarmStop->setText(text);
    described(alarmStop, alarmStopKey(),
              tr("Sets all OUT words of a ring to 0 and ends what is on its way on a line, at once: %1")
                  .arg(buses.join(QStringLiteral(", "))));
}

void WindowActions::makeLineMenu(QMenu &busMenu)
{
    lineMenu = busMenu.addMenu(lineIcon(Icon::ring), tr("Serial &line"));
    lineMenu->setToolTipsVisible(true);
    lineSettings = described(lineMenu->addAction(lineIcon(Icon::parameters), tr("&Port and settings...")),
                             Qt::SHIFT | Qt::Key_F6, tr("Connects a serial port; nothing is written"));
    lineSearch =
        described(lineMenu->addAction(lineIcon(Icon::search), tr("&Search for encoders...")),
                  Qt::SHIFT | Qt::Key_F7, tr("Asks one address after the other; nothing is written"));
    lineTerminal =
        described(lineMenu->addAction(lineIcon(Icon::trace), tr("&Terminal")), Qt::SHIFT | Qt::Key_F8,
                  tr("Shows what passes on the line, and sends what you type"));
    linePanel = described(lineMenu->addAction(lineIcon(Icon::information), tr("&Figures of the line")),
                          Qt::CTRL | Qt::Key_F6, tr("Port, state, answers and time-outs of the line"));
    lineSettings->setObjectName(QStringLiteral("lineSettings"));
    lineSearch->setObjectName(QStringLiteral("lineSearch"));
    lineTerminal->setObjectName(QStringLiteral("lineTerminal"));
    lineMenu->addSeparator();
    lineTraining = described(lineMenu->addAction(lineIcon(Icon::training), tr("T&raining line")), {},
                             tr("Three simulated encoders, in place of a port"));
    disconnectLine = described(lineMenu->addAction(lineIcon(Icon::cancel), tr("&Disconnect the line")),
                               Qt::CTRL | Qt::SHIFT | Qt::Key_F6, tr("Closes the serial line"));
}

void WindowActions::makeDeviceMenu()
{
    deviceMenu = m_window.menuBar()->addMenu(tr("&Device"));
    deviceMenu->setToolTipsVisible(true); // they say why something is not to be had
    const auto open = [this](const QString &text, const QKeySequence &key, const QString &what) {
        return described(deviceMenu->addAction(lineIcon(Icon::monitor), text), key, what);
    };
    openIn32 = open(tr("Monitor &IN 32"), Qt::CTRL | Qt::Key_1, tr("Opens a monitor of the 32-bit IN word"));
    openOut32 =
        open(tr("Monitor &OUT 32"), Qt::CTRL | Qt::Key_2, tr("Opens a monitor of the 32-bit OUT word"));
    openIn16 = open(tr("Monitor IN &16"), Qt::CTRL | Qt::Key_3, tr("Opens a monitor of a 16-bit IN word"));
    deviceMenu->addSeparator();
    wizard = deviceMenu->addAction(lineIcon(Icon::wizard), tr("Parameter &wizard"));
    wizard->setShortcut(Qt::Key_F6);
    cams = deviceMenu->addAction(lineIcon(Icon::cams), tr("&Cams"));
    cams->setShortcut(Qt::Key_F8);
    replaceEncoder = deviceMenu->addAction(lineIcon(Icon::encoder), tr("&Replace encoder"));
    replaceEncoder->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_X);
    restoreValues = deviceMenu->addAction(lineIcon(Icon::refresh), tr("Restore &values from before..."));
    restoreValues->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_T);
    deviceMenu->addSeparator();
    zeroOut = deviceMenu->addAction(lineIcon(Icon::write), tr("Set OUT to &00000000"));
    zeroOut->setShortcut(Qt::CTRL | Qt::Key_0);
    swapWarningBytes = deviceMenu->addAction(tr("&Swap warning bytes"));
    swapWarningBytes->setCheckable(true);
    removeFromLine = deviceMenu->addAction(lineIcon(Icon::remove), tr("Remove from the serial &line"));
    showChosen({});
}

void WindowActions::showChosen(const ShownEncoder &encoder)
{
    const auto why = [&](RefusalId id) {
        return refusalText({RefusalKind::notSupported, id, {encoder.device().fullName()}});
    };
    const bool isThere = encoder.isThere();
    const bool isOnlyPlanned = isThere && encoder.session() == nullptr;
    const QString offline = tr("Not connected: nothing can be sent.");
    const bool canBeSetUp = !isThere || encoder.can().writes;
    described(wizard, wizard->shortcut(),
              !canBeSetUp     ? why(RefusalId::writingNotSupported)
              : isOnlyPlanned ? offline
                              : tr("Sets up the chosen encoder step by step"));
    wizard->setEnabled(!isOnlyPlanned);
    const bool hasCams = isThere && encoder.can().cams;
    described(cams, cams->shortcut(),
              !isThere        ? tr("No encoder is chosen.")
              : !hasCams      ? why(RefusalId::camsNotSupported)
              : isOnlyPlanned ? tr("Edits the cam programs planned for the chosen encoder")
                              : tr("Edits, reads and writes the cam programs of the chosen encoder"));
    cams->setEnabled(hasCams);
    const bool hasOut = !isThere || encoder.device().outWords > 0;
    described(zeroOut, zeroOut->shortcut(),
              !hasOut         ? why(RefusalId::sendingNotSupported)
              : isOnlyPlanned ? offline
                              : tr("Sends 00000000 to the chosen device: normal running"));
    zeroOut->setEnabled(hasOut && !isOnlyPlanned);
    const bool isOnLine = isThere && encoder.place().isOnLine();
    const auto explained = valueOptionsOf(encoder.session());
    described(swapWarningBytes, Qt::CTRL | Qt::SHIFT | Qt::Key_F8,
              isOnLine ? tr("For an encoder that sends the low byte of its warnings first; nothing is sent")
                       : tr("For encoders on the serial line"));
    swapWarningBytes->setEnabled(isOnLine);
    swapWarningBytes->setChecked(explained && explained->swapsWarningBytes);
    described(removeFromLine, Qt::CTRL | Qt::SHIFT | Qt::Key_F7,
              isOnLine ? tr("The encoder is not asked any more; what it has stays as it is")
                       : tr("For encoders on the serial line"));
    removeFromLine->setEnabled(isOnLine);
}

void WindowActions::makeViewMenu()
{
    QMenu *menu = m_window.menuBar()->addMenu(tr("&View"));
    monitors = described(menu->addAction(lineIcon(Icon::monitor), tr("&Monitors")), Qt::Key_F7,
                         tr("Shows the monitors"));
    menu->addSeparator();
    docks = menu->addMenu(tr("&Panels"));
    defaultLayout =
        described(menu->addAction(tr("&Default layout")), {}, tr("Puts all panels back to their places"));
    menu->addSeparator();

    QMenu *schemes = menu->addMenu(tr("&Appearance"));
    scheme = new QActionGroup(this);
    choice(scheme, tr("&System"), static_cast<int>(Scheme::system), tr("As light or dark as the desktop"));
    choice(scheme, tr("&Light"), static_cast<int>(Scheme::light), tr("Dark on light"));
    choice(scheme, tr("&Dark"), static_cast<int>(Scheme::dark), tr("Light on dark"));
    schemes->addActions(scheme->actions());
    largeControls = described(checkable(menu->addAction(tr("Large &controls"))), Qt::CTRL | Qt::Key_L,
                              tr("Larger bits and buttons, for gloves"));
    lessMotion = described(checkable(menu->addAction(tr("Less m&otion"))), {},
                           tr("Nothing on the screen is animated"));

    QMenu *languages = menu->addMenu(tr("Lan&guage"));
    language = new QActionGroup(this);
    choice(language, tr("S&ystem"), QString(), tr("The language of the desktop"));
    // A language is called by its own name, whatever the language of the window.
    choice(language, QStringLiteral("&English"), QStringLiteral("en"), QStringLiteral("English"));
    choice(language, QStringLiteral("&Deutsch"), QStringLiteral("de"), QStringLiteral("Deutsch"));
    languages->addActions(language->actions());
}

void WindowActions::makeHelpMenu()
{
    QMenu *menu = m_window.menuBar()->addMenu(tr("&Help"));
    keys = described(menu->addAction(tr("&Keys")), QKeySequence::HelpContents,
                     tr("Lists the keys of the window"));
    about = described(menu->addAction(lineIcon(Icon::information), tr("&About Codewheel")), {},
                      tr("Version and licence"));
}

void WindowActions::makeToolBar()
{
    QToolBar *bar = m_window.addToolBar(tr("Bus"));
    bar->setObjectName(QStringLiteral("busToolBar"));
    bar->setMovable(false);
    bar->setContextMenuPolicy(
        Qt::PreventContextMenu); // it cannot be hidden: ALARM STOP is always one click away
    bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    bar->addAction(watch);
    bar->addAction(operate);
    bar->addSeparator();
    bar->addAction(start);
    bar->addAction(stop);
    bar->addSeparator();
    bar->addAction(wizard);
    bar->addAction(cams);
    bar->addAction(lineTerminal);
    auto *space = new QWidget(bar);
    space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar->addWidget(space);
    bar->addWidget(makeAlarmStopButton(alarmStop, bar));
    for (QAction *action : bar->actions())
        if (QWidget *button = bar->widgetForAction(action); button != nullptr && !action->isSeparator())
            button->setFocusPolicy(Qt::TabFocus);
    space->setFocusPolicy(Qt::NoFocus);
}

} // namespace codewheel
