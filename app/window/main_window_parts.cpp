// SPDX-License-Identifier: GPL-3.0-or-later
// What the window is made of, and how its parts are connected.
#include "app/window/bus_views.h"
#include "app/window/device_choice.h"
#include "app/window/main_window.h"
#include "app/window/panels.h"
#include "app/window/plant.h"
#include "app/window/project_files.h"
#include "app/window/report_export.h"
#include "app/window/transfer_pages.h"
#include "transfer/values_before.h"
#include "widgets/cams/cam_editor.h"
#include "widgets/device/device_panel.h"
#include "widgets/dial/dial_panel.h"
#include "widgets/messages/message_model.h"
#include "widgets/messages/messages_view.h"
#include "widgets/monitor/monitor_area.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/project/bus_list.h"
#include "widgets/project/project_page.h"
#include "widgets/sequence/project_sequences.h"
#include "widgets/sequence/sequence_view.h"
#include "widgets/structure/structure_view.h"
#include "widgets/structure_editor/structure_editor.h"
#include "widgets/trace/trace_view.h"
#include "widgets/wizard/parameter_wizard.h"

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace codewheel {

void MainWindow::makePages()
{
    m_monitors = new MonitorArea(*m_buses, this);
    m_wizard = new ParameterWizard(*m_buses, *m_wanted, this);
    m_cams = new CamEditor(m_plant->catalog(), m_project, this);
    m_editor = new StructureEditor(m_project, m_plant->catalog(), this);
    m_projectPage = new ProjectPage(m_project, this);
    m_projectPage->buses().setIsFree([this](BusId bus, const QString &kind) {
        const BusAtWork *its = m_plant->find(bus);
        const bool isTraining = bus == firstRing || bus == firstLine;
        return its == nullptr || !its->isOpen() || (isTraining && its->kind() == kind);
    });
    for (QWidget *page : {static_cast<QWidget *>(m_monitors), static_cast<QWidget *>(m_wizard),
                          static_cast<QWidget *>(m_cams), static_cast<QWidget *>(m_editor),
                          static_cast<QWidget *>(m_projectPage)})
        m_pages->addWidget(page);
    m_transfer = new TransferPages(*m_buses, m_plant->catalog(), m_project,
                                   valuesBeforeOf([this] { return m_plant->ledgers(); }),
                                   m_plant->positions(), m_actions, *m_pages, this);
}

void MainWindow::makeDocks(MessageModel &messages)
{
    m_structure = new StructureView(this);
    m_parameters = new ParameterPanel(*m_wanted, this);
    m_dial = new DialPanel(this);
    m_device = new DevicePanel(m_plant->catalog(), this);
    m_trace = new TraceView(*m_buses, this);
    m_sequence = new SequenceView(this);
    auto *sequences = new QWidget(this);
    auto *rows = new QVBoxLayout(sequences);
    rows->setContentsMargins({});
    rows->setSpacing(0);
    rows->addWidget(new ProjectSequences(m_project, *m_sequence, sequences));
    rows->addWidget(m_sequence, 1);
    m_messages = new MessagesView(messages, this);
    m_actions.deviceMenu->insertActions(m_actions.zeroOut, m_parameters->functionActions());
    m_actions.deviceMenu->insertSeparator(m_actions.zeroOut);
    addDock("structureDock", tr("Bus structure"), m_structure, Qt::ALT | Qt::Key_1);
    addKindDock("trainingDock", tr("Training"), Qt::ALT | Qt::Key_2);
    addDock("parametersDock", tr("Parameters"), m_parameters, Qt::ALT | Qt::Key_3);
    addDock("dialDock", tr("Encoder"), m_dial, Qt::ALT | Qt::Key_4);
    addDock("messagesDock", tr("Messages"), m_messages, Qt::ALT | Qt::Key_5);
    addDock("traceDock", tr("Handshake trace"), m_trace, Qt::ALT | Qt::Key_6);
    addDock("sequenceDock", tr("Sequence"), sequences, Qt::ALT | Qt::Key_7);
    addDock("deviceDock", tr("Device"), m_device, Qt::ALT | Qt::Key_8);
    addKindDock("masterDock", tr("Master"), Qt::ALT | Qt::Key_9);
    addKindDock("terminalDock", tr("Line terminal"), Qt::ALT | Qt::Key_0);
    addKindDock("lineDock", tr("Serial line"), Qt::ALT | Qt::SHIFT | Qt::Key_L);
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

void MainWindow::addKindDock(const char *name, const QString &title, const QKeySequence &key)
{
    auto *pages = new QStackedWidget(this);
    pages->setObjectName(QLatin1String(kindPages));
    addDock(name, title, pages, key);
}

void MainWindow::showDock(const char *name)
{
    auto *dock = findChild<QDockWidget *>(QLatin1String(name));
    dock->show();
    dock->raise();
    makeRoomFor(*dock);
}

void MainWindow::connectProject()
{
    connect(m_files, &ProjectFiles::told, this, &MainWindow::tell);
    m_report = new ReportExport(
        *this, m_project, *m_buses, m_plant->catalog(), [this] { return m_plant->ledgers(); }, *m_notice);
    connect(m_report, &ReportExport::told, this, &MainWindow::tell);
    connect(m_actions.exportReport, &QAction::triggered, m_report, &ReportExport::askWhere);
    connect(m_transfer, &TransferPages::told, this, &MainWindow::tell);
    connect(m_transfer, &TransferPages::closeRequested, this, &MainWindow::showMonitors);
}

void MainWindow::connectViews()
{
    connect(m_choice, &DeviceChoice::changed, this, &MainWindow::showChosen);
    connect(m_structure, &StructureView::opened, this, [this](Place place) {
        BusViews *views = viewsOf(place.bus);
        if (views != nullptr && views->open(place))
            return;
        showMonitors();
        m_monitors->openWords(place);
    });
    connect(m_structure, &StructureView::menuRequested, this,
            [this](Place, const QPoint &position) { m_actions.deviceMenu->popup(position); });
    connect(m_structure, &StructureView::namingRequested, this, [this] {
        showDock("deviceDock");
        m_device->focusNaming();
    });
    connect(m_parameters, &ParameterPanel::wizardRequested, this, &MainWindow::showWizard);
    connect(m_parameters, &ParameterPanel::refusalShown, this, [this] { showDock("parametersDock"); });
    connect(m_wizard, &ParameterWizard::closeRequested, this, &MainWindow::showMonitors);
    connect(m_trace, &TraceView::terminalRequested, m_actions.lineTerminal, &QAction::trigger);
    connect(m_sequence, &SequenceView::terminalRequested, m_actions.lineTerminal, &QAction::trigger);
}

} // namespace codewheel
