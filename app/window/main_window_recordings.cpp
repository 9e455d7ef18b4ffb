// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings in the window: opened from a file, shown as buses, closed.
#include "app/window/buses/device_choice.h"
#include "app/window/buses/plant.h"
#include "app/window/main_window.h"
#include "app/window/recording/recordings.h"
#include "bus/buses.h"
#include "vocabulary/refusal_text.h"
#include "widgets/look/inline_message.h"
#include "widgets/structure/structure_view.h"

#include <QAction>
#include <QFileDialog>

#include <algorithm>

namespace codewheel {

void MainWindow::connectRecordings()
{
    connect(m_actions.openRecording, &QAction::triggered, this, [this] {
        const QString path = QFileDialog::getOpenFileName(this, tr("Open a recording"), {},
                                                          tr("Recordings (*.cwrec);;All files (*)"));
        if (!path.isEmpty())
            openRecording(path);
    });
    connect(
        m_actions.closeRecording, &QAction::triggered, this,
        [this] { m_plant->recordings().close(m_chosenBus); },
        Qt::QueuedConnection); // its bar, whose button it may be, goes with it
}

bool MainWindow::openRecording(const QString &path)
{
    const auto opened = m_plant->recordings().open(path);
    if (!opened) {
        m_notice->showMessage(Role::fault, refusalText(opened.error()));
        return false;
    }
    if (const auto encoder = recordedEncoder(*opened))
        m_structure->choose(*encoder);
    else
        m_structure->choose(*opened);
    showMonitors();
    return true;
}

// What the panels show under the bar of a recording is of that recording: the encoder that they show now, if
// it was recorded, or else the first one.
std::optional<Place> MainWindow::recordedEncoder(BusId opened) const
{
    for (const Recordings::Open &recording : m_plant->recordings().all())
        if (std::ranges::find(recording.buses, opened, &std::pair<BusId, BusId>::second) !=
            recording.buses.end())
            if (const auto shown = m_choice->place() ? recording.shown(*m_choice->place()) : std::nullopt;
                shown && m_buses->encoder(*shown) != nullptr)
                return shown;
    const std::vector<Place> places = m_buses->open(opened)->places();
    const auto first =
        std::ranges::find_if(places, [this](Place place) { return m_buses->encoder(place) != nullptr; });
    return first == places.end() ? std::nullopt : std::optional(*first);
}

} // namespace codewheel
