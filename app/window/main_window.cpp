// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/main_window.h"

#include "app/window/buses/alarm_stop.h"
#include "app/window/buses/bus_views.h"
#include "app/window/buses/device_choice.h"
#include "app/window/buses/leaving.h"
#include "app/window/buses/plant.h"
#include "app/window/buses/transfer_pages.h"
#include "app/window/connect/start.h"
#include "app/window/faults/fault_notice.h"
#include "app/window/files/project_files.h"
#include "app/window/files/project_recovery.h"
#include "app/window/help/context_help.h"
#include "app/window/help/why_in_window.h"
#include "app/window/look/bottom_fold.h"
#include "app/window/look/disabled_key.h"
#include "app/window/look/focus_rules.h"
#include "app/window/look/page_head.h"
#include "app/window/look/page_stack.h"
#include "app/window/look/status_line.h"
#include "app/window/look/window_layouts.h"
#include "app/window/palette/palette_in_window.h"
#include "app/window/recording/recording_in_window.h"
#include "app/window/work_in_window.h"
#include "bus/buses.h"
#include "transfer/last_positions.h"
#include "widgets/cams/cam_editor.h"
#include "widgets/device/device_panel.h"
#include "widgets/dial/dial_pin.h"
#include "widgets/input/input_rules.h"
#include "widgets/look/content_scroll_area.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/messages/message_model.h"
#include "widgets/messages/messages_view.h"
#include "widgets/monitor/monitor_area.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/wanted_values.h"
#include "widgets/project/project_page.h"
#include "widgets/sequence/sequence_view.h"
#include "widgets/structure/structure_view.h"
#include "widgets/structure_editor/structure_editor.h"
#include "widgets/trace/trace_view.h"
#include "widgets/transfer/replace_page.h"
#include "widgets/transfer/transfer_page.h"
#include "widgets/trend/trend_page.h"
#include "widgets/wizard/parameter_wizard.h"

#include <QApplication>
#include <QCloseEvent>
#include <QScreen>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace codewheel {
namespace {

constexpr QSize firstSize(1280, 800);
constexpr QSize frame(4, 40); // the most that desktops draw around a window

} // namespace

MainWindow::MainWindow(WindowSettings &settings, ProjectDocument &project, QWidget *parent)
    : QMainWindow(parent)
    , m_settings(settings)
    , m_project(project)
    , m_actions(*this, project.undoStack())
    , m_alarmStop(new AlarmStopEverywhere(*m_actions.alarmStop, this))
    , m_leaving(new Leaving(*this))
    , m_status(new StatusLine(*statusBar(), this))
    , m_wanted(new WantedValues(project, this))
    , m_notice(new InlineMessage(this))
    , m_pages(new PageStack(this))
    , m_head(new PageHead(*m_pages, *this))
    , m_files(new ProjectFiles(*this, project, settings, m_actions, *m_notice))
{
    setObjectName(QStringLiteral("mainWindow"));
    installInputRules(this);
    new DisabledKey(*this);
    auto *center = new QWidget(this);
    auto *rows = layOut<QVBoxLayout>(center, 0);
    rows->addWidget(m_notice);
    rows->addWidget(m_head);
    rows->addWidget(new ContentScrollArea(m_pages, center), 1); // a panel may be drawn over most of it
    m_pages->setObjectName(QStringLiteral("pages"));
    setCentralWidget(center);
    m_notice->setObjectName(QStringLiteral("notice"));
    setDockNestingEnabled(true);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    connectActions();
    connectViewActions();
    m_help = new ContextHelp(*this, m_actions, m_settings);
    showBusState();
    if (!restoreGeometry(m_settings.geometry()))
        resize(firstSize.boundedTo(screen()->availableSize() - frame));
}

// The views destroy their pages and panels, before the docks go.
MainWindow::~MainWindow()
{
    for (const auto &[bus, views] : std::exchange(m_views, {}))
        delete views;
}

