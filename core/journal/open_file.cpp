// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/open_file.h"

#include <QFile>

#include <map>
#include <sys/stat.h>
#include <utility>

namespace codewheel {

// One for the whole program, like the locks.
struct OpenFile::Table
{
    std::mutex mutex;
    std::map<Id, int> connections;
};

OpenFile::Table &OpenFile::table()
{
    static Table table;
    return table;
}

std::optional<OpenFile::Id> OpenFile::idOf(const QString &path)
{
    struct stat told = {};
    if (::stat(QFile::encodeName(path).constData(), &told) != 0)
        return std::nullopt;
    return Id{told.st_dev, told.st_ino};
}

OpenFile::Turn OpenFile::turn()
{
    return Turn(table().mutex);
}

std::optional<QByteArray> OpenFile::beginning(const Turn &, const QString &path, qint64 length)
{
    const auto id = idOf(path);
    if (!id || table().connections.contains(*id))
        return std::nullopt;
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return std::nullopt;
    return file.read(length);
}

OpenFile::OpenFile(const Turn &, const QString &path)
    : m_id(idOf(path))
{
    if (m_id)
        ++table().connections[*m_id];
}

OpenFile::OpenFile(OpenFile &&other) noexcept
    : m_id(std::exchange(other.m_id, std::nullopt))
{}

OpenFile &OpenFile::operator=(OpenFile &&other) noexcept
{
    std::swap(m_id, other.m_id);
    return *this;
}

OpenFile::~OpenFile()
{
    if (!m_id)
        return;
    const Turn taken = turn();
    if (--table().connections[*m_id] == 0)
        table().connections.erase(*m_id);
}

} // namespace codewheel
