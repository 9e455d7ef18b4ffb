// SPDX-License-Identifier: GPL-3.0-or-later
#include "doctor/computer.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <unistd.h>
#include <utility>

namespace codewheel {
namespace {

constexpr qint64 mostContents = 1 << 20;

// Names that are numbers, in order; empty where we may not look. Nothing else is looked at: there may be
// thousands.
std::vector<int> numbersIn(const QString &folder)
{
    std::vector<int> numbers;
    std::error_code error;
    const std::filesystem::path path = QFile::encodeName(folder).toStdString();
    for (std::filesystem::directory_iterator entry(path, error); !error && entry != end(entry);
         entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        int number = 0;
        const auto read = std::from_chars(name.data(), name.data() + name.size(), number);
        if (read.ec == std::errc() && read.ptr == name.data() + name.size())
            numbers.push_back(number);
    }
    std::ranges::sort(numbers);
    return numbers;
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
    for (const int id : numbersIn(m_root + QStringLiteral("/proc")))
        all.push_back(process(id));
    return all;
}

std::vector<Process> Computer::holdersOf(const QString &path) const
{
    const QString device = has(path) ? canonical(path) : path;
    std::vector<Process> holders;
    for (const int id : numbersIn(m_root + QStringLiteral("/proc"))) {
        const QString files = QStringLiteral("/proc/%1/fd").arg(id);
        const auto isDevice = [&](int number) {
            return target(files + u'/' + QString::number(number)) == device;
        };
        if (std::ranges::any_of(numbersIn(m_root + files), isDevice))
            holders.push_back(process(id));
    }
    return holders;
}

bool Computer::runs(const QString &program) const
{
    const auto all = processes();
    return std::ranges::find(all, program, &Process::name) != all.end();
}

} // namespace codewheel
