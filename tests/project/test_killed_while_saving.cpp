// SPDX-License-Identifier: GPL-3.0-or-later
// kill -9 at any time leaves the old file or the new one, byte for byte.
#include "kinds/interbus/ring/ring_rules.h"
#include "project/file_access.h"
#include "project/project_json.h"
#include "tests/project/made_up_project.h"
#include "tests/support/times.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

#include <array>
#include <chrono>
#include <cmath>
#include <gtest/gtest.h>
#include <thread>

namespace codewheel {
namespace {

constexpr int patience = 60'000; // ms

class KilledWhileSaving : public testing::Test
{
protected:
    KilledWhileSaving()
    {
        for (std::size_t which = 0; which < 2; ++which) {
            m_bytes[which] = projectToJson(madeUpProject(std::uint32_t(which), ring_limit::devices));
            QFile file(path(names[which]));
            EXPECT_TRUE(file.open(QIODevice::WriteOnly) && file.write(m_bytes[which]) > 0);
        }
    }

    // This many times, at different points of the second to fourth save. Seeded; the duration of a save is
    // measured first.
    void killTimes(int times, const char *how)
    {
        std::mt19937 random(9);
        std::uniform_real_distribution<double> saves(1, 4);
        measure(how);
        for (int round = 0; round < times && !HasFatalFailure(); ++round)
            killAfter(saves(random), how);
        EXPECT_GT(m_seen[0], 0);
        EXPECT_GT(m_seen[1], 0);
    }

private:
    static constexpr std::array names{"first", "second"};

    QString path(const char *name) const { return m_folder.filePath(QString::fromLatin1(name)); }
    // 0 or 1; fails if the file is neither.
    std::size_t whichIs(const QString &name) const
    {
        QFile file(name);
        EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name.toStdString();
        const QByteArray bytes = file.readAll();
        EXPECT_TRUE(bytes == m_bytes[0] || bytes == m_bytes[1])
            << name.toStdString() << " has " << bytes.size() << " bytes";
        return bytes == m_bytes[0] ? 0 : 1;
    }
    void start(QProcess &program, const char *how) const
    {
        program.start(QStringLiteral(CODEWHEEL_SAVING_PROGRAM),
                      {QString::fromLatin1(how), path("crane.codewheel"), path(names[0]), path(names[1])});
    }
    static void waitForSaves(QProcess &program, qsizetype saves)
    {
        for (qsizetype seen = 0; seen < saves; seen += program.readAllStandardOutput().count('\n'))
            ASSERT_TRUE(program.waitForReadyRead(patience));
    }
    static void kill(QProcess &program)
    {
        program.kill();
        ASSERT_TRUE(program.waitForFinished(patience));
        ASSERT_EQ(program.exitStatus(), QProcess::CrashExit) << "it ended by itself";
    }
    void measure(const char *how)
    {
        QProcess program;
        start(program, how);
        waitForSaves(program, 1);
        const auto begin = std::chrono::steady_clock::now();
        waitForSaves(program, 1);
        m_save = std::chrono::steady_clock::now() - begin;
        kill(program);
    }
    void killAfter(double saves, const char *how)
    {
        QProcess program;
        start(program, how);
        waitForSaves(program, static_cast<qsizetype>(saves));
        std::this_thread::sleep_for(m_save * (saves - std::floor(saves)));
        kill(program);
        const QString file = path("crane.codewheel");
        ++m_seen[whichIs(file)];
        if (QFile::exists(backupPath(file)))
            whichIs(backupPath(file));
    }

    QTemporaryDir m_folder;
    std::array<QByteArray, 2> m_bytes;
    std::array<int, 2> m_seen{};
    std::chrono::duration<double> m_save{}; // duration of a save
};

TEST_F(KilledWhileSaving, OneOfTheTwoFilesIsThereAsAWhole)
{
    killTimes(test::times(25), "projects");
}

TEST_F(KilledWhileSaving, OneOfTheTwoFilesIsThereAsAWholeWhileItIsReplaced)
{
    killTimes(test::times(100), "bytes");
}

} // namespace
} // namespace codewheel
