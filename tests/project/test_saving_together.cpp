// SPDX-License-Identifier: GPL-3.0-or-later
// Several programs saving the same project.
#include "project/file_access.h"
#include "project/folder_lock.h"
#include "project/project_file.h"
#include "tests/project/made_up_project.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <filesystem>
#include <gtest/gtest.h>
#include <thread>

namespace codewheel {
namespace {

class SavingTogether : public testing::Test
{
protected:
    QStringList names() const
    {
        return QDir(m_folder.path()).entryList(QDir::Files | QDir::Hidden, QDir::Name);
    }

    const Project m_first = madeUpProject(1, 5);
    const Project m_second = madeUpProject(2, 5);
    const Project m_third = madeUpProject(3, 5);

private:
    QTemporaryDir m_folder;

protected:
    const QString m_file = m_folder.filePath(QStringLiteral("crane.codewheel"));
};

TEST_F(SavingTogether, WhatAnotherProgramHasSavedIsNotReplacedUnseen)
{
    ASSERT_TRUE(saveProject(m_first, m_file));
    ASSERT_TRUE(saveProject(m_second, m_file));
    const auto saved = saveProjectOver(projectMark(m_first), m_third, m_file);
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().id, RefusalId::fileChanged);
    EXPECT_EQ(loadProject(m_file), m_second);
    EXPECT_TRUE(saveProjectOver(projectMark(m_second), m_third, m_file));
}

// Each adds itself to what it has read; if refused, it reads again.
TEST_F(SavingTogether, EachSavesWhatTheOthersHaveSavedAndItsOwn)
{
    constexpr int times = 30;
    Project project = madeUpProject(1, 4);
    for (ProjectDevice &device : project.devices)
        device.station = QStringLiteral("0");
    ASSERT_TRUE(saveProject(project, m_file));
    const auto countUp = [&](std::size_t device) {
        for (int done = 0; done < times;) {
            auto read = loadProject(m_file);
            if (!read)
                return;
            const QByteArray mark = projectMark(*read);
            QString &station = read->devices[device].station;
            station = QString::number(station.toInt() + 1);
            const auto saved = saveProjectOver(mark, *read, m_file);
            done += saved ? 1 : 0;
            if (!saved && saved.error().id != RefusalId::fileChanged)
                return;
        }
    };
    {
        std::vector<std::jthread> savers;
        for (std::size_t i = 0; i < project.devices.size(); ++i)
            savers.emplace_back(countUp, i);
    }
    const auto saved = loadProject(m_file);
    ASSERT_TRUE(saved);
    for (const ProjectDevice &device : saved->devices)
        EXPECT_EQ(device.station.toInt(), times);
    EXPECT_EQ(names(), (QStringList{QStringLiteral("crane.codewheel"), QStringLiteral("crane.codewheel~")}));
}

// Hard links are one file, and renaming one to the other does nothing (rename(2)).
TEST_F(SavingTogether, ABackupThatIsTheFileItselfLeavesNothingBeside)
{
    ASSERT_TRUE(saveProject(m_first, m_file));
    std::error_code error;
    std::filesystem::create_hard_link(m_file.toStdString(), backupPath(m_file).toStdString(), error);
    ASSERT_FALSE(error);
    ASSERT_TRUE(saveProject(m_second, m_file));
    EXPECT_EQ(names(), (QStringList{QStringLiteral("crane.codewheel"), QStringLiteral("crane.codewheel~")}));
    EXPECT_EQ(loadProject(backupPath(m_file)), m_first);
}

TEST_F(SavingTogether, WhatAProgramLeftThatWasKilledGoesAndNothingElse)
{
    ASSERT_TRUE(saveProject(m_first, m_file));
    ASSERT_TRUE(QFile::copy(m_file, m_file + QStringLiteral(".4711~")));
    ASSERT_TRUE(saveProject(m_second, m_file + QStringLiteral(".4712~"))); // has content of its own
    ASSERT_TRUE(saveProject(m_third, m_file));
    EXPECT_EQ(names(),
              (QStringList{QStringLiteral("crane.codewheel"), QStringLiteral("crane.codewheel.4712~"),
                           QStringLiteral("crane.codewheel~")}));
}

TEST_F(SavingTogether, AFolderThatStaysLockedIsTold)
{
    ASSERT_TRUE(saveProject(m_first, m_file));
    const FolderLock other(m_file);
    const auto saved = saveProject(m_second, m_file);
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().id, RefusalId::fileNotWritten);
    EXPECT_EQ(loadProject(m_file), m_first);
}

} // namespace
} // namespace codewheel
