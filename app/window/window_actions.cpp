// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/window_actions.h"

#include "app/window/buses/alarm_stop.h"
#include "app/window/buses/mode_switch.h"
#include "app/window/look/described_action.h"
#include "app/window/look/tool_bar_fit.h"
#include "bus/word_channel.h"
#include "vocabulary/refusal_text.h"
#include "widgets/look/appearance.h"
#include "widgets/look/icons.h"
#include "widgets/look/label_text.h"
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

QAction *choice(QActionGroup *group, const QString &text, const QVariant &data, const QString &toolTip)
{
    QAction *action = checkable(new QAction(text, group));
    action->setData(data);
    action->setToolTip(toolTip);
    return action;
}

QString nothingSent()
{
    return refusalText({RefusalKind::notSupported, RefusalId::onlyRecorded, {}});
}

QString offlineText()
{
    return WindowActions::tr("Not connected: nothing can be sent.");
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

// Its tooltips say why something is unavailable.
QMenu *WindowActions::addMenu(const QString &title)
{
    QMenu *menu = m_window.menuBar()->addMenu(title);
    menu->setToolTipsVisible(true);
    return menu;
}

void WindowActions::makeFileMenu()
{
    QMenu *menu = addMenu(tr("&File"));
    newProject = described(menu->addAction(tr("&New")), QKeySequence::New, tr("Starts an empty project"));
    openProject = described(menu->addAction(lineIcon(Icon::open), tr("&Open…")), QKeySequence::Open,
                            tr("Opens a project"));
    recentFiles = menu->addMenu(tr("&Recent files"));
    recentFiles->setToolTipsVisible(true);
    saveProject = described(menu->addAction(lineIcon(Icon::save), tr("&Save")), QKeySequence::Save,
                            tr("Saves the project"));
    saveProjectAs = described(menu->addAction(tr("Save &as…")), Qt::CTRL | Qt::SHIFT | Qt::Key_S,
                              tr("Saves the project in another file"));
    projectPage = described(menu->addAction(lineIcon(Icon::information), tr("&Project…")),
                            Qt::SHIFT | Qt::Key_F4, tr("Title, note and link of the project"));
    menu->addSeparator();
    record = described(menu->addAction(lineIcon(Icon::record), tr("Recor&d…")), Qt::SHIFT | Qt::Key_F11,
                       tr("Records what encoders show to a file, or shows the recording that runs; sends "
                          "nothing"));
    record->setIconText(tr("Record", "on a button"));
    openRecording = described(
        menu->addAction(lineIcon(Icon::open), tr("Open recordin&g…")), Qt::CTRL | Qt::ALT | Qt::Key_O,
        tr("Shows a recording in monitor, dial and trace as if it were a bus; sends nothing"));
    closeRecording = described(menu->addAction(tr("C&lose recording")), Qt::CTRL | Qt::ALT | Qt::Key_W,
                               tr("Closes the recording that is chosen in the bus structure"));
    menu->addSeparator();
    exportReport = described(menu->addAction(lineIcon(Icon::exportData), tr("&Commissioning report…")), {},
                             tr("Shows the commissioning report of the project, and saves it as a PDF or a "
                                "web page; sends nothing"));
    print = described(
        menu->addAction(lineIcon(Icon::write), tr("Pr&int…")), QKeySequence::Print,
        tr("Prints the table or the picture that has the focus, or else the commissioning report, after a "
           "preview"));
    exportTrace = menu->addAction(lineIcon(Icon::exportData), tr("Export handshake &trace…"));
    showTrace(false);
    exportMessages = described(menu->addAction(lineIcon(Icon::exportData), tr("Export &messages…")), {},
                               tr("Saves the messages as a CSV file"));
    menu->addSeparator();
    quit = described(menu->addAction(tr("&Quit")), QKeySequence::Quit, tr("Quits the program"));
}

// The name of the next step follows the word.
void WindowActions::makeEditMenu(QUndoStack &undoStack)
{
    QMenu *menu = addMenu(tr("&Edit"));
    undo = undoStack.createUndoAction(this, tr("&Undo"));
    redo = undoStack.createRedoAction(this, tr("&Redo"));
    menu->addAction(described(undo, QKeySequence::Undo, tr("Undoes the last change to the project")));
    menu->addAction(described(redo, QKeySequence::Redo, tr("Redoes what was undone")));
    undo->setIcon(lineIcon(Icon::turnLeft));
    redo->setIcon(lineIcon(Icon::turnRight));
    menu->addSeparator();
    structureEditor = described(menu->addAction(lineIcon(Icon::ring), tr("&Bus structure")), Qt::Key_F4,
                                tr("Edits the planned bus"));
    compare = described(menu->addAction(lineIcon(Icon::compare), tr("&Compare with the bus")), Qt::Key_F9,
                        tr("Shows what is configured for the chosen bus beside what is connected"));
    menu->addSeparator();
    settings = described(menu->addAction(lineIcon(Icon::operate), tr("&Settings…")), Qt::CTRL | Qt::Key_Comma,
                         tr("Language, appearance, numbers, EEPROM warnings, and where files are kept"));
    settings->setMenuRole(QAction::PreferencesRole);
}

void WindowActions::makeBusMenu()
{
    QMenu *menu = addMenu(tr("&Bus"));
    const auto section = [this, menu](Section which) { m_sections[which] = {menu, menu->addSeparator()}; };
    findEncoders = described(
        menu->addAction(lineIcon(Icon::search), tr("Wh&o is there?")), Qt::CTRL | Qt::Key_F3,
        tr("Looks for encoders and gateways at the ports of this computer and at a host; listens first"));
    foundBy(findEncoders, tr("find, search, scan, baud rate, baudrate, address"));
    section(Section::connections);
    auto *mode = new QActionGroup(this);
    watch = described(choice(mode, tr("&Watch"), {}, {}), Qt::CTRL | Qt::Key_F11,
                      tr("Watch: nothing is written"));
    watch->setIcon(lineIcon(Icon::watch));
    operate = described(choice(mode, tr("&Operate"), {}, {}), Qt::CTRL | Qt::SHIFT | Qt::Key_F11,
                        tr("Operate: writing is allowed"));
    operate->setIcon(lineIcon(Icon::operate));
    menu->addActions(mode->actions());
    menu->addSeparator();
    start = described(menu->addAction(lineIcon(Icon::start), tr("&Start")), Qt::Key_F5,
                      tr("Starts the chosen bus: data is exchanged from then on"));
    stop = described(menu->addAction(lineIcon(Icon::stop), tr("S&top")), Qt::SHIFT | Qt::Key_F5,
                     tr("Stops the chosen bus: no more data is exchanged"));
    menu->addSeparator();
    section(Section::services);
    transfer = described(menu->addAction(lineIcon(Icon::parameters), tr("T&ransfer")), Qt::CTRL | Qt::Key_T,
                         tr("Values of several encoders: written from the project, stored in it, given from "
                            "one to others"));
    section(Section::kinds);
    alarmStop =
        described(menu->addAction(lineIcon(Icon::alarmStop), tr("&ALARM STOP")), alarmStopKey(), QString());
    showAlarmStop({}, {});
}

void WindowActions::tellMode(const QString &bus)
{
    for (QAction *action : {watch, operate})
        tellBus(action, bus);
    m_mode->tellBus(bus);
}

// A long name must not push the button out of the window; the tooltip has it in full.
QString WindowActions::shortName(const QString &bus)
{
    static constexpr qsizetype longest = 24;
    return bus.size() <= longest ? bus : bus.left(longest - 1) + u'\u2026';
}

void WindowActions::showAlarmStop(const QStringList &buses, const QStringList &effects)
{
    const auto count = static_cast<int>(buses.size());
    const QString text = count == 0   ? tr("&ALARM STOP")
                         : count == 1 ? tr("&ALARM STOP %1", "name of a bus").arg(shortName(buses.front()))
                                      : tr("&ALARM STOP %n buses", nullptr, count);
    if (alarmStop->text() != text)
        alarmStop->setText(text);
    described(alarmStop, alarmStopKey(),
              effects.isEmpty() ? tr("No bus is connected.")
                                : tr("At once: %1").arg(effects.join(QStringLiteral("; "))));
}

void WindowActions::makeDeviceMenu()
{
    deviceMenu = addMenu(tr("&Device"));
    const auto open = [this](Icon icon, const QString &text, const QKeySequence &key, const QString &what) {
        return described(deviceMenu->addAction(lineIcon(icon), text), key, what);
    };
    openMonitor =
        open(Icon::monitor, tr("M&onitor"), Qt::CTRL | Qt::Key_1, tr("Shows the words of the chosen device"));
    pinMonitor = open(Icon::pin, tr("&Pin monitor"), Qt::CTRL | Qt::Key_2,
                      tr("Keeps the monitor of the chosen device open when another one is chosen"));
    pinDial = open(Icon::pin, tr("Pin &dial"), Qt::CTRL | Qt::Key_3,
                   tr("Keeps the dial of the chosen encoder when another one is chosen"));
    pinDial->setCheckable(true);
    pinDial->setEnabled(false);
    showInTrend = deviceMenu->addAction(lineIcon(Icon::trend), tr("Show in &trend"));
    showInTrend->setShortcut(Qt::CTRL | Qt::Key_4);
    whyNoData =
        open(Icon::question, tr("W&hy is there no data?"), Qt::Key_F12,
             tr("Shows what is expected of the chosen device or bus beside what came, and what to do; sends "
                "nothing"));
    foundBy(whyNoData, tr("no answer, silent, no position, error"));
    deviceMenu->addSeparator();
    wizard = deviceMenu->addAction(lineIcon(Icon::wizard), tr("Parameter &wizard"));
    wizard->setShortcut(Qt::Key_F6);
    foundBy(wizard, tr("set the position, preset, zero point, scaling, parameterization"));
    cams = deviceMenu->addAction(lineIcon(Icon::cams), tr("&Cams"));
    cams->setShortcut(Qt::Key_F8);
    replaceEncoder = deviceMenu->addAction(lineIcon(Icon::encoder), tr("&Replace encoder"));
    replaceEncoder->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_X);
    restoreValues = deviceMenu->addAction(lineIcon(Icon::refresh), tr("Restore earlier &values…"));
    restoreValues->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_T);
    deviceMenu->addSeparator();
    zeroOut = deviceMenu->addAction(lineIcon(Icon::write), tr("Set OUT to &00000000"));
    zeroOut->setShortcut(Qt::CTRL | Qt::Key_0);
    foundBy(zeroOut, tr("zero, normal running, run"));
    m_sections[Section::device] = {deviceMenu, nullptr};
    showChosen({});
    showWords({}, nullptr, false);
}

