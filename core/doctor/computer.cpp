// SPDX-License-Identifier: GPL-3.0-or-later
#include "doctor/computer.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <array>
#include <unistd.h>
#include <utility>

namespace codewheel {
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
    const QString root = m_root.isEmpty() ? QString() : QFileInfo(m_root).canonicalFilePath();
    return whole.startsWith(root) ? whole.mid(root.size()) : whole;
}

const std::vector<RunningProcess> &Computer::running() const
{
    if (!m_running)
        m_running = runningProcesses(QFile::encodeName(m_root));
    return *m_running;
}

Process Computer::told(const RunningProcess &process) const
{
    return {process.id, QString::fromLocal8Bit(process.name), m_root.isEmpty() && process.id == ::getpid()};
}

std::vector<Process> Computer::holdersOf(const QString &path) const
{
    const QByteArray device = QFile::encodeName(has(path) ? canonical(path) : path);
    std::vector<Process> holders;
    for (const RunningProcess &its : running())
        if (std::ranges::find(its.devices, device) != its.devices.end())
            holders.push_back(told(its));
    return holders;
}

bool Computer::runs(const QString &program) const
{
    const QByteArray name = program.toLocal8Bit();
    return std::ranges::find(running(), name, &RunningProcess::name) != running().end();
}

} // namespace codewheel
