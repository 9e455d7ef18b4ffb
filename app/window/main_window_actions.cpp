// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/buses/bus_views.h"
#include "app/window/buses/device_choice.h"
#include "app/window/buses/leaving.h"
#include "app/window/buses/plant.h"
#include "app/window/files/support_dialog.h"
#include "app/window/help/key_sheet.h"
#include "app/window/look/bottom_fold.h"
#include "app/window/look/page_head.h"
#include "app/window/look/status_line.h"
#include "app/window/look/window_layouts.h"
#include "app/window/main_window.h"
#include "bus/bus_outline.h"
#include "bus/buses.h"
#include "bus/word_channel.h"
#include "widgets/cams/cam_editor.h"
#include "widgets/help/help_topic.h"
#include "widgets/input/text_fields.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/messages/message_model.h"
#include "widgets/messages/messages_view.h"
#include "widgets/monitor/monitor_area.h"
#include "widgets/trace/trace_view.h"
#include "widgets/trend/trend_page.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QMessageBox>

namespace codewheel {
namespace {

// Version and licence.
void showAbout(QMainWindow &window)
{
    QMessageBox box(
        QMessageBox::NoIcon, MainWindow::tr("About Codewheel"),
        MainWindow::tr(
            "<h3>Codewheel %1</h3><p>Sets up, watches and diagnoses absolute encoders on INTERBUS.</p>"
            "<p>Free software under the GNU General Public License, version 3 or later. It comes without any "
            "warranty.</p>")
            .arg(QApplication::applicationVersion()),
        QMessageBox::Ok, &window);
    setHelpTopic(box, "README.md");
    box.setIconPixmap(QApplication::windowIcon().pixmap(grid::largeIcon));
    box.exec();
}

} // namespace

void MainWindow::connectActions()
{
    connect(m_actions.quit, &QAction::triggered, this, &QWidget::close);
    const auto onChosen = [this](QAction *action, auto what) {
        connect(action, &QAction::triggered, this, [this, what] {
            if (EncoderBus *bus = chosenBus())
                what(*bus);
        });
    };
    onChosen(m_actions.watch, [](EncoderBus &bus) { bus.setOperate(false); });
    onChosen(m_actions.operate, [this](EncoderBus &bus) { operate(bus); });
    onChosen(m_actions.start, [](EncoderBus &bus) { bus.setRunning(true); });
    onChosen(m_actions.stop, [this](EncoderBus &bus) {
        m_leaving->ask(Leaving::Why::stop, {&bus}, [&bus] { bus.setRunning(false); });
    });
    connect(m_actions.alarmStop, &QAction::triggered, this, &MainWindow::alarmStop);
    connect(m_actions.settings, &QAction::triggered, this, &MainWindow::settingsRequested);
    connect(m_actions.wizard, &QAction::triggered, this, &MainWindow::showWizard);
    connect(m_actions.monitors, &QAction::triggered, this, &MainWindow::showMonitors);
    connect(m_actions.trend, &QAction::triggered, this, &MainWindow::showTrend);
    connect(m_actions.closePage, &QAction::triggered, m_head, &PageHead::closePage);
    connect(m_actions.cams, &QAction::triggered, this, &MainWindow::showCams);
    connect(m_actions.structureEditor, &QAction::triggered, this, &MainWindow::showStructureEditor);
    connect(m_actions.compare, &QAction::triggered, this, &MainWindow::showComparison);
    connect(m_actions.projectPage, &QAction::triggered, this, &MainWindow::showProjectPage);
    const auto onMonitor = [this](QAction *action, void (MonitorArea::*what)(Place)) {
        connect(action, &QAction::triggered, this, [this, what] {
            if (const auto place = currentNumber()) {
                showMonitors();
                (m_monitors->*what)(*place);
            }
        });
    };
    onMonitor(m_actions.openMonitor, &MonitorArea::open);
    onMonitor(m_actions.pinMonitor, &MonitorArea::pin);
    connect(m_actions.showInTrend, &QAction::triggered, this, [this] {
        if (const auto place = currentNumber())
            showInTrend({*place, Channel::position, {}});
    });
    connect(m_actions.zeroOut, &QAction::triggered, this, [this] {
        if (WordChannel *words = chosenWords())
            if (const auto sent = words->zero(); !sent)
                tell({.place = words->place(), .severity = Severity::attention, .refusal = sent.error()});
    });
    connect(m_actions.exportTrace, &QAction::triggered, this, [this] { m_trace->exportRows(); });
    connect(m_actions.exportMessages, &QAction::triggered, this, [this] { m_messages->exportRows(); });
}

// Until it is so, Watch stays the one that is chosen.
void MainWindow::operate(EncoderBus &bus)
{
    if (BusViews *views = viewsOf(bus.id()))
        views->askToOperate([&bus] { bus.setOperate(true); });
    else
        bus.setOperate(true);
    showBusState();
}

void MainWindow::alarmStop()
{
    if (m_buses != nullptr)
        m_buses->alarmStop();
}

void MainWindow::showSettings()
{
    const ProgramSettings choices = m_settings.choices();
    m_actions.scheme->actions().at(static_cast<int>(choices.appearance.scheme))->setChecked(true);
    m_actions.largeControls->setChecked(choices.appearance.largeControls);
    m_actions.lessMotion->setChecked(choices.appearance.lessMotion);
    setAnimated(!choices.appearance.lessMotion);
    for (QAction *language : m_actions.language->actions())
        language->setChecked(language->data().toString() == choices.language);
    if (m_trace != nullptr)
        m_trace->setMostRows(choices.traceRows);
    for (const auto &[bus, views] : m_views)
        views->useSettings(choices);
    if (m_plant != nullptr)
        m_plant->histories().setLimit(static_cast<std::size_t>(choices.trendMemory) << 20);
}

void MainWindow::connectViewActions()
{
    showSettings();

    const auto change = [this] {
        const Appearance chosen{.scheme =
                                    static_cast<Scheme>(m_actions.scheme->checkedAction()->data().toInt()),
                                .largeControls = m_actions.largeControls->isChecked(),
                                .lessMotion = m_actions.lessMotion->isChecked()};
        ProgramSettings choices = m_settings.choices();
        choices.appearance = chosen;
        m_settings.setChoices(choices);
        setAnimated(!chosen.lessMotion);
        applyAppearance(*qApp, chosen);
        Q_EMIT appearanceChosen();
    };
    connect(m_actions.scheme, &QActionGroup::triggered, this, change);
    connect(m_actions.largeControls, &QAction::triggered, this, change);
    connect(m_actions.lessMotion, &QAction::triggered, this, change);
    connect(m_actions.language, &QActionGroup::triggered, this,
            [this](const QAction *language) { Q_EMIT languageChosen(language->data().toString()); });
    connect(m_actions.foldBottom, &QAction::triggered, this, [this](bool on) {
        m_keepsBottomFolded = on;
        on ? m_panels.fold().fold() : m_panels.fold().unfold();
    });
    connect(m_actions.defaultLayout, &QAction::triggered, this, [this] {
        if (m_layouts != nullptr)
            m_layouts->useDefault();
    });
    connect(m_actions.keys, &QAction::triggered, this, [this] {
        if (m_cams)
            m_cams->page(); // its keys are listed, too
        KeySheet::show(*this);
    });
    connect(m_actions.collectSupport, &QAction::triggered, this, &MainWindow::collectForSupport);
    connect(m_actions.about, &QAction::triggered, this, [this] { showAbout(*this); });
}

void MainWindow::collectForSupport()
{
    takeFocusedField();
    m_messageModel->refresh();
    auto *dialog = new SupportDialog(supportFiles({m_project, *m_plant, *m_messageModel, *m_trace}), this);
    connect(dialog, &SupportDialog::saved, this, [this](const QString &path) {
        m_notice->showMessage(Role::running, tr("Saved for support: %1").arg(path));
    });
    dialog->open();
}

void MainWindow::showBusState()
{
    const bool isAttached = m_plant != nullptr;
    for (QAction *action :
         {m_actions.findEncoders, m_actions.projectPage, m_actions.structureEditor, m_actions.compare,
          m_actions.transfer, m_actions.exportReport, m_actions.exportMessages, m_actions.collectSupport,
          m_actions.record, m_actions.print, m_actions.whyNoData})
        action->setEnabled(isAttached);
    const EncoderBus *chosen = chosenBus();
    const bool isOpen = chosen != nullptr && chosen->isOpen();
    const bool isThere = chosen != nullptr && chosen->state() == BusState::open; // its link is not lost
    const bool isOperating = isOpen && chosen->isOperating();
    const bool isReplay = isOpen && chosen->isReplay();
    for (const auto &[bus, its] : m_views)
        its->setRecordingChosen(isReplay);
    m_actions.watch->setEnabled(isOpen && !isReplay);
    m_actions.operate->setEnabled(isThere && !isReplay);
    m_actions.openRecording->setEnabled(isAttached);
    m_actions.closeRecording->setEnabled(isReplay);
    m_actions.watch->setChecked(!isOperating);
    m_actions.operate->setChecked(isOperating);
    m_actions.start->setEnabled(isThere && !isReplay && !chosen->isRunning());
    m_actions.stop->setEnabled(isOpen && !isReplay && chosen->isRunning());
    const BusViews *views = viewsOf(m_chosenBus);
    const bool tellsState = views == nullptr || views->tellsState();
    if (isReplay)
        m_status->setRecorded(m_plant->nameOf(m_chosenBus));
    else
        m_status->setMode(isOperating, tellsState ? QString() : m_plant->nameOf(m_chosenBus));
    if (views != nullptr && views->comparison() == nullptr)
        m_actions.compare->setEnabled(false);
    const auto open = isAttached ? m_buses->connected() : std::vector<EncoderBus *>();
    QStringList names;
    QStringList effects;
    for (const EncoderBus *bus : open) {
        names << m_plant->nameOf(bus->id());
        effects << QStringLiteral("%1: %2").arg(names.back(), bus->outline().alarmStop());
    }
    m_actions.tellMode(open.size() > 1 ? m_plant->nameOf(m_chosenBus) : QString());
    m_actions.alarmStop->setEnabled(!open.empty());
    m_actions.showAlarmStop(names, effects);
    tellWhose();
    showWordActions();
}

WordChannel *MainWindow::chosenWords() const
{
    const auto place = currentNumber();
    return place ? m_buses->channel(*place) : nullptr;
}

// They apply to the device that is shown, which may be on a bus other than that of the chosen row.
void MainWindow::showWordActions()
{
    const auto place = currentNumber();
    m_actions.showWords(place ? m_choice->encoder() : ShownEncoder(), chosenWords(),
                        place && m_buses->open(place->bus) != nullptr);
}

} // namespace codewheel
