// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/busy_wait.h"

#include <QFile>

#include <sys/stat.h>
#include <utility>

namespace codewheel {

BusyWait::BusyWait(QString file)
    : m_file(std::move(file))
{
    (void)hasChanged();
}

bool BusyWait::goesOn()
{
    const auto now = Clock::now();
    if (hasChanged())
        m_lastChange = now;
    return now - m_lastChange < longestStandstill && now - m_begun < longest;
}

// Since the last call.
bool BusyWait::hasChanged()
{
    struct stat told = {};
    if (m_file.isEmpty() || ::stat(QFile::encodeName(m_file).constData(), &told) != 0)
        return false;
    const timespec before = std::exchange(m_changed, told.st_mtim);
    return before.tv_sec != m_changed.tv_sec || before.tv_nsec != m_changed.tv_nsec;
}

} // namespace codewheel
