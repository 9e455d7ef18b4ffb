// SPDX-License-Identifier: GPL-3.0-or-later
// What the window is made of, and how its parts are connected.
#include "app/user_devices.h"
#include "app/window/buses/device_choice.h"
#include "app/window/buses/dropped_device.h"
#include "app/window/buses/plant.h"
#include "app/window/buses/transfer_pages.h"
#include "app/window/connect/finder_in_window.h"
#include "app/window/connect/start.h"
#include "app/window/files/dropped_files.h"
#include "app/window/files/project_files.h"
#include "app/window/files/waiting_file.h"
#include "app/window/kinds/window_kinds.h"
#include "app/window/look/bottom_fold.h"
#include "app/window/look/window_layouts.h"
#include "app/window/main_window.h"
#include "app/window/paper/printing.h"
#include "app/window/paper/report_export.h"
#include "app/window/recording/recording_in_window.h"
#include "bus/word_channel.h"
#include "transfer/values_before.h"
#include "widgets/cams/cam_editor.h"
#include "widgets/device/device_panel.h"
#include "widgets/dial/dial_panel.h"
#include "widgets/dial/dial_pin.h"
#include "widgets/find/find_page.h"
#include "widgets/help/help_topic.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
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
#include "widgets/trend/trend_page.h"
#include "widgets/wizard/parameter_wizard.h"

#include <QAction>
#include <QMenu>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace codewheel {

void MainWindow::makePages()
{
    m_monitors = new MonitorArea(*m_buses, this);
    m_monitors->setStations([this](Place place) { return m_project.device(place).station; });
    connect(&m_project, &ProjectDocument::changed, m_monitors, &MonitorArea::showStations);
    m_trend = new TrendPage(
        *m_buses, m_plant->histories(), [this](Place place) { return m_project.device(place).station; },
        this);
    m_trend->tracks().restore(m_settings.trend());
    m_editor = new StructureEditor(m_project, m_plant->catalog(), this);
    m_projectPage = new ProjectPage(m_project, this);
    m_projectPage->buses().setIsFree([this](BusId bus, const QString &kind) {
        const BusAtWork *its = m_plant->find(bus);
        return its == nullptr || !its->isOpen() || (its->isTraining() && its->kind() == kind);
    });
    m_projectPage->buses().setOffers([](const QString &kind) { return windowKind(kind) != nullptr; });
    const std::pair<QWidget *, const char *> pages[] = {{m_monitors, "monitors.md"},
                                                        {m_trend, "trend.md"},
                                                        {m_editor, "project.md#the-structure-editor"},
                                                        {m_projectPage, "project.md#files"}};
    for (const auto &[page, topic] : pages) {
        m_pages->addWidget(page);
        setHelpTopic(*page, topic);
    }
    m_cams.emplace(*m_pages, "cams.md", [this] { return makeCams(); });
    m_wizard.emplace(*m_pages, "wizard.md", [this] { return makeWizard(); });
    m_transfer = new TransferPages(*m_buses, m_plant->catalog(), m_project,
                                   valuesBeforeOf([this] { return m_plant->ledgers(); }),
                                   m_plant->positions(), m_actions, *m_pages, this);
    m_transfer->setReplaceSteps([this](Replacing &replacing) {
        BusViews *views = viewsOf(replacing.place.bus);
        return views != nullptr ? views->replaceSteps(replacing) : ReplaceStepsOfKind();
    });
    makeFinder();
    m_start = new Start({*m_plant, m_project, *m_files, m_settings, m_actions, *m_pages,
                         *static_cast<QVBoxLayout *>(centralWidget()->layout())},
                        this);
}

CamEditor *MainWindow::makeCams()
{
    auto *cams = new CamEditor(*m_buses, m_plant->catalog(), m_project, m_pages);
    cams->setEncoder(m_choice->encoder());
    connect(cams, &CamEditor::trendWanted, this, &MainWindow::showInTrend);
    return cams;
}

