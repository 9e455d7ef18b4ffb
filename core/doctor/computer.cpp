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
namespace {

constexpr qint64 mostContents = 65'536;

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
    return file.open(QIODevice::ReadOnly) ? file.read(mostContents).trimmed() : QByteArray();
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

Process Computer::process(int id) const
{
    return {id, QString::fromLocal8Bit(contents(QStringLiteral("/proc/%1/comm").arg(id))),
            m_root.isEmpty() && id == ::getpid()};
}

std::vector<Process> Computer::processes() const
{
    std::vector<Process> all;
    for (const QString &name : folders(QStringLiteral("/proc"))) {
        bool isNumber = false;
        const int id = name.toInt(&isNumber);
        if (isNumber)
            all.push_back(process(id));
    }
    std::ranges::sort(all, {}, &Process::id);
    return all;
}

std::vector<Process> Computer::holdersOf(const QString &path) const
{
    const QString device = has(path) ? canonical(path) : path;
    std::vector<Process> holders = processes();
    std::erase_if(holders, [&](const Process &its) {
        const QString files = QStringLiteral("/proc/%1/fd").arg(its.id);
        const QStringList numbers =
            QDir(m_root + files).entryList(QDir::AllEntries | QDir::System | QDir::NoDotAndDotDot);
        return std::ranges::none_of(
            numbers, [&](const QString &number) { return target(files + u'/' + number) == device; });
    });
    return holders;
}

bool Computer::runs(const QString &program) const
{
    const auto all = processes();
    return std::ranges::find(all, program, &Process::name) != all.end();
}

} // namespace codewheel