void MainWindow::attach(Plant &plant, MessageModel &messages)
{
    m_plant = &plant;
    m_messageModel = &messages;
    m_buses = &plant.buses();
    m_leaving->setBuses(*m_buses);
    m_leaving->setOtherWork({.underWay =
                                 [this](BusId bus) {
                                     const BusViews *views = viewsOf(bus);
                                     return views != nullptr ? views->underWay() : std::nullopt;
                                 },
                             .breakOff =
                                 [this](BusId bus, const std::function<void(bool)> &then) {
                                     if (BusViews *views = viewsOf(bus))
                                         views->breakOff(then);
                                     else
                                         then(true);
                                 }});
    m_files->setBeforeSaving([&plant](Project project) {
        return withLastPositions(std::move(project), plant.positions(), plant.buses());
    });
    m_files->setEndsForOthers([&plant] {
        QStringList ends;
        for (const BusAtWork *bus : plant.all())
            ends << bus->endsForOthers();
        ends.removeAll(QString());
        return ends.join(u'\n');
    });
    makePages();
    makeDocks(messages);
    m_faults = new FaultNotice(
        plant, [this](BusId bus) { return viewsOf(bus); },
        *static_cast<QVBoxLayout *>(centralWidget()->layout()), this);
    connect(m_faults, &FaultNotice::shown, this, &MainWindow::showFault);
    connect(m_faults, &FaultNotice::changed, this, &MainWindow::showOtherFaults);
    m_structure->setProject(m_project, plant.catalog());
    m_choice = new DeviceChoice(*m_buses, plant.catalog(), m_project, *m_structure, *m_editor, this);
    m_why = new WhyInWindow({plant, m_actions, *m_structure, *m_pages, m_parameters->isInPositionMode(),
                             [this](BusId bus) { return viewsOf(bus); }},
                            this);
    new FocusRules(*m_pages, this);
    connectViews();
    connectProject();
    connectBuses();
    connectRecordings();
    new PaletteInWindow({*this, m_actions, plant, m_project, *m_choice, *m_structure, *m_parameters, messages,
                         *m_messages, m_panels, *m_pages, *m_help, m_settings, [this] { showMonitors(); }});
    if (const auto state = m_settings.monitors())
        m_monitors->restoreState(*state);
    m_dial->restore(m_settings.pinnedDial());
    connect(m_buses, &Buses::changed, this, &MainWindow::showBusState);
    connect(m_buses, &Buses::changed, this, &MainWindow::showStart);
    connect(m_buses, &Buses::changed, m_messages, &MessagesView::showPlaces);
    connect(m_buses, &Buses::changed, m_parameters, &ParameterPanel::showWhose);
    connect(m_head, &PageHead::closed, this, [this] {
        showMonitors();
        const bool isStart = m_pages->currentWidget() == m_start->page(); // which has keys of its own
        (isStart ? m_start->page() : m_structure)->setFocus();
    });
    connect(m_head, &PageHead::opened, m_actions.closePage, &QAction::setEnabled);
    showBusState();
    showStart();
    connect(m_head, &PageHead::roomChanged, this, &MainWindow::foldBottom);
    connect(&m_panels.fold(), &BottomFold::foldedChanged, this, [this](bool folded) {
        m_actions.foldBottom->setChecked(folded);
        m_keepsBottomFolded = m_keepsBottomFolded && folded;
    });
    // Later, when the panels have the heights that are to come back.
    QTimer::singleShot(0, this, &MainWindow::foldBottom);
    if (m_pages->currentWidget() == m_monitors)
        m_structure->setFocus();
    else
        m_pages->currentWidget()->setFocus();
}

// In a narrow window the dial stands behind the parameters, whose first rows say less at first.
void MainWindow::showFirstTime()
{
    for (const BusAtWork *bus : m_plant->all())
        if (const auto turning = bus->turning(); turning && !m_dial->pinned())
            m_dial->pinForNow(*turning);
    m_panels.raise(panel::dial);
}

bool MainWindow::mayGo()
{
    const auto isWriting = [](const auto &of) { return of.second->isWriting(); };
    const bool isNumberWritten = std::ranges::any_of(m_views, isWriting);
    if (!isNumberWritten && (m_transfer == nullptr || !m_transfer->isBusy()))
        return true;
    m_notice->showMessage(Role::attention,
                          isNumberWritten
                              ? tr("The window is made anew once number and rate have been written.")
                              : tr("The window is made anew once the transfer has ended."));
    return false;
}

WorkInWindow MainWindow::takeWork()
{
    WorkInWindow work;
    if (m_plant == nullptr)
        return work;
    ParameterWizard *wizard = m_wizard->ifMade();
    work = {.row = chosen().row,
            .page = m_pages->currentIndex(),
            .kindOfPage = m_pages->currentWidget()->metaObject()->className(),
            .traces = m_trace->takeTraces(),
            .hasCams = m_cams->ifMade() != nullptr,
            .wizard = wizard != nullptr ? wizard->takeUnderWay() : ParameterWizard::UnderWay(),
            .wanted = m_parameters->typed(),
            .typed = typedTexts(*this)};
    for (const auto &[bus, views] : m_views)
        work.ofBuses[bus] = views->takeWork();
    return work;
}