ParameterWizard *MainWindow::makeWizard()
{
    auto *wizard = new ParameterWizard(*m_buses, *m_wanted, m_pages);
    wizard->setStations([this](Place place) { return m_project.device(place).station; });
    wizard->setEncoder(m_choice->encoder().session());
    connect(wizard, &ParameterWizard::encoderChosen, m_choice, &DeviceChoice::choose);
    connect(wizard, &ParameterWizard::goesOn, m_parameters, &ParameterPanel::takeFollowing);
    return wizard;
}

// What is found is connected as the bus of its kind that was chosen last.
void MainWindow::makeFinder()
{
    auto *page = new FindPage(m_pages);
    m_pages->addWidget(page);
    setHelpTopic(*page, "find.md");
    m_finder = new FinderInWindow(*page);
    connect(m_actions.findEncoders, &QAction::triggered, this, [this, page] {
        m_finder->listPorts();
        m_pages->setCurrentWidget(page);
        page->setFocus();
    });
    connect(page, &FindPage::connectWanted, this,
            [this](const Found &found, const std::vector<KindData> &devices) {
                const BusId bus = m_currentOf.value(found.kind);
                if (BusViews *views = viewsOf(bus)) {
                    views->connectFound(found.plan, devices);
                    m_structure->choose(bus);
                }
            });
}

void MainWindow::makeDocks(MessageModel &messages)
{
    m_structure = new StructureView(this);
    m_parameters = new ParameterPanel(*m_buses, *m_wanted, this);
    auto *dial = new DialPanel(this);
    dial->setPrinting(*m_actions.print);
    connect(dial, &DialPanel::trendWanted, this, &MainWindow::showInTrend);
    m_dial = new DialPin(*dial, *m_buses, [this](Place place) { return m_project.device(place).station; });
    connect(&m_project, &ProjectDocument::changed, m_dial, &DialPin::showHead);
    connect(m_actions.pinDial, &QAction::triggered, m_dial, &DialPin::setPinned);
    connect(m_dial, &DialPin::changed, this, [this] {
        m_actions.pinDial->setEnabled(m_dial->canBePinned());
        m_actions.pinDial->setChecked(m_dial->pinned().has_value());
    });
    m_device = new DevicePanel(*m_buses, m_plant->catalog(), this);
    m_trace = new TraceView(*m_buses, this);
    m_trace->setMostRows(m_settings.choices().traceRows);
    m_plant->histories().setLimit(static_cast<std::size_t>(m_settings.choices().trendMemory) << 20);
    m_sequence = new SequenceView(this);
    auto *sequences = new QWidget(this);
    auto *rows = layOut<QVBoxLayout>(sequences, 0);
    rows->addWidget(new ProjectSequences(m_project, *m_sequence, sequences));
    rows->addWidget(m_sequence, 1);
    m_messages = new MessagesView(messages, this);
    m_actions.deviceMenu->insertActions(m_actions.zeroOut, m_parameters->functionActions());
    m_actions.deviceMenu->insertSeparator(m_actions.zeroOut);
    const auto add = [this](const Panel &panel, QWidget *content) {
        m_actions.docks->addAction(m_panels.add(panel, content));
    };
    const auto addPaged = [this](const Panel &panel) {
        m_actions.docks->addAction(m_panels.addPaged(panel));
    };
    add(panel::structure, m_structure);
    addPaged(panel::training);
    add(panel::parameters, m_parameters);
    add(panel::dial, dial);
    add(panel::messages, m_messages);
    add(panel::trace, m_trace);
    add(panel::sequence, sequences);
    add(panel::device, m_device);
    for (const WindowKind *kind : windowKinds())
        for (const Panel *its : kind->panels)
            addPaged(*its);
    m_panels.arrange(windowSizeOf(size()));
    m_defaultLayout = saveState(layoutVersion);
    m_layouts =
        new WindowLayouts(*this, {.save =
                                      [this] {
                                          const BottomFold::Pause whole(m_panels.fold());
                                          return saveState(layoutVersion);
                                      },
                                  .restore =
                                      [this](const QByteArray &state) {
                                          const BottomFold::Pause whole(m_panels.fold());
                                          return restoreState(state, layoutVersion);
                                      },
                                  .arrange =
                                      [this](WindowSize size) {
                                          const BottomFold::Pause whole(m_panels.fold());
                                          restoreState(m_defaultLayout, layoutVersion); // tool bar included
                                          m_panels.arrange(size);
                                          m_panels.raiseFirst();
                                      }});
    m_layouts->begin(m_settings.layouts());
}

