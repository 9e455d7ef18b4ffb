// SPDX-License-Identifier: GPL-3.0-or-later
// The serial line in the window.
#include "app/window/device_choice.h"
#include "app/window/main_window.h"
#include "app/window/serial_line.h"
#include "app/window/status_line.h"
#include "ring/bus_session.h"
#include "widgets/models/connected_encoders.h"
#include "widgets/structure/structure_view.h"

namespace codewheel {

namespace {

std::optional<DeviceNumber> firstOf(const RingStructure &ring)
{
    return ring.empty() ? std::nullopt : std::optional(ring.front().number);
}

} // namespace

void MainWindow::connectLine()
{
    connect(m_line, &SerialLine::aboutToChange, this, &MainWindow::leaveLine);
    connect(m_line, &SerialLine::changed, this, &MainWindow::showLine);
    showLine();
}

// Its encoders are about to go; the panels show one of the ring then.
void MainWindow::leaveLine()
{
    const auto chosen = m_choice->number();
    m_connected->setLine(nullptr);
    m_structure->setLine(nullptr);
    m_status->setLine(nullptr);
    if (chosen && chosen->isOnLine())
        m_choice->choose(firstOf(m_bus->structure()));
}

void MainWindow::showLine()
{
    LineSession *line = m_line->session();
    m_connected->setLine(line);
    m_structure->setLine(line);
    m_status->setLine(line);
    if (line != nullptr)
        connect(line, &LineSession::stateChanged, this, &MainWindow::showBusState);
    showBusState();
}

} // namespace codewheel
