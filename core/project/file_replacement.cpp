// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/file_replacement.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace codewheel {
namespace {

// Why nothing may replace what is there; empty if something may.
QString whyNotReplaceable(const QString &path)
{
    struct stat there = {};
    if (::stat(QFile::encodeName(path).constData(), &there) != 0)
        return errno == ENOENT ? QString() : qt_error_string(errno);
    return S_ISREG(there.st_mode) ? QString()
                                  : QCoreApplication::translate("codewheel::FileAccess", "It is not a file.");
}

bool writeAll(int file, QByteArrayView bytes)
{
    while (!bytes.isEmpty()) {
        const ssize_t written = ::write(file, bytes.data(), static_cast<std::size_t>(bytes.size()));
        if (written < 0 && errno != EINTR)
            return false;
        bytes = bytes.sliced(std::max<ssize_t>(written, 0));
    }
    return true;
}

// Makes sure that the new name is on the disk too. Some file systems do not support it.
void syncFolder(const QString &path)
{
    const int folder = ::open(QFile::encodeName(QFileInfo(path).absolutePath()).constData(),
                              O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0)
        return;
    ::fsync(folder);
    ::close(folder);
}

// Before anything is written the folder or the name is to blame, after that the disk.
tl::unexpected<Refusal> notReplaced(RefusalKind kind, const QString &path, const QString &reason)
{
    return refuse(kind, RefusalId::fileNotWritten, {path, reason});
}

} // namespace

FileReplacement::FileReplacement(const QString &path)
    : m_file(path)
{}

Result<void> FileReplacement::begin()
{
    if (const QString why = whyNotReplaceable(path()); !why.isEmpty())
        return notReplaced(RefusalKind::badInput, path(), why);
    if (!m_file.open(WriteOnly))
        return notReplaced(RefusalKind::badInput, path(), m_file.errorString());
    open(WriteOnly | Unbuffered);
    return {};
}

Result<void> FileReplacement::bringToDisk()
{
    if (!m_failure && ::fsync(m_file.handle()) != 0)
        return noteFailure(qt_error_string(errno));
    return m_failure ? Result<void>(tl::unexpected(*m_failure)) : Result<void>();
}

Result<void> FileReplacement::replace()
{
    if (auto isThere = bringToDisk(); !isThere)
        return isThere;
    close();
    if (!m_file.commit())
        return noteFailure(m_file.errorString());
    syncFolder(path());
    return {};
}

// QSaveFile would not report a full disk.
qint64 FileReplacement::writeData(const char *bytes, qint64 count)
{
    if (m_failure)
        return -1;
    if (writeAll(m_file.handle(), QByteArrayView(bytes, count)))
        return count;
    static_cast<void>(noteFailure(qt_error_string(errno)));
    return -1;
}

Result<void> FileReplacement::noteFailure(const QString &reason)
{
    setErrorString(reason);
    const auto refused = notReplaced(RefusalKind::link, path(), reason);
    m_failure = refused.value();
    return refused;
}

} // namespace codewheel