void MainWindow::connectProject()
{
    connect(m_files, &ProjectFiles::told, this, &MainWindow::tell);
    m_report = new ReportExport(
        *this, m_project, *m_buses, m_plant->catalog(), [this] { return m_plant->ledgers(); }, *m_notice);
    connect(m_report, &ReportExport::told, this, &MainWindow::tell);
    connect(m_actions.exportReport, &QAction::triggered, m_report, &ReportExport::preview);
    auto *printing =
        new Printing(*this, *m_report,
                     {.bus = [this](BusId bus) { return m_plant->nameOf(bus); },
                      .station = [this](Place place) { return m_project.device(place).station; }});
    connect(m_actions.print, &QAction::triggered, printing, &Printing::preview);
    m_recording = new RecordingInWindow(
        {*m_plant, m_project, m_settings, *m_actions.record, *m_status, *m_trend, *m_notice}, this);
    connect(m_transfer, &TransferPages::told, this, &MainWindow::tell);
}

// What is none of the program's files is refused as a project.
void MainWindow::openFile(const QString &path)
{
    const FileKind kind = fileKind(path);
    const bool isOther =
        kind == FileKind::ofProgram || kind == FileKind::other || kind == FileKind::notReadable;
    openDropped(isOther ? FileKind::project : kind, path);
}

// Opened as by its own page or panel, with the same questions.
void MainWindow::openDropped(FileKind kind, const QString &path)
{
    switch (kind) {
    case FileKind::project:
        m_files->open(path);
        return;
    case FileKind::cams:
        m_waitingCams->open(path);
        return;
    case FileKind::faultPlan:
        m_waitingFaultPlan->open(path);
        return;
    case FileKind::sequence:
        m_panels.show(panel::sequence);
        if (m_sequence->isSending())
            m_notice->showMessage(Role::attention,
                                  tr("A sequence is being sent: it stays until that has ended."));
        else
            m_sequence->load(path);
        return;
    case FileKind::device:
        m_droppedDevice->offer(path);
        return;
    case FileKind::recording:
        openRecording(path);
        return;
    case FileKind::ofProgram:
    case FileKind::other:
    case FileKind::notReadable:
        return; // already reported
    }
}

InlineMessage &MainWindow::addNotice(const QString &name)
{
    auto *notice = new InlineMessage(this);
    notice->setObjectName(name);
    static_cast<QVBoxLayout *>(centralWidget()->layout())->insertWidget(0, notice);
    return *notice;
}

void MainWindow::makeWaitingCams()
{
    m_waitingCams = new WaitingFile(addNotice(QStringLiteral("waitingCams")),
                                    {.isThere = [this] { return m_actions.cams->isEnabled(); },
                                     .sentence =
                                         [](const QString &file) {
                                             return tr("%1 has cam programs: choose an encoder with cams in "
                                                       "the bus structure, and they are "
                                                       "opened for it.")
                                                 .arg(file);
                                         }},
                                    this);
    connect(m_actions.cams, &QAction::enabledChanged, m_waitingCams, &WaitingFile::lookAgain,
            Qt::QueuedConnection); // once all views show that encoder
    connect(m_waitingCams, &WaitingFile::ready, this, [this](const QString &path) {
        showCams();
        m_cams->page().load(path);
    });
}

