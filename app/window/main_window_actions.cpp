// SPDX-License-Identifier: GPL-3.0-or-later
// What the actions of the window do, and when they can be had.
#include "app/window/help.h"
#include "app/window/leaving.h"
#include "app/window/main_window.h"
#include "app/window/panels.h"
#include "app/window/serial_line.h"
#include "bus/buses.h"
#include "bus/word_channel.h"
#include "ring/bus_session.h"
#include "widgets/master/master_panel.h"
#include "widgets/messages/messages_view.h"
#include "widgets/monitor/monitor_area.h"
#include "widgets/trace/trace_view.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>

#include <algorithm>

namespace codewheel {

void MainWindow::connectActions()
{
    const auto withBus = [this](auto what) {
        return [this, what] {
            if (m_bus != nullptr)
                what(*m_bus);
        };
    };
    connect(m_actions.quit, &QAction::triggered, this, &QWidget::close);
    connect(m_actions.watch, &QAction::triggered, this, [this] { setOperate(false); });
    connect(m_actions.operate, &QAction::triggered, this, [this] { setOperate(true); });
    connect(m_actions.start, &QAction::triggered, this,
            withBus([](BusSession &bus) { bus.setRunning(true); }));
    connect(m_actions.alarmStop, &QAction::triggered, this, &MainWindow::alarmStop);
    connect(m_actions.stop, &QAction::triggered, this,
            [this] { m_leaving->ask(Leaving::Why::stop, {m_bus}, [this] { m_bus->setRunning(false); }); });
    connect(m_actions.switchSegment, &QAction::triggered, this, [this] {
        if (const auto number = currentNumber(); number && !number->isOnLine())
            m_master->toggleSegment(DeviceNumber::of(number->node).segment);
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
        const auto number = currentNumber();
        WordChannel *channel = number ? m_buses->channel(*number) : nullptr;
        if (const auto sent = channel ? channel->zero() : Result<void>(); !sent)
            tell({.place = number, .severity = Severity::attention, .refusal = sent.error()});
    });
    connect(m_actions.exportTrace, &QAction::triggered, this, [this] { m_trace->exportRows(); });
    connect(m_actions.exportMessages, &QAction::triggered, this, [this] { m_messages->exportRows(); });
}

// One decision for all buses.
void MainWindow::setOperate(bool on)
{
    if (m_buses != nullptr)
        m_buses->setOperate(on);
}

void MainWindow::alarmStop()
{
    if (m_buses != nullptr)
        m_buses->alarmStop();
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
    connect(m_actions.keys, &QAction::triggered, this, [this] { showKeys(*this); });
    connect(m_actions.about, &QAction::triggered, this, [this] { showAbout(*this); });
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
    const auto open = m_buses == nullptr ? std::vector<EncoderBus *>() : m_buses->open();
    const bool operating = std::ranges::any_of(open, &EncoderBus::isOperating);
    m_actions.watch->setEnabled(!open.empty());
    m_actions.operate->setEnabled(!open.empty());
    m_actions.watch->setChecked(!operating);
    m_actions.operate->setChecked(operating);
    m_actions.start->setEnabled(connected && !running);
    m_actions.stop->setEnabled(running);
    const bool hasMaster = connected && m_bus->master() != nullptr;
    m_actions.confirmDiagnostics->setEnabled(hasMaster);
    m_actions.switchSegment->setEnabled(hasMaster);
    m_actions.alarmStop->setEnabled(!open.empty());
    for (QAction *monitor : {m_actions.openIn32, m_actions.openOut32, m_actions.openIn16})
        monitor->setEnabled(connected);
    m_actions.exportReport->setEnabled(m_bus != nullptr);
    m_actions.exportTrace->setEnabled(m_bus != nullptr);
    m_actions.exportMessages->setEnabled(m_bus != nullptr);
}

} // namespace codewheel
