// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/waiting_entries.h"

#include "journal/ledger_json.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QUuid>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace codewheel {
namespace {

const QString waitingName = QStringLiteral(".waiting-");
constexpr qint64 largestLeft = 64'000'000; // bytes

// Locked, and nobody has removed it meanwhile; otherwise -1.
int openLocked(const QString &path, int flags)
{
    const int file =
        ::open(QFile::encodeName(path).constData(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | flags, 0600);
    struct stat told = {};
    if (file >= 0 && ::flock(file, LOCK_EX | LOCK_NB) == 0 && ::fstat(file, &told) == 0 &&
        told.st_nlink > 0 && S_ISREG(told.st_mode))
        return file;
    if (file >= 0)
        ::close(file);
    return -1;
}

} // namespace

WaitingEntries::WaitingEntries(const QString &ledger)
{
    constexpr int tries = 10; // another program may take a new file for one left behind
    for (int i = 0; i < tries && m_file < 0; ++i) {
        m_path = ledger + waitingName + QUuid::createUuid().toString(QUuid::Id128);
        m_file = openLocked(m_path, O_CREAT | O_EXCL);
    }
    if (m_file < 0 || takeRoom())
        return;
    QFile::remove(m_path);
    ::close(std::exchange(m_file, -1));
}

// As much as there is.
bool WaitingEntries::takeRoom() const
{
    constexpr qint64 least = 1'024;
    for (qint64 size = room; size >= least; size /= 2)
        if (::posix_fallocate(m_file, 0, size) == 0)
            return true;
    return false;
}

WaitingEntries::~WaitingEntries()
{
    if (m_file < 0)
        return;
    if (m_used == 0)
        QFile::remove(m_path);
    else
        (void)!::ftruncate(m_file, m_used);
    ::close(m_file);
}

bool WaitingEntries::add(const Ledger::Record &record)
{
    const QByteArray line = recordsToJson({record}, true) + '\n';
    if (m_file < 0 || ::pwrite(m_file, line.constData(), static_cast<std::size_t>(line.size()), m_used) !=
                          static_cast<ssize_t>(line.size()))
        return false;
    m_used += line.size();
    return ::fdatasync(m_file) == 0;
}

LeftEntries::LeftEntries(const QString &path)
    : m_path(path)
    , m_file(openLocked(path, 0))
{}

LeftEntries::LeftEntries(LeftEntries &&other) noexcept
    : m_path(std::move(other.m_path))
    , m_file(std::exchange(other.m_file, -1))
{}

LeftEntries::~LeftEntries()
{
    if (m_file >= 0)
        ::close(m_file);
}

std::optional<std::vector<Ledger::Record>> LeftEntries::records() const
{
    QFile file;
    if (!file.open(m_file, QIODevice::ReadOnly) || file.size() > largestLeft)
        return std::nullopt;
    QByteArray text = file.readAll();
    if (const qsizetype end = text.indexOf('\0'); end >= 0) // space that was not used
        text.truncate(end);
    std::vector<Ledger::Record> all;
    for (const QByteArray &line : text.split('\n'))
        if (const auto records = recordsFromJson(line))
            all.insert(all.end(), records->begin(), records->end());
    return text.isEmpty() || !all.empty() ? std::optional(std::move(all)) : std::nullopt;
}

void LeftEntries::drop()
{
    QFile::remove(m_path);
}

QStringList LeftEntries::filesBeside(const QString &ledger)
{
    const QFileInfo info(ledger);
    QStringList paths;
    const QString begin = info.fileName() + waitingName;
    for (const QString &name : info.absoluteDir().entryList(QDir::Files | QDir::Hidden))
        if (name.startsWith(begin))
            paths << info.absoluteDir().filePath(name);
    return paths;
}

} // namespace codewheel
