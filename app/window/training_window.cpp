// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/training_window.h"

#include "app/window/project_account.h"
#include "project/project_take_over.h"
#include "ring/bus_session.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int picturePeriod = 33; // ms

} // namespace

TrainingWindow::TrainingWindow(const QString &settingsFile, QSize size)
    : m_settings(settingsFile)
    , m_training(openTrainingSession(m_catalog, begin()))
    , m_line(m_catalog, m_project, QFileInfo(settingsFile).absolutePath(), LineSession::Drive::byHand, begin)
    , m_ledger(*m_training.bus, DatabasePlace::memory())
    , m_positions(*m_training.bus)
{
    m_messages.setBus(*m_training.bus);
    QObject::connect(&m_ledger, &LedgerKeeper::messaged, &m_messages, &MessageModel::addNow);
    QObject::connect(&m_line, &SerialLine::messaged, &m_messages, &MessageModel::add);
    keepAccountOf(m_project, m_ledger);
    m_line.openTraining();
    m_project.setProject(projectOf(m_training.bus->structure()), {});
    m_window = std::make_unique<MainWindow>(m_settings, m_project);
    if (size.isValid())
        m_window->resize(size);
    m_window->attach({.bus = *m_training.bus,
                      .link = MainWindow::tr("training bus"),
                      .training = m_training.controls,
                      .line = m_line,
                      .messages = m_messages,
                      .ledger = m_ledger,
                      .positions = m_positions});
    advance(picturePeriod);
}

TrainingWindow::~TrainingWindow() = default;

void TrainingWindow::advance(int milliseconds)
{
    while (milliseconds > 0) {
        const int step = std::min(milliseconds, picturePeriod);
        m_training.bus->advance(step);
        if (LineSession *line = m_line.session())
            line->advance(std::chrono::milliseconds(step));
        m_window->showPicture();
        QCoreApplication::processEvents();
        milliseconds -= step;
    }
    m_messages.catchUp();
}

QDateTime TrainingWindow::begin()
{
    return QDateTime(QDate(2026, 3, 2), QTime(14, 2, 0));
}

} // namespace codewheel