void WindowActions::showChosen(const ShownEncoder &encoder)
{
    const auto why = [&](RefusalCode id) {
        return refusalText({RefusalKind::notSupported, id, {encoder.device().fullName()}});
    };
    const bool isThere = encoder.isThere();
    const bool isOnlyPlanned = isThere && encoder.session() == nullptr;
    const bool isRecorded = !isOnlyPlanned && isThere && encoder.session()->freshness().isOfRecording();
    const bool canBeSetUp = !isThere || encoder.can().writes;
    described(wizard, wizard->shortcut(),
              isRecorded      ? nothingSent()
              : !canBeSetUp   ? why(RefusalId::writingNotSupported)
              : isOnlyPlanned ? offlineText()
                              : tr("Sets up the chosen encoder step by step"));
    wizard->setEnabled(!isOnlyPlanned && !isRecorded);
    described(showInTrend, showInTrend->shortcut(),
              encoder.session() != nullptr
                  ? tr("Adds the position of the chosen encoder to the trend, and shows that")
                  : tr("No connected encoder is chosen."));
    showInTrend->setEnabled(encoder.session() != nullptr);
    const bool hasCams = isThere && encoder.can().cams;
    described(cams, cams->shortcut(),
              !isThere        ? tr("No encoder is chosen.")
              : isRecorded    ? nothingSent()
              : !hasCams      ? why(RefusalId::camsNotSupported)
              : isOnlyPlanned ? tr("Edits the cam programs planned for the chosen encoder")
                              : tr("Edits, reads and writes the cam programs of the chosen encoder"));
    cams->setEnabled(hasCams);
}

