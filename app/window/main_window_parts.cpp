// SPDX-License-Identifier: GPL-3.0-or-later
// What the window is made of, and how its parts are connected.
#include "app/window/device_choice.h"
#include "app/window/line_views.h"
#include "app/window/main_window.h"
#include "app/window/panels.h"
#include "app/window/project_files.h"
#include "app/window/report_export.h"
#include "app/window/ring_connection.h"
#include "app/window/transfer_pages.h"
#include "ring/bus_session.h"
#include "transfer/values_before.h"
#include "widgets/cams/cam_editor.h"
#include "widgets/comparison/comparison_page.h"
#include "widgets/device/device_panel.h"
#include "widgets/dial/dial_panel.h"
#include "widgets/line/line_panel.h"
#include "widgets/line/line_terminal.h"
#include "widgets/master/master_panel.h"
#include "widgets/messages/message_model.h"
#include "widgets/messages/messages_view.h"
#include "widgets/monitor/monitor_area.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/project/project_page.h"
#include "widgets/sequence/project_sequences.h"
#include "widgets/sequence/sequence_view.h"
#include "widgets/structure/structure_view.h"
#include "widgets/structure_editor/structure_editor.h"
#include "widgets/trace/trace_view.h"
#include "widgets/training/training_panel.h"
#include "widgets/wizard/parameter_wizard.h"

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace codewheel {

void MainWindow::makePages()
{
    m_monitors = new MonitorArea(*m_bus, this);
    m_wizard = new ParameterWizard(*m_buses, *m_wanted, this);
    m_cams = new CamEditor(m_bus->catalog(), m_project, this);
    m_editor = new StructureEditor(m_project, m_bus->catalog(), this);
    m_comparison = new ComparisonPage(m_project, *m_bus, this);
    m_projectPage = new ProjectPage(m_project, this);
    for (QWidget *page : {static_cast<QWidget *>(m_monitors), static_cast<QWidget *>(m_wizard),
                          static_cast<QWidget *>(m_cams), static_cast<QWidget *>(m_editor),
                          static_cast<QWidget *>(m_comparison), static_cast<QWidget *>(m_projectPage)})
        m_pages->addWidget(page);
    m_transfer = new TransferPages(*m_bus, m_project, valuesBeforeOf(*m_ledger), *m_positions, m_actions,
                                   *m_pages, this);
    makeLineViews();
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
    addDock("structureDock", tr("Bus structure"), m_structure, Qt::ALT | Qt::Key_1);
    addDock("trainingDock", tr("Training"), m_trainingPanel, Qt::ALT | Qt::Key_2);
    addDock("parametersDock", tr("Parameters"), m_parameters, Qt::ALT | Qt::Key_3);
    addDock("dialDock", tr("Encoder"), m_dial, Qt::ALT | Qt::Key_4);
    addDock("messagesDock", tr("Messages"), m_messages, Qt::ALT | Qt::Key_5);
    addDock("traceDock", tr("Handshake trace"), m_trace, Qt::ALT | Qt::Key_6);
    addDock("sequenceDock", tr("Sequence"), sequences, Qt::ALT | Qt::Key_7);
    addDock("deviceDock", tr("Device"), m_device, Qt::ALT | Qt::Key_8);
    addDock("masterDock", tr("Master"), m_master, Qt::ALT | Qt::Key_9);
    addDock("terminalDock", tr("Line terminal"), &m_lineViews->terminal(), Qt::ALT | Qt::Key_0);
    addDock("lineDock", tr("Serial line"), &m_lineViews->panel(), Qt::ALT | Qt::SHIFT | Qt::Key_L);
    arrangePanels(*this);
    m_defaultLayout = saveState(layoutVersion);
    if (!restoreState(m_settings.layout(), layoutVersion))
        raiseFirstPanels(*this);
}

void MainWindow::addDock(const char *name, const QString &title, QWidget *content, const QKeySequence &key)
{
    auto *dock = new QDockWidget(title, this);
    dock->setObjectName(QLatin1String(name));
    dock->setWidget(content);
    content->setAutoFillBackground(true); // so that what changes in it does not paint the dock
    QAction *toggle = makePanelAction(*dock);
    toggle->setToolTip(tr("Shows or hides the panel \"%1\"").arg(title));
    toggle->setShortcut(key);
    m_actions.docks->addAction(toggle);
    m_docks.push_back(dock);
}

void MainWindow::showDock(const char *name)
{
    auto *dock = findChild<QDockWidget *>(QLatin1String(name));
    dock->show();
    dock->raise();
}

void MainWindow::connectProject()
{
    m_connection = new RingConnection(*m_bus, m_project, *m_leaving, m_actions, *m_notice, this);
    connect(m_connection, &RingConnection::onlineChanged, this, &MainWindow::showOnline);
    connect(m_connection, &RingConnection::ringChanged, this, &MainWindow::showOtherRing);
    connect(m_connection, &RingConnection::told, this, &MainWindow::tell);
    connect(m_files, &ProjectFiles::told, this, &MainWindow::tell);
    m_report = new ReportExport(*this, m_project, *m_bus, *m_ledger, *m_notice);
    connect(m_report, &ReportExport::told, this, &MainWindow::tell);
    connect(m_actions.exportReport, &QAction::triggered, m_report, &ReportExport::askWhere);
    connect(m_transfer, &TransferPages::told, this, &MainWindow::tell);
    connect(m_transfer, &TransferPages::closeRequested, this, &MainWindow::showMonitors);
    connect(m_comparison, &ComparisonPage::readInRequested, m_connection, &RingConnection::readIn);
}

void MainWindow::connectViews()
{
    connect(m_choice, &DeviceChoice::changed, this, &MainWindow::showChosen);
    connect(m_structure, &StructureView::opened, this, [this](Place number) {
        if (number.isOnLine()) {
            m_actions.lineTerminal->trigger();
            return;
        }
        showMonitors();
        m_monitors->openWords(number);
    });
    connect(m_structure, &StructureView::menuRequested, this,
            [this](Place, const QPoint &position) { m_actions.deviceMenu->popup(position); });
    connect(m_structure, &StructureView::namingRequested, this, [this] {
        showDock("deviceDock");
        m_device->focusNaming();
    });
    connect(m_master, &MasterPanel::startRequested, m_actions.start, &QAction::trigger);
    connect(m_master, &MasterPanel::stopRequested, m_actions.stop, &QAction::trigger);
    connect(m_master, &MasterPanel::readInRequested, m_actions.readIn, &QAction::trigger);
    connect(m_master, &MasterPanel::asked, this, [this] { showDock("masterDock"); });
    connect(m_parameters, &ParameterPanel::wizardRequested, this, &MainWindow::showWizard);
    connect(m_parameters, &ParameterPanel::refusalShown, this, [this] { showDock("parametersDock"); });
    connect(m_wizard, &ParameterWizard::closeRequested, this, &MainWindow::showMonitors);
    connect(m_trainingPanel, &TrainingPanel::acted, this, [this](Place number, const QString &what) {
        m_messageModel->addNow({.place = number.isEmpty() ? std::nullopt : std::optional(number),
                                .severity = Severity::information,
                                .id = MessageId::training,
                                .arguments = {what}});
    });
    connect(m_trainingPanel, &TrainingPanel::planned, this, [this](Place number, const QString &what) {
        m_messageModel->addNow({.place = number,
                                .severity = Severity::information,
                                .id = MessageId::faultPlan,
                                .arguments = {what}});
    });
}

} // namespace codewheel
