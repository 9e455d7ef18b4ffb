// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings in the window: opened from a file, shown as buses, closed.
#include "app/window/main_window.h"
#include "app/window/plant.h"
#include "app/window/recordings.h"
#include "encoder/refusal_text.h"
#include "widgets/look/inline_message.h"
#include "widgets/structure/structure_view.h"

#include <QAction>
#include <QFileDialog>

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
    m_structure->choose(*opened);
    showMonitors();
    return true;
}

} // namespace codewheel
