// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/no_room.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace codewheel::test {

// A file, alone in its folder, that a view is to replace on a full disk.
class OldFile
{
public:
    OldFile()
    {
        QFile file(m_path);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write("old");
    }

    template <typename Save>
    bool saveWithoutRoom(const Save &save)
    {
        const NoRoom disk(10);
        return save(m_path);
    }
    // Unchanged, with no other file beside it.
    bool isThere() const
    {
        QFile file(m_path);
        return file.open(QIODevice::ReadOnly) && file.readAll() == "old" &&
               QDir(m_folder.path()).entryList(QDir::Files | QDir::Hidden).size() == 1;
    }

private:
    QTemporaryDir m_folder;
    QString m_path = m_folder.filePath(QStringLiteral("old.txt"));
};

} // namespace codewheel::test
