// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/folder_lock.h"

#include <QFile>
#include <QFileInfo>

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <thread>
#include <unistd.h>

namespace codewheel {
namespace {

constexpr std::chrono::milliseconds betweenLockTries{2};

} // namespace

FolderLock::FolderLock(const QString &file)
    : m_folder(::open(QFile::encodeName(QFileInfo(file).absolutePath()).constData(),
                      O_RDONLY | O_DIRECTORY | O_CLOEXEC))
{
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + longestWait;
    while (m_folder >= 0 && ::flock(m_folder, LOCK_EX | LOCK_NB) != 0) {
        if (errno != EWOULDBLOCK && errno != EINTR)
            return;
        if (m_isRefused = Clock::now() >= end; m_isRefused)
            return;
        std::this_thread::sleep_for(betweenLockTries);
    }
}

FolderLock::~FolderLock()
{
    if (m_folder >= 0)
        ::close(m_folder);
}

} // namespace codewheel
