// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/running_process.h"

#include <QFile>

#include <algorithm>
#include <array>
#include <dirent.h>
#include <memory>
#include <unistd.h>

namespace codewheel {
namespace {

// A folder whose names are read without a look at what is behind them, which takes long in /proc.
class Folder
{
public:
    explicit Folder(const QByteArray &path)
        : m_folder(::opendir(path.constData()))
    {}

    bool isOpen() const { return m_folder != nullptr; }
    int descriptor() const { return ::dirfd(m_folder.get()); }
    // Null behind the last one.
    const char *next()
    {
        const dirent *entry = m_folder != nullptr ? ::readdir(m_folder.get()) : nullptr;
        return entry != nullptr ? entry->d_name : nullptr;
    }

private:
    struct Close
    {
        void operator()(DIR *folder) const { ::closedir(folder); }
    };
    std::unique_ptr<DIR, Close> m_folder;
};

// "4711 (minicom) S 1 4711 4711 34816 ...": the name may have blanks and parentheses in it.
void takeStat(const QByteArray &folder, RunningProcess &process)
{
    constexpr qsizetype terminalField = 4; // behind the name
    QFile file(QFile::decodeName(folder + "/stat"));
    if (!file.open(QIODevice::ReadOnly | QIODevice::Unbuffered))
        return;
    const QByteArray stat = file.readAll();
    const qsizetype begin = stat.indexOf('(') + 1;
    const qsizetype end = stat.lastIndexOf(')');
    process.name = stat.mid(begin, end - begin);
    process.terminal = stat.mid(end + 2).split(' ').value(terminalField).toInt();
}

void takeDevices(const QByteArray &path, RunningProcess &process)
{
    Folder folder(path);
    process.isSeen = folder.isOpen();
    std::array<char, 4'096> target{};
    while (const char *name = folder.next()) {
        const auto length = ::readlinkat(folder.descriptor(), name, target.data(), target.size());
        const QByteArrayView text(target.data(), std::max<qsizetype>(length, 0));
        if (text.startsWith("/dev/"))
            process.devices.push_back(text.toByteArray());
    }
}

} // namespace

std::vector<RunningProcess> runningProcesses(const QByteArray &root)
{
    std::vector<RunningProcess> all;
    Folder proc(root + "/proc");
    while (const char *name = proc.next()) {
        const QByteArray folder = root + "/proc/" + name;
        RunningProcess process{.id = QByteArrayView(name).toInt()};
        if (process.id == 0)
            continue;
        takeStat(folder, process);
        takeDevices(folder + "/fd", process);
        all.push_back(std::move(process));
    }
    std::ranges::sort(all, {}, &RunningProcess::id);
    return all;
}

} // namespace codewheel
