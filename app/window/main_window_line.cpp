// SPDX-License-Identifier: GPL-3.0-or-later
// The serial line in the window.
#include "app/window/device_choice.h"
#include "app/window/line_views.h"
#include "app/window/main_window.h"
#include "app/window/serial_line.h"
#include "app/window/status_line.h"
#include "bus/buses.h"
#include "ring/bus_session.h"
#include "widgets/line/line_panel.h"
#include "widgets/line/line_terminal.h"
#include "widgets/look/inline_message.h"
#include "widgets/sequence/sequence_view.h"
#include "widgets/structure/structure_view.h"
#include "widgets/trace/trace_view.h"
#include "widgets/training/training_panel.h"

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QVBoxLayout>

namespace codewheel {

namespace {

std::optional<Place> firstOf(const EncoderBus &bus)
{
    const std::vector<Place> places = bus.places();
    return places.empty() ? std::nullopt : std::optional(places.front());
}

} // namespace

void MainWindow::makeLineViews()
{
    auto *notice = new InlineMessage(this);
    notice->setObjectName(QStringLiteral("lineNotice"));
    static_cast<QVBoxLayout *>(centralWidget()->layout())->insertWidget(0, notice);
    m_lineViews = new LineViews(*m_line, m_project, m_settings, *m_leaving, m_actions, *m_pages, *notice);
    connect(m_lineViews, &LineViews::terminalRequested, this, [this] {
        showDock("terminalDock");
        makeRoomForTerminal();
        m_lineViews->terminal().setFocus();
    });
    connect(m_lineViews, &LineViews::panelRequested, this, [this] {
        showDock("lineDock");
        m_lineViews->panel().setFocus();
    });
    // One decision for both, and Watch after every connection but the training bus.
    connect(m_lineViews, &LineViews::portConnected, this, [this] { setOperate(false); });
    connect(m_lineViews, &LineViews::fractionBitsRequested, this,
            [this] { m_lineViews->determineFractionBits(currentNumber()); });
    connect(m_lineViews, &LineViews::removalRequested, this, [this] {
        if (const auto number = currentNumber(); number && number->isOnLine())
            m_lineViews->remove(*number);
    });
    connect(m_lineViews, &LineViews::warningBytesRequested, this, [this](bool swapped) {
        if (const auto number = currentNumber(); number && number->isOnLine())
            m_lineViews->swapWarningBytes(*number, swapped);
    });
}

// So that some rows are seen; whoever has more room for it keeps that.
void MainWindow::makeRoomForTerminal()
{
    auto *dock = findChild<QDockWidget *>(QStringLiteral("terminalDock"));
    const int wanted = height() / 3;
    if (!dock->isFloating() && dock->height() < wanted)
        resizeDocks({dock}, {wanted}, Qt::Vertical);
}

void MainWindow::connectLine()
{
    connect(m_line, &SerialLine::aboutToChange, this, &MainWindow::leaveLine);
    connect(m_line, &SerialLine::changed, this, &MainWindow::showLine);
    connect(m_structure, &StructureView::busOpened, this, [this](BusId bus) {
        if (bus == firstLine)
            Q_EMIT m_lineViews->panelRequested();
    });
    connect(m_structure, &StructureView::busMenuRequested, this, [this](BusId bus, const QPoint &position) {
        if (bus == firstLine)
            m_actions.lineMenu->popup(position);
    });
    connect(m_structure, &StructureView::busChosen, m_trainingPanel, [this](BusId bus) {
        if (bus == firstLine)
            m_trainingPanel->setDevice({bus, {}});
    });
    connect(m_trace, &TraceView::terminalRequested, m_actions.lineTerminal, &QAction::trigger);
    connect(m_sequence, &SequenceView::terminalRequested, m_actions.lineTerminal, &QAction::trigger);
    showLine();
}

// Its encoders are about to go; the panels show one of the ring then.
void MainWindow::leaveLine()
{
    const auto chosen = m_choice->place();
    m_buses->remove(m_line->session());
    m_structure->removeBus(firstLine);
    m_status->setLine(nullptr);
    m_trainingPanel->setLine(nullptr);
    m_lineViews->setLine(nullptr);
    if (chosen && chosen->isOnLine())
        m_choice->choose(firstOf(*m_bus));
}

void MainWindow::showLine()
{
    LineSession *line = m_line->session();
    if (line != nullptr)
        m_buses->add(*line);
    if (line != nullptr)
        m_structure->addBus(*line);
    m_status->setLine(line);
    m_trainingPanel->setLine(m_line->training());
    m_lineViews->setLine(line);
    if (line != nullptr) {
        connect(line, &LineSession::explainOptionsChanged, this,
                [this] { m_actions.showChosen(m_choice->encoder()); });
    }
    showBusState();
}

} // namespace codewheel
