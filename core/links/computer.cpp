// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/computer.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <unistd.h>
#include <utility>

namespace codewheel {
namespace {

// Of a device "4:64", as /proc/PID/stat has it.
int terminalNumber(const QByteArray &device)
{
    constexpr int low = 0xff; // the bits of the minor number that are below the major one
    const int major = device.split(':').value(0).toInt();
    const int minor = device.split(':').value(1).toInt();
    return (minor & low) | (major << 8) | ((minor & ~low) << 12);
}

bool hasOpen(const RunningProcess &process, const QByteArray &device)
{
    return std::ranges::find(process.devices, device) != process.devices.end();
}

bool makesPseudoTerminals(const RunningProcess &process)
{
    return hasOpen(process, "/dev/ptmx") || hasOpen(process, "/dev/pts/ptmx");
}

} // namespace

Computer::Computer(QString root)
    : m_root(std::move(root))
{}

bool Computer::has(const QString &path) const
{
    return QFileInfo::exists(m_root + path);
}

QByteArray Computer::contents(const QString &path) const
{
    QFile file(m_root + path);
    return file.open(QIODevice::ReadOnly) ? file.readAll().trimmed() : QByteArray();
}

QStringList Computer::folders(const QString &path) const
{
    return QDir(m_root + path).entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name);
}

// As the kernel says it: for what is deleted or no file at all, Qt says something else.
QString Computer::target(const QString &path) const
{
    std::array<char, 4'096> text{};
    const auto length = ::readlink(QFile::encodeName(m_root + path).constData(), text.data(), text.size());
    return length < 0 ? QString() : QFile::decodeName(QByteArray(text.data(), length));
}

QString Computer::canonical(const QString &path) const
{
    const QString whole = QFileInfo(m_root + path).canonicalFilePath();
    if (whole.isEmpty())
        return path;
    const QString root = m_root.isEmpty() ? QString() : QFileInfo(m_root).canonicalFilePath();
    return whole.startsWith(root) ? whole.mid(root.size()) : whole;
}

// Its folder lets only the owner of a file remove it.
bool Computer::mayRemove(const QString &path) const
{
    return ::geteuid() == 0 || QFileInfo(m_root + path).ownerId() == ::geteuid();
}

const std::vector<RunningProcess> &Computer::running() const
{
    if (!m_running)
        m_running = runningProcesses(QFile::encodeName(m_root));
    return *m_running;
}

Process Computer::told(const RunningProcess &process) const
{
    return {process.id, QString::fromLocal8Bit(process.name), m_root.isEmpty() && process.id == ::getpid(),
            !process.isSeen};
}

std::vector<Process> Computer::holdersOf(const QString &path) const
{
    const QString device = canonical(path);
    const QByteArray name = QFile::encodeName(device);
    const int number =
        terminalNumber(contents(QStringLiteral("/sys/class/tty/%1/dev").arg(device.section(u'/', -1))));
    const bool isPseudoTerminal = name.startsWith("/dev/pts/");
    std::vector<Process> holders;
    for (const RunningProcess &its : running()) {
        const Process holder = told(its);
        const bool isOtherEnd = isPseudoTerminal && !holder.isOurs && makesPseudoTerminals(its);
        if (!isOtherEnd && (hasOpen(its, name) || (number != 0 && its.terminal == number)))
            holders.push_back(holder);
    }
    return holders;
}

std::optional<Process> Computer::process(int id) const
{
    const auto found = std::ranges::find(running(), id, &RunningProcess::id);
    return found == running().end() ? std::nullopt : std::optional(told(*found));
}

bool Computer::exists(int id) const
{
    return process(id) || (m_root.isEmpty() && (::kill(id, 0) == 0 || errno != ESRCH));
}

bool Computer::runs(const QString &program) const
{
    const QByteArray name = program.toLocal8Bit();
    return std::ranges::find(running(), name, &RunningProcess::name) != running().end();
}

} // namespace codewheel
