// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/training_window.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int framePeriod = 33; // ms

// Far from the end of a long time most frames are left out, as by a slow computer: showing them is most of
// the work.
constexpr int nearEnd = 330; // ms
constexpr int shownOf = 5;

} // namespace

TrainingWindow::TrainingWindow(const QString &settingsFile, QSize size)
    : m_settings(settingsFile)
    , m_plant({.catalog = m_catalog,
               .project = m_project,
               .dataFolder = QFileInfo(settingsFile).absolutePath(),
               .byThread = false,
               .clock = begin})
{
    QObject::connect(&m_plant, &Plant::messaged, &m_messages, &MessageModel::add);
    m_plant.openTraining();
    m_messages.setClock(bus());
    m_window = std::make_unique<MainWindow>(m_settings, m_project);
    if (size.isValid())
        m_window->resize(size);
    m_window->attach(m_plant, m_messages);
    advance(framePeriod);
}

TrainingWindow::~TrainingWindow() = default;

void TrainingWindow::advance(int milliseconds)
{
    for (int frame = 1; milliseconds > 0; ++frame) {
        const int step = std::min(milliseconds, framePeriod);
        for (const BusAtWork *bus : m_plant.all())
            if (EncoderBus *its = bus->bus())
                its->advance(std::chrono::milliseconds(step));
        milliseconds -= step;
        if (milliseconds > nearEnd && frame % shownOf != 0)
            continue;
        m_window->showFrame();
        QCoreApplication::processEvents();
    }
    m_messages.catchUp();
}

QDateTime TrainingWindow::begin()
{
    return QDateTime(QDate(2026, 3, 2), QTime(14, 2, 0));
}

} // namespace codewheel
