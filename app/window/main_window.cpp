// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/main_window.h"

#include "app/window/alarm_stop.h"
#include "app/window/device_choice.h"
#include "app/window/leaving.h"
#include "app/window/panels.h"
#include "app/window/project_files.h"
#include "app/window/project_recovery.h"
#include "app/window/report_export.h"
#include "app/window/ring_connection.h"
#include "app/window/status_line.h"
#include "app/window/transfer_pages.h"
#include "ring/bus_session.h"
#include "ring/word_channel.h"
#include "simulator/training_controls.h"
#include "widgets/cams/cam_editor.h"
#include "widgets/comparison/comparison_page.h"
#include "widgets/device/device_panel.h"
#include "widgets/dial/dial_panel.h"
#include "widgets/look/inline_message.h"
#include "widgets/master/master_panel.h"
#include "widgets/messages/message_model.h"
#include "widgets/messages/messages_view.h"
#include "widgets/monitor/monitor_area.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/wanted_values.h"
#include "widgets/project/device_names.h"
#include "widgets/project/project_document.h"
#include "widgets/project/project_page.h"
#include "widgets/sequence/project_sequences.h"
#include "widgets/sequence/sequence_view.h"
#include "widgets/structure/structure_view.h"
#include "widgets/structure_editor/structure_editor.h"
#include "widgets/trace/trace_view.h"
#include "widgets/training/training_panel.h"
#include "widgets/wizard/parameter_wizard.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QMenu>
#include <QMessageBox>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTimer>
#include <QVBoxLayout>