void WindowActions::showWords(const ShownEncoder &encoder, const WordChannel *words, bool isOpen)
{
    const bool isRecorded = words != nullptr && words->freshness().isOfRecording();
    const bool hasOut = words != nullptr && words->outWords() > 0 && !isRecorded;
    const bool lacksOut = encoder.isThere() && encoder.device().outWords == 0;
    described(zeroOut, zeroOut->shortcut(),
              isRecorded          ? nothingSent()
              : hasOut            ? tr("Sends 00000000 to the chosen device: normal running")
              : lacksOut          ? refusalText({RefusalKind::notSupported,
                                                 RefusalId::sendingNotSupported,
                                                 {encoder.device().fullName()}})
              : encoder.isThere() ? offlineText()
                                  : tr("No connected device with an OUT word is chosen."));
    zeroOut->setEnabled(hasOut);
    for (QAction *monitor : {openMonitor, pinMonitor})
        monitor->setEnabled(isOpen);
}

void WindowActions::showTrace(bool isThere)
{
    described(exportTrace, {},
              isThere ? tr("Saves the handshake trace as a CSV file")
                      : tr("No connected encoder with a handshake trace is chosen."));
    exportTrace->setEnabled(isThere);
}

void WindowActions::makeViewMenu()
{
    QMenu *menu = addMenu(tr("&View"));
    monitors = described(menu->addAction(lineIcon(Icon::monitor), tr("&Monitors")), Qt::Key_F7,
                         tr("Shows the monitors; you can return to an open page"));
    trend = described(menu->addAction(lineIcon(Icon::trend), tr("&Trend")), Qt::Key_F11,
                      tr("Draws what encoders show as curves over time; sends nothing"));
    foundBy(trend, tr("curves, CSV, export"));
    closePage = described(menu->addAction(lineIcon(Icon::cancel), tr("Close pag&e")), Qt::CTRL | Qt::Key_W,
                          tr("Closes the page that is open, and shows the monitors"));
    closePage->setEnabled(false);
    menu->addSeparator();
    docks = menu->addMenu(tr("&Panels"));
    foldBottom = described(checkable(menu->addAction(tr("&Fold bottom panels"))), Qt::CTRL | Qt::Key_F7,
                           tr("Folds the panels at the bottom to their tabs: monitors get their height"));
    defaultLayout =
        described(menu->addAction(tr("&Default layout")), {}, tr("Puts all panels back in their places"));
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
    // A language is named in itself, whatever the language of the window.
    foundBy(choice(language, QStringLiteral("&English"), QStringLiteral("en"), QStringLiteral("English")),
            tr("English, language"));
    foundBy(choice(language, QStringLiteral("&Deutsch"), QStringLiteral("de"), QStringLiteral("Deutsch")),
            tr("German, language"));
    languages->addActions(language->actions());
}

