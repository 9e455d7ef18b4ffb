// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/training_window.h"

#include "ring/bus_session.h"

#include <QCoreApplication>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int picturePeriod = 33; // ms

} // namespace

TrainingWindow::TrainingWindow(const QString &settingsFile)
    : m_settings(settingsFile)
    , m_training(openTrainingSession(m_catalog, begin()))
{
    m_messages.setBus(*m_training.bus);
    m_window = std::make_unique<MainWindow>(m_settings);
    m_window->attach(*m_training.bus, m_training.controls, MainWindow::tr("training bus"), m_messages);
    advance(picturePeriod);
}

TrainingWindow::~TrainingWindow() = default;

void TrainingWindow::advance(int milliseconds)
{
    while (milliseconds > 0) {
        const int step = std::min(milliseconds, picturePeriod);
        m_training.bus->advance(step);
        m_window->showPicture();
        QCoreApplication::processEvents();
        milliseconds -= step;
    }
}

QDateTime TrainingWindow::begin()
{
    return QDateTime(QDate(2026, 3, 2), QTime(14, 2, 0));
}

} // namespace codewheel