void MainWindow::goOn(WorkInWindow work)
{
    if (m_plant == nullptr)
        return;
    if (work.row)
        m_structure->choose(*work.row);
    m_trace->goOn(std::move(work.traces));
    if (work.hasCams)
        m_cams->page();
    if (work.wizard.encoder)
        m_wizard->page().goOn(work.wizard);
    for (const auto &[bus, its] : work.ofBuses)
        if (BusViews *views = viewsOf(bus))
            views->goOn(its);
    showPageAgain(work.page, work.kindOfPage);
    if (work.wanted)
        m_parameters->goOn(*work.wanted);
    typeAgain(*this, work.typed);
}

// Those that plan something when they are opened plan it anew.
void MainWindow::showPageAgain(int page, const QByteArray &kind)
{
    const QWidget *same = m_pages->widget(page);
    if (kind == TransferPage::staticMetaObject.className())
        m_actions.transfer->trigger();
    else if (kind == ReplacePage::staticMetaObject.className())
        m_actions.replaceEncoder->trigger();
    else if (kind == ParameterWizard::staticMetaObject.className())
        m_pages->setCurrentWidget(&m_wizard->page());
    else if (same != nullptr && same->metaObject()->className() == kind)
        m_pages->setCurrentIndex(page);
}

std::optional<Place> MainWindow::pinnedDial() const
{
    return m_dial != nullptr ? m_dial->pinned() : std::nullopt;
}

void MainWindow::pinDial(Place place)
{
    if (m_dial->pinned() != place)
        m_dial->pinForNow(place);
}

// A notice of its own: the question stands until it is answered.
void MainWindow::askForRecovery(ProjectRecovery &recovery)
{
    auto *question = new InlineMessage(this);
    question->setObjectName(QStringLiteral("recoveryQuestion"));
    static_cast<QVBoxLayout *>(centralWidget()->layout())->insertWidget(0, question);
    recovery.ask(*question, *m_files);
}

void MainWindow::warn(const QString &sentence)
{
    auto *warning = new InlineMessage(this);
    warning->setObjectName(QStringLiteral("warning"));
    static_cast<QVBoxLayout *>(centralWidget()->layout())->insertWidget(0, warning);
    warning->showMessage(Role::attention, sentence);
}

void MainWindow::tell(const Message &message)
{
    m_messageModel->addNow(message);
}

void MainWindow::compare()
{
    for (const auto &[bus, views] : m_views)
        views->compare();
}

// For a device that is only planned, wanted values can be viewed and edited; everything else needs a
// connection.
void MainWindow::showChosen()
{
    const ShownEncoder &encoder = m_choice->encoder();
    EncoderSession *connected = encoder.session();
    m_parameters->setEncoder(encoder);
    const auto offline = connected == nullptr && encoder.isThere() ? m_choice->place() : std::nullopt;
    m_dial->follow(encoder);
    m_trace->setEncoder(connected, offline);
    m_sequence->setEncoder(connected, offline);
    m_status->setEncoder(connected);
    if (ParameterWizard *wizard = m_wizard->ifMade())
        wizard->setEncoder(connected);
    if (CamEditor *cams = m_cams->ifMade())
        cams->setEncoder(encoder);
    m_actions.showChosen(encoder);
    m_actions.showTrace(m_trace->hasRows());
    showWordActions();
    m_transfer->setEncoder(encoder);
    const auto place = m_choice->place();
    m_monitors->follow(place);
    if (place && !m_structure->currentBus())
        chooseBusOf(*place);
    for (const auto &[bus, views] : m_views)
        views->setChosen(place && place->bus == bus ? place : std::nullopt);
    // A device that its bus does not name is shown by its description.
    const bool isNamed = connected != nullptr && m_buses->channel(connected->place()) != nullptr;
    m_device->setPlace(place, encoder.isThere() && !isNamed ? std::optional(encoder.device()) : std::nullopt);
    tellDeviceThatStays();
}

void MainWindow::showFrame()
{
    if (m_plant == nullptr)
        return;
    m_plant->pump();
    for (const auto &[bus, views] : m_views)
        views->showFrame();
    m_faults->showFrame();
    m_why->showFrame();
    if (m_trend->isVisible())
        m_trend->showFrame();
    m_status->showFrame();
}