namespace codewheel {
namespace {

constexpr int layoutVersion = 2; // of docks and tool bar: another one is not restored
constexpr QSize firstSize(1280, 800);

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
    , m_pages(new QStackedWidget(this))
    , m_files(new ProjectFiles(*this, project, settings, m_actions, *m_notice))
{
    setObjectName(QStringLiteral("mainWindow"));
    auto *center = new QWidget(this);
    auto *rows = new QVBoxLayout(center);
    rows->setContentsMargins({});
    rows->setSpacing(0);
    rows->addWidget(m_notice);
    rows->addWidget(m_pages, 1);
    setCentralWidget(center);
    m_notice->setObjectName(QStringLiteral("notice"));
    setDockNestingEnabled(true);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    connectActions();
    connectViewActions();
    showBusState();
    if (!restoreGeometry(m_settings.geometry()))
        resize(firstSize.boundedTo(screen()->availableSize()));
}

MainWindow::~MainWindow() = default;

void MainWindow::attach(BusSession &bus, std::shared_ptr<TrainingControls> training, const QString &link,
                        MessageModel &messages, FindValuesBefore findBefore)
{
    m_bus = &bus;
    m_training = std::move(training);
    m_messageModel = &messages;
    m_link = link;
    m_findBefore = std::move(findBefore);
    new DeviceNames(m_project, bus, this);
    makePages();
    makeDocks(messages);
    m_structure->setProject(m_project, bus.catalog());
    m_choice = new DeviceChoice(bus, m_project, *m_structure, *m_editor, this);
    connectViews();
    connectProject();
    showOnline();
    openFirstMonitors();
    connect(&bus, &BusSession::stateChanged, this, &MainWindow::showBusState);
    showBusState();
    m_structure->setFocus();
}

void MainWindow::makePages()
{
    m_monitors = new MonitorArea(*m_bus, this);
    m_wizard = new ParameterWizard(*m_bus, *m_wanted, this);
    m_cams = new CamEditor(m_bus->catalog(), m_project, this);
    m_editor = new StructureEditor(m_project, m_bus->catalog(), this);
    m_comparison = new ComparisonPage(m_project, *m_bus, this);
    m_projectPage = new ProjectPage(m_project, this);
    for (QWidget *page : {static_cast<QWidget *>(m_monitors), static_cast<QWidget *>(m_wizard),
                          static_cast<QWidget *>(m_cams), static_cast<QWidget *>(m_editor),
                          static_cast<QWidget *>(m_comparison), static_cast<QWidget *>(m_projectPage)})
        m_pages->addWidget(page);
    m_transfer = new TransferPages(*m_bus, m_project, m_findBefore, m_actions, *m_pages, this);
}

void MainWindow::connectProject()
{
    m_connection = new RingConnection(*m_bus, m_project, *m_leaving, m_actions, *m_notice, this);
    connect(m_connection, &RingConnection::onlineChanged, this, &MainWindow::showOnline);
    connect(m_connection, &RingConnection::ringChanged, this, &MainWindow::showOtherRing);
    connect(m_connection, &RingConnection::told, this, &MainWindow::tell);
    connect(m_files, &ProjectFiles::told, this, &MainWindow::tell);
    m_report = new ReportExport(*this, m_project, *m_bus, *m_notice);
    connect(m_report, &ReportExport::told, this, &MainWindow::tell);
    connect(m_actions.exportReport, &QAction::triggered, m_report, &ReportExport::askWhere);
    connect(m_transfer, &TransferPages::told, this, &MainWindow::tell);
    connect(m_transfer, &TransferPages::closeRequested, this, &MainWindow::showMonitors);
    connect(m_comparison, &ComparisonPage::readInRequested, m_connection, &RingConnection::readIn);
}

// A notice of its own: the question stands until it is answered.
void MainWindow::askForRecovery(ProjectRecovery &recovery)
{
    auto *question = new InlineMessage(this);
    question->setObjectName(QStringLiteral("recoveryQuestion"));
    static_cast<QVBoxLayout *>(centralWidget()->layout())->insertWidget(0, question);
    recovery.ask(*question, *m_files);
}

void MainWindow::tell(const Message &message)
{
    m_messageModel->addNow(message);
}

// Offline no words are looked at: which the ring will have when it is connected again is not known.
void MainWindow::showOnline()
{
    BusSession *online = m_bus->isOpen() ? m_bus : nullptr;
    if (online == nullptr) {
        m_openMonitors = m_monitors->state();
        m_monitors->closeAll();
    } else if (!m_openMonitors.isEmpty()) {
        m_monitors->restoreState(std::exchange(m_openMonitors, {}));
    }
    m_leaving->setBus(online);
    m_status->setBus(online, m_link);
    const auto chosen = m_choice->number();
    m_structure->setBus(online);
    m_choice->keep(chosen);
    m_comparison->setConnected(online != nullptr);
    showBusState();
}

// Devices that stayed have kept their sessions; monitors of others are closed.
void MainWindow::showOtherRing()
{
    const auto chosen = m_choice->number();
    m_leaving->setBus(m_bus);
    m_structure->setBus(m_bus);
    m_choice->keep(chosen);
}

void MainWindow::makeDocks(MessageModel &messages)
{
    m_structure = new StructureView(this);
    m_trainingPanel = new TrainingPanel(*m_training, this);
    m_parameters = new ParameterPanel(*m_wanted, this);
    m_dial = new DialPanel(this);
    m_device = new DevicePanel(*m_bus, this);
    m_trace = new TraceView(*m_bus, this);
    m_sequence = new SequenceView(this);
    auto *sequences = new QWidget(this);
    auto *rows = new QVBoxLayout(sequences);
    rows->setContentsMargins({});
    rows->setSpacing(0);
    rows->addWidget(new ProjectSequences(m_project, *m_sequence, sequences));
    rows->addWidget(m_sequence, 1);
    m_messages = new MessagesView(messages, this);
    m_master = new MasterPanel(*m_bus, this);
    m_actions.deviceMenu->insertActions(m_actions.zeroOut, m_parameters->functionActions());
    m_actions.deviceMenu->insertSeparator(m_actions.zeroOut);
    addDock("structureDock", tr("Bus structure"), m_structure);
    addDock("trainingDock", tr("Training"), m_trainingPanel);
    addDock("parametersDock", tr("Parameters"), m_parameters);
    addDock("dialDock", tr("Encoder"), m_dial);
    addDock("messagesDock", tr("Messages"), m_messages);
    addDock("traceDock", tr("Handshake trace"), m_trace);
    addDock("sequenceDock", tr("Sequence"), sequences);
    addDock("deviceDock", tr("Device"), m_device);
    addDock("masterDock", tr("Master"), m_master);
    arrangePanels(*this);
    m_defaultLayout = saveState(layoutVersion);
    if (!restoreState(m_settings.layout(), layoutVersion))
        raiseFirstPanels(*this);
}

void MainWindow::addDock(const char *name, const QString &title, QWidget *content)
{
    auto *dock = new QDockWidget(title, this);
    dock->setObjectName(QLatin1String(name));
    dock->setWidget(content);
    QAction *toggle = makePanelAction(*dock);
    toggle->setToolTip(tr("Shows or hides the panel \"%1\"").arg(title));
    toggle->setShortcut(QKeySequence(Qt::ALT | Qt::Key(Qt::Key_1 + static_cast<int>(m_docks.size()))));
    m_actions.docks->addAction(toggle);
    m_docks.push_back(dock);
}

void MainWindow::connectActions()
{
    const auto withBus = [this](auto what) {
        return [this, what] {
            if (m_bus != nullptr)
                what(*m_bus);
        };
    };
    connect(m_actions.quit, &QAction::triggered, this, &QWidget::close);
    connect(m_actions.watch, &QAction::triggered, this,
            withBus([](BusSession &bus) { bus.setOperate(false); }));
    connect(m_actions.operate, &QAction::triggered, this,
            withBus([](BusSession &bus) { bus.setOperate(true); }));
    connect(m_actions.start, &QAction::triggered, this, withBus([](BusSession &bus) { bus.startBus(); }));
    connect(m_actions.alarmStop, &QAction::triggered, this,
            withBus([](BusSession &bus) { bus.alarmStop(); }));
    connect(m_actions.stop, &QAction::triggered, this,
            [this] { m_leaving->ask(Leaving::Why::stop, [this] { m_bus->stopBus(); }); });
    connect(m_actions.switchSegment, &QAction::triggered, this, [this] {
        if (const auto number = currentNumber())
            m_master->toggleSegment(number->segment);
    });
    connect(m_actions.wizard, &QAction::triggered, this, &MainWindow::showWizard);
    connect(m_actions.monitors, &QAction::triggered, this, &MainWindow::showMonitors);
    connect(m_actions.cams, &QAction::triggered, this, &MainWindow::showCams);
    connect(m_actions.structureEditor, &QAction::triggered, this, &MainWindow::showStructureEditor);
    connect(m_actions.compare, &QAction::triggered, this, &MainWindow::showComparison);
    connect(m_actions.projectPage, &QAction::triggered, this, &MainWindow::showProjectPage);
    const auto open = [this](MonitorKind kind) {
        return [this, kind] {
            if (const auto number = currentNumber()) {
                showMonitors();
                m_monitors->openMonitor(*number, kind);
            }
        };
    };
    connect(m_actions.openIn32, &QAction::triggered, this, open(MonitorKind::in32));
    connect(m_actions.openOut32, &QAction::triggered, this, open(MonitorKind::out32));
    connect(m_actions.openIn16, &QAction::triggered, this, open(MonitorKind::in16));
    connect(m_actions.zeroOut, &QAction::triggered, this, [this] {
        if (const auto number = currentNumber())
            m_bus->zeroOut(*number);
    });
    connect(m_actions.exportTrace, &QAction::triggered, this, [this] { m_trace->exportRows(); });
    connect(m_actions.exportMessages, &QAction::triggered, this, [this] { m_messages->exportRows(); });
}

void MainWindow::connectViewActions()
{
    const Appearance appearance = m_settings.appearance();
    m_actions.scheme->actions().at(static_cast<int>(appearance.scheme))->setChecked(true);
    m_actions.largeControls->setChecked(appearance.largeControls);
    m_actions.lessMotion->setChecked(appearance.lessMotion);
    setAnimated(!appearance.lessMotion);
    for (QAction *language : m_actions.language->actions())
        language->setChecked(language->data().toString() == m_settings.language());

    const auto change = [this] {
        const Appearance chosen{.scheme =
                                    static_cast<Scheme>(m_actions.scheme->checkedAction()->data().toInt()),
                                .largeControls = m_actions.largeControls->isChecked(),
                                .lessMotion = m_actions.lessMotion->isChecked()};
        m_settings.setAppearance(chosen);
        setAnimated(!chosen.lessMotion);
        applyAppearance(*qApp, chosen);
    };
    connect(m_actions.scheme, &QActionGroup::triggered, this, change);
    connect(m_actions.largeControls, &QAction::triggered, this, change);
    connect(m_actions.lessMotion, &QAction::triggered, this, change);
    connect(m_actions.language, &QActionGroup::triggered, this,
            [this](const QAction *language) { Q_EMIT languageChosen(language->data().toString()); });
    connect(m_actions.defaultLayout, &QAction::triggered, this, [this] {
        restoreState(m_defaultLayout, layoutVersion); // the tool bar, too
        arrangePanels(*this);
        raiseFirstPanels(*this);
    });
    connect(m_actions.keys, &QAction::triggered, this, &MainWindow::showKeys);
    connect(m_actions.about, &QAction::triggered, this, &MainWindow::showAbout);
}

void MainWindow::connectViews()
{
    connect(m_choice, &DeviceChoice::changed, this, &MainWindow::showChosen);
    connect(m_structure, &StructureView::opened, this, [this](DeviceNumber number) {
        showMonitors();
        m_monitors->openWords(number);
    });
    connect(m_structure, &StructureView::menuRequested, this,
            [this](DeviceNumber, const QPoint &position) { m_actions.deviceMenu->popup(position); });
    connect(m_structure, &StructureView::namingRequested, this, [this] {
        auto *dock = findChild<QDockWidget *>(QStringLiteral("deviceDock"));
        dock->show();
        dock->raise();
        m_device->focusNaming();
    });
    connect(m_master, &MasterPanel::startRequested, m_actions.start, &QAction::trigger);
    connect(m_master, &MasterPanel::stopRequested, m_actions.stop, &QAction::trigger);
    connect(m_master, &MasterPanel::readInRequested, m_actions.readIn, &QAction::trigger);
    connect(m_master, &MasterPanel::asked, this, [this] {
        auto *dock = findChild<QDockWidget *>(QStringLiteral("masterDock"));
        dock->show();
        dock->raise();
    });
    connect(m_parameters, &ParameterPanel::wizardRequested, this, &MainWindow::showWizard);
    connect(m_parameters, &ParameterPanel::refusalShown, this, [this] {
        auto *dock = findChild<QDockWidget *>(QStringLiteral("parametersDock"));
        dock->show();
        dock->raise();
    });
    connect(m_wizard, &ParameterWizard::closeRequested, this, &MainWindow::showMonitors);
    connect(m_trainingPanel, &TrainingPanel::acted, this, [this](DeviceNumber number, const QString &what) {
        m_messageModel->addNow({.place = number,
                                .severity = Severity::information,
                                .id = MessageId::training,
                                .arguments = {what}});
    });
    connect(m_trainingPanel, &TrainingPanel::planned, this, [this](DeviceNumber number, const QString &what) {
        m_messageModel->addNow({.place = number,
                                .severity = Severity::information,
                                .id = MessageId::faultPlan,
                                .arguments = {what}});
    });
}

// Of a device that is only planned, what is wanted can be looked at and edited; all else needs it connected.
void MainWindow::showChosen()
{
    const ShownEncoder &encoder = m_choice->encoder();
    EncoderSession *connected = encoder.session();
    m_parameters->setEncoder(encoder);
    m_dial->setEncoder(connected);
    m_trace->setEncoder(connected);
    m_sequence->setEncoder(connected);
    m_status->setEncoder(connected);
    m_wizard->setEncoder(connected);
    m_cams->setEncoder(encoder);
    m_actions.showChosen(encoder);
    m_transfer->setEncoder(encoder);
    m_device->setPlace(m_choice->number(), encoder.isThere() && connected == nullptr
                                               ? std::optional(encoder.device())
                                               : std::nullopt);
    if (m_bus->isOpen() && m_choice->number())
        m_trainingPanel->setDevice(*m_choice->number());
}

void MainWindow::openFirstMonitors()
{
    if (const auto state = m_settings.monitors())
        m_monitors->restoreState(*state);
    else
        m_monitors->openFirst();
}

void MainWindow::showPicture()
{
    if (m_bus == nullptr)
        return;
    m_bus->pump();
    m_trainingPanel->refresh();
}

void MainWindow::showWizard()
{
    if (m_wizard == nullptr)
        return;
    m_pages->setCurrentWidget(m_wizard);
    m_wizard->focusPage();
}

void MainWindow::showMonitors()
{
    if (m_monitors != nullptr)
        m_pages->setCurrentWidget(m_monitors);
}

void MainWindow::showCams()
{
    if (m_cams == nullptr)
        return;
    m_pages->setCurrentWidget(m_cams);
    m_cams->setFocus();
}

void MainWindow::showStructureEditor()
{
    if (m_editor == nullptr)
        return;
    const auto chosen = currentNumber(); // the page chooses its first device when it gets the focus
    m_pages->setCurrentWidget(m_editor);
    m_editor->setFocus();
    m_choice->choose(chosen);
}

void MainWindow::showComparison()
{
    if (m_comparison == nullptr)
        return;
    m_pages->setCurrentWidget(m_comparison);
    m_comparison->setFocus();
}

void MainWindow::showProjectPage()
{
    if (m_projectPage == nullptr)
        return;
    m_pages->setCurrentWidget(m_projectPage);
    m_projectPage->setFocus();
}

void MainWindow::showBusState()
{
    const bool connected = m_bus != nullptr && m_bus->isOpen();
    for (QAction *page :
         {m_actions.projectPage, m_actions.structureEditor, m_actions.compare, m_actions.transfer})
        page->setEnabled(m_bus != nullptr);
    for (QAction *action : {m_actions.connectBus, m_actions.disconnectBus, m_actions.readIn})
        if (m_bus == nullptr)
            action->setEnabled(false);
    const bool running = connected && m_bus->isRunning();
    const bool operating = connected && m_bus->isOperating();
    m_actions.watch->setEnabled(connected);
    m_actions.operate->setEnabled(connected);
    m_actions.watch->setChecked(!operating);
    m_actions.operate->setChecked(operating);
    m_actions.start->setEnabled(connected && !running);
    m_actions.stop->setEnabled(running);
    const bool hasMaster = connected && m_bus->master() != nullptr;
    m_actions.confirmDiagnostics->setEnabled(hasMaster);
    m_actions.switchSegment->setEnabled(hasMaster);
    m_actions.alarmStop->setEnabled(connected);
    for (QAction *monitor : {m_actions.openIn32, m_actions.openOut32, m_actions.openIn16})
        monitor->setEnabled(connected);
    m_actions.exportReport->setEnabled(m_bus != nullptr);
    m_actions.exportTrace->setEnabled(m_bus != nullptr);
    m_actions.exportMessages->setEnabled(m_bus != nullptr);
}

std::optional<DeviceNumber> MainWindow::currentNumber() const
{
    return m_choice == nullptr ? std::nullopt : m_choice->number();
}

void MainWindow::showKeys()
{
    QStringList rows;
    for (const QAction *action : findChildren<QAction *>())
        if (!action->shortcut().isEmpty())
            rows.append(QStringLiteral("<tr><td><b>%1</b>&nbsp;&nbsp;</td><td>%2</td></tr>")
                            .arg(action->shortcut().toString(QKeySequence::NativeText).toHtmlEscaped(),
                                 action->text().remove(u'&').toHtmlEscaped()));
    rows.removeDuplicates();
    QMessageBox::information(this, tr("Keys"),
                             tr("<p>Space or a click toggles a bit, the arrows move.</p>") +
                                 QStringLiteral("<table>%1</table>").arg(rows.join(QString())));
}

void MainWindow::showAbout()
{
    QMessageBox::about(
        this, tr("About Codewheel"),
        tr("<h3>Codewheel %1</h3><p>Sets up, watches and diagnoses absolute encoders on INTERBUS.</p>"
           "<p>Free software under the GNU General Public License, version 3 or later. It comes without any "
           "warranty.</p>")
            .arg(QApplication::applicationVersion()));
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    if (m_bus != nullptr && !m_mayClose) {
        event->ignore();
        if (!m_files->mayClose())
            return;
        m_leaving->ask(Leaving::Why::quit, [this] {
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
        return; // never filled: there is nothing worth keeping
    m_settings.setWindow(saveGeometry(), saveState(layoutVersion));
    m_settings.setMonitors(m_openMonitors.isEmpty() ? m_monitors->state() : m_openMonitors);
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
