// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

#include <mutex>
#include <optional>
#include <sys/types.h>

namespace codewheel {

// Marks that this program has a file open as a database. When a program closes any descriptor of a file it
// loses all its POSIX locks on it (fcntl(2)), SQLite's included, and other programs take the file for unused.
// So what SQLite has open must not be opened a second time, not even to look at it.
class OpenFile
{
public:
    // While a file is looked at, or opened by SQLite, nobody else may do so.
    using Turn = std::unique_lock<std::mutex>;
    static Turn turn();

    // The first bytes of the file; empty if this program already has it open, or it cannot be read.
    static std::optional<QByteArray> beginning(const Turn &turn, const QString &path, qint64 length);

    OpenFile() = default;
    // SQLite has opened it in this turn.
    OpenFile(const Turn &turn, const QString &path);
    OpenFile(OpenFile &&other) noexcept;
    OpenFile &operator=(OpenFile &&other) noexcept;
    // After SQLite has closed it.
    ~OpenFile();

private:
    struct Id
    {
        dev_t device;
        ino_t number;

        // clang-tidy 14 takes the 0 in a defaulted <=> for a null pointer.
        // NOLINTNEXTLINE(modernize-use-nullptr)
        friend auto operator<=>(const Id &, const Id &) = default;
    };
    struct Table;

    static Table &table();
    static std::optional<Id> idOf(const QString &path);

    std::optional<Id> m_id;
};

} // namespace codewheel