// Of buses whose state the status line does not show, since another one of their kind is chosen.
void MainWindow::showOtherFaults()
{
    if (m_faults == nullptr)
        return;
    m_status->setOtherFaults(m_faults->inBrief([this](BusId bus) {
        const BusAtWork *its = m_plant->find(bus); // null: removed since the faults were looked at
        return its != nullptr && m_currentOf.value(its->kind()) != bus;
    }));
}

// Shows its place, and the panel with more about it.
void MainWindow::showFault(BusId bus, const Fault &fault)
{
    m_structure->reveal(Place{bus, fault.node});
    if (fault.extent == Fault::Extent::device)
        m_panels.show(panel::device);
    else if (BusViews *views = viewsOf(bus))
        views->open();
}

bool MainWindow::hasJob() const
{
    return m_buses != nullptr && m_buses->hasJob();
}

void MainWindow::showWizard()
{
    if (!m_wizard)
        return;
    ParameterWizard &wizard = m_wizard->page();
    m_pages->setCurrentWidget(&wizard);
    wizard.focusPage();
}

void MainWindow::showMonitors()
{
    if (m_monitors != nullptr)
        m_pages->setCurrentWidget(m_start->pageInsteadOf(m_monitors));
}

void MainWindow::foldBottom()
{
    if (m_head->needsRoom() || m_keepsBottomFolded)
        m_panels.fold().fold();
    else
        m_panels.fold().unfold();
}

// Switches between start page and monitors; any other open page stays.
void MainWindow::showStart()
{
    const QWidget *page = m_pages->currentWidget();
    if (page != m_monitors && page != m_start->page())
        return;
    const QWidget *focused = focusWidget();
    const bool isFree =
        focused == nullptr || m_structure->isAncestorOf(focused) || m_pages->isAncestorOf(focused);
    showMonitors();
    if (isFree && page == m_monitors && m_pages->currentWidget() == m_start->page())
        m_start->page()->setFocus(); // it has keys of its own
}

void MainWindow::showCams()
{
    if (!m_cams)
        return;
    CamEditor &cams = m_cams->page();
    m_pages->setCurrentWidget(&cams);
    cams.setFocus();
}

void MainWindow::showTrend()
{
    if (m_trend == nullptr)
        return;
    m_pages->setCurrentWidget(m_trend);
    m_trend->setFocus();
}

void MainWindow::showInTrend(const Track &track)
{
    showTrend();
    m_trend->showTrack(track);
}

void MainWindow::showStructureEditor()
{
    if (m_editor == nullptr)
        return;
    const auto chosen = currentNumber(); // the page chooses its first device on getting the focus
    m_pages->setCurrentWidget(m_editor);
    m_editor->setFocus();
    if (chosen && chosen->bus == m_chosenBus)
        m_choice->choose(chosen);
}

void MainWindow::showComparison()
{
    if (BusViews *views = viewsOf(m_chosenBus); views != nullptr && views->comparison() != nullptr) {
        m_pages->setCurrentWidget(views->comparison());
        views->comparison()->setFocus();
    }
}

void MainWindow::showProjectPage()
{
    if (m_projectPage == nullptr)
        return;
    m_pages->setCurrentWidget(m_projectPage);
    m_projectPage->setFocus();
}

std::optional<Place> MainWindow::currentNumber() const
{
    return m_choice == nullptr ? std::nullopt : m_choice->place();
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    if (m_plant != nullptr && !m_mayClose) {
        event->ignore();
        if (!m_files->mayClose() || !m_recording->mayEnd())
            return;
        m_leaving->ask(Leaving::Why::quit, m_buses->open(), [this] {
            m_plant->recording().end();
            m_mayClose = true;
            QTimer::singleShot(0, this, &QWidget::close);
        });
        return;
    }
    saveWindow();
    QMainWindow::closeEvent(event);
}

void MainWindow::saveWindow()
{
    if (m_monitors == nullptr)
        return; // never filled: nothing worth keeping
    m_settings.setWindow(saveGeometry(), m_layouts->toKeep());
    m_settings.setTrend(m_trend->tracks().state());
    m_settings.setMonitors(m_monitors->state());
    m_settings.setPinnedDial(m_dial->toKeep());
}

bool MainWindow::event(QEvent *event)
{
    const bool handled = QMainWindow::event(event);
    if (event->type() == QEvent::Paint && !m_painted) {
        m_painted = true;
        QTimer::singleShot(0, this, &MainWindow::firstPainted);
    }
    return handled;
}

} // namespace codewheel