void MainWindow::makeWaitingFaultPlan()
{
    m_waitingFaultPlan = new WaitingFile(
        addNotice(QStringLiteral("waitingFaultPlan")),
        {.isThere = [this] { return takerOfFaultPlans() != nullptr; },
         .sentence =
             [](const QString &file) {
                 return tr("%1 is a fault plan: it can be loaded once a training ring is connected.")
                     .arg(file);
             },
         .action = tr("&Training bus")},
        this);
    connect(m_waitingFaultPlan, &WaitingFile::actionTriggered, this, [this] { m_start->openTraining(); });
    connect(&m_plant->buses(), &Buses::changed, m_waitingFaultPlan, &WaitingFile::lookAgain,
            Qt::QueuedConnection);
    connect(m_waitingFaultPlan, &WaitingFile::ready, this,
            [this](const QString &path) { takerOfFaultPlans()->loadFaultPlan(path); });
}

// The chosen one, or else the first.
BusViews *MainWindow::takerOfFaultPlans() const
{
    const auto chosen = m_structure->row();
    BusViews *first = nullptr;
    for (const auto &[bus, views] : m_views)
        if (views->takesFaultPlans()) {
            if (chosen && chosen->bus == bus)
                return views;
            first = first == nullptr ? views : first;
        }
    return first;
}

void MainWindow::connectDrops()
{
    m_droppedDevice = new DroppedDevice(addNotice(QStringLiteral("droppedDevice")), userDeviceFolder(), this);
    makeWaitingCams();
    makeWaitingFaultPlan();
    auto *drops = new DroppedFiles(*this);
    connect(drops, &DroppedFiles::dropped, this, &MainWindow::openDropped);
    connect(drops, &DroppedFiles::refused, this,
            [this](const QString &sentence) { m_notice->showMessage(Role::attention, sentence); });
}

void MainWindow::connectViews()
{
    connectDrops();
    m_sequence->setWordsOf([this](Place place) {
        std::vector<Word> words = m_trace->outWords(place);
        const WordChannel *channel = m_buses->channel(place);
        if (channel != nullptr && channel->staged())
            words.push_back(*channel->staged());
        return words;
    });
    connect(m_start, &Start::connectRequested, this, [this](BusId bus) {
        m_structure->choose(bus);
        if (BusViews *views = viewsOf(bus))
            views->connectBus();
    });
    connect(m_start, &Start::trainingRequested, this, [this](BusId bus) {
        if (BusViews *views = viewsOf(bus))
            views->connectTraining();
    });
    connect(m_choice, &DeviceChoice::changed, this, &MainWindow::showChosen);
    connect(m_structure, &StructureView::opened, this, [this](Place place) {
        BusViews *views = viewsOf(place.bus);
        if (views != nullptr && views->open(place))
            return;
        showMonitors();
        m_monitors->open(place);
    });
    connect(m_structure, &StructureView::menuRequested, this,
            [this](Place, const QPoint &position) { m_actions.deviceMenu->popup(position); });
    connect(m_structure, &StructureView::namingRequested, this, [this] {
        m_panels.show(panel::device);
        m_device->focusNaming();
    });
    connect(m_monitors, &MonitorArea::trendWanted, this, &MainWindow::showInTrend);
    connect(m_parameters, &ParameterPanel::wizardRequested, this, &MainWindow::showWizard);
    connect(m_parameters, &ParameterPanel::refusalShown, this, [this] { m_panels.show(panel::parameters); });
    const auto openChosen = [this] {
        const auto place = m_choice->place();
        if (BusViews *views = place ? viewsOf(place->bus) : nullptr)
            views->open(*place);
    };
    connect(m_trace, &TraceView::terminalRequested, this, openChosen);
    connect(m_trace, &TraceView::goToWanted, this, &MainWindow::goTo);
    connect(m_messages, &MessagesView::goToWanted, this, &MainWindow::goTo);
    const auto showUnseen = [this] { m_panels.setUnseen(panel::messages, m_messageModel->unseen()); };
    connect(m_messageModel, &MessageModel::unseenChanged, this, showUnseen);
    showUnseen();
    connect(m_sequence, &SequenceView::terminalRequested, this, openChosen);
}

} // namespace codewheel