void WindowActions::makeHelpMenu()
{
    QMenu *menu = addMenu(tr("&Help"));
    help =
        described(menu->addAction(lineIcon(Icon::information), tr("&Help on this")),
                  QKeySequence::HelpContents, tr("Opens the manual at the section about what has the focus"));
    manual = described(menu->addAction(tr("&Manual")), {}, tr("Opens the manual at its first page"));
    keys = described(menu->addAction(tr("&Keys")), Qt::CTRL | Qt::Key_F1, tr("Lists the keys of the window"));
    findCommand =
        described(menu->addAction(lineIcon(Icon::search), tr("&Find a command…")), Qt::CTRL | Qt::Key_K,
                  tr("Finds actions, devices, parameters, messages and pages of the manual by words"));
    findCommand->setEnabled(false);
    menu->addSeparator();
    collectSupport = described(
        menu->addAction(lineIcon(Icon::save), tr("&Collect for support…")), {},
        tr("Saves what is needed to look into a problem as one file, after it was shown; sends nothing"));
    about = described(menu->addAction(lineIcon(Icon::information), tr("&About Codewheel")), {},
                      tr("Version and licence"));
}

// Lets the buttons of a tool bar take the focus, but only by keyboard.
void WindowActions::showFocusOf(QToolBar &bar)
{
    for (QAction *action : bar.actions())
        if (auto *button = qobject_cast<QToolButton *>(bar.widgetForAction(action)))
            button->setFocusPolicy(Qt::TabFocus);
}

void WindowActions::insert(Section where, const QList<QAction *> &actions)
{
    const auto &[menu, before] = m_sections.at(where);
    for (QAction *action : actions) {
        if (action->parent() == nullptr)
            action->setParent(menu);
        menu->insertAction(before, action);
    }
    if (auto *bar = qobject_cast<QToolBar *>(menu))
        showFocusOf(*bar);
}

QWidget *WindowActions::menuParent() const
{
    return &m_window;
}

QList<QAction *> WindowActions::pages() const
{
    return {monitors, trend, wizard, cams, structureEditor, compare, transfer, replaceEncoder, projectPage};
}

// Buttons have room for a single word.
void WindowActions::makePages()
{
    wizard->setIconText(tr("Wizard", "on a button"));
    structureEditor->setIconText(tr("Structure", "on a button"));
    compare->setIconText(tr("Compare", "on a button"));
    transfer->setIconText(tr("Transfer", "on a button"));
    replaceEncoder->setIconText(tr("Replace", "on a button"));
}

void WindowActions::makeToolBar()
{
    QToolBar *bar = m_window.addToolBar(tr("Bus"));
    bar->setObjectName(QStringLiteral("busToolBar"));
    bar->setMovable(false);
    bar->setContextMenuPolicy(
        Qt::PreventContextMenu); // it must not be hidden: ALARM STOP is always one click away
    bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    makePages();
    for (QAction *page : pages())
        if (page != projectPage) { // which is in the File menu
            bar->addAction(page);
            bar->widgetForAction(page)->setAccessibleName(plainLabel(page->text()));
        }
    bar->addSeparator();
    bar->addActions({start, stop});
    auto *space = new QWidget(bar);
    space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    m_sections[Section::toolBar] = {bar, bar->addWidget(space)};
    m_mode = new ModeSwitch(*watch, *operate, bar);
    bar->addWidget(m_mode);
    QWidget *alarm = makeAlarmStopButton(alarmStop, bar);
    bar->addWidget(alarm);
    new ToolBarFit(*bar, *m_mode, *alarm);
    showFocusOf(*bar);
    space->setFocusPolicy(Qt::NoFocus);
}

} // namespace codewheel
