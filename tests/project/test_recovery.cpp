// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/recovery.h"
#include "tests/project/made_up_project.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <gtest/gtest.h>
#include <memory>

namespace codewheel {
namespace {

const QDateTime today(QDate(2026, 3, 1), QTime(14, 2), Qt::UTC);
const QString path = QStringLiteral("/home/ä \"b\"\n/crane.codewheel");

class Recoveries : public testing::Test
{
protected:
    QString folder() const { return m_temporary.filePath(QStringLiteral("data/recovery")); }
    QStringList files() const { return QDir(folder()).entryList(QDir::Files | QDir::Hidden); }
    // A program that ends without asking: nothing is discarded.
    void crash(const Project &project, const QDateTime &at = today) const
    {
        ASSERT_TRUE(Recovery(folder()).keep(project, path, at));
    }

    const Project m_project = madeUpProject(1, 5);
    const Project m_other = madeUpProject(2, 5);

private:
    QTemporaryDir m_temporary;
};

TEST_F(Recoveries, WhatAProgramLeftIsOfferedWithItsFileAndTime)
{
    crash(m_project);
    const auto left = leftProjects(folder());
    ASSERT_EQ(left.size(), 1u);
    EXPECT_EQ(left[0].path(), path);
    EXPECT_EQ(left[0].keptAt(), today);
    EXPECT_EQ(left[0].load(), m_project);
}

TEST_F(Recoveries, TheLatestIsKept)
{
    {
        Recovery recovery(folder());
        ASSERT_TRUE(recovery.keep(m_project, QString(), today));
        ASSERT_TRUE(recovery.keep(m_other, path, today.addSecs(60)));
    }
    const auto left = leftProjects(folder());
    ASSERT_EQ(left.size(), 1u);
    EXPECT_EQ(left[0].path(), path);
    EXPECT_EQ(left[0].keptAt(), today.addSecs(60));
    EXPECT_EQ(left[0].load(), m_other);
}

TEST_F(Recoveries, ARunningProgramsIsNotOffered)
{
    Recovery running(folder());
    ASSERT_TRUE(running.keep(m_project, path, today));
    EXPECT_TRUE(leftProjects(folder()).empty());
    crash(m_other);
    const auto left = leftProjects(folder());
    ASSERT_EQ(left.size(), 1u);
    EXPECT_EQ(left[0].load(), m_other);
}

TEST_F(Recoveries, OneOfTwoProgramsThatStartOffersIt)
{
    crash(m_project);
    {
        const auto first = leftProjects(folder());
        EXPECT_EQ(first.size(), 1u);
        EXPECT_TRUE(leftProjects(folder()).empty());
    }
    EXPECT_EQ(leftProjects(folder()).size(), 1u) << "what was not dropped is there again";
}

TEST_F(Recoveries, NothingIsLeftOfWhatWasDropped)
{
    Recovery recovery(folder());
    ASSERT_TRUE(recovery.keep(m_project, path, today));
    recovery.drop();
    EXPECT_EQ(files(), QStringList());
    ASSERT_TRUE(recovery.keep(m_project, path, today)) << "the next edits are kept again";
    EXPECT_FALSE(files().isEmpty());

    crash(m_other);
    auto left = leftProjects(folder());
    ASSERT_EQ(left.size(), 1u);
    left[0].drop();
    recovery.drop();
    EXPECT_EQ(files(), QStringList());
}

TEST_F(Recoveries, NothingIsWrittenWhileNothingChanges)
{
    Recovery recovery(folder());
    ASSERT_TRUE(recovery.keep(m_project, path, today));
    const auto remove = [&] {
        for (const QString &name : files())
            QFile::remove(QDir(folder()).filePath(name));
    };
    remove();
    ASSERT_TRUE(recovery.keep(m_project, path, today.addSecs(60)));
    EXPECT_EQ(files(), QStringList());
    ASSERT_TRUE(recovery.keep(m_project, QStringLiteral("another"), today));
    EXPECT_EQ(files().size(), 1);
    remove();
    ASSERT_TRUE(recovery.keep(m_other, QStringLiteral("another"), today));
    EXPECT_EQ(files().size(), 1);
}

TEST_F(Recoveries, TheNewestComesFirst)
{
    for (const int hour : {2, 3, 1})
        crash(m_project, today.addSecs(qint64{3600} * hour));
    const auto left = leftProjects(folder());
    ASSERT_EQ(left.size(), 3u);
    for (const int hour : {3, 2, 1})
        EXPECT_EQ(left[static_cast<std::size_t>(3 - hour)].keptAt(), today.addSecs(qint64{3600} * hour));
}

TEST_F(Recoveries, ABrokenOneIsOfferedAndRefused)
{
    ASSERT_TRUE(QDir().mkpath(folder()));
    for (const QByteArray &bytes : {QByteArray(), QByteArray("{\"path\": 7}\n{}"), QByteArray("x")}) {
        QFile file(QDir(folder()).filePath(QStringLiteral("broken.recovery")));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(bytes);
        file.close();
        const auto left = leftProjects(folder());
        ASSERT_EQ(left.size(), 1u);
        EXPECT_EQ(left[0].path(), QString());
        EXPECT_FALSE(left[0].keptAt().isValid());
        const auto loaded = left[0].load();
        ASSERT_FALSE(loaded);
        EXPECT_EQ(loaded.error().id, RefusalId::projectFileBroken);
    }
}

TEST_F(Recoveries, WithoutAFolderThereIsASentence)
{
    QFile inTheWay(folder().chopped(9));
    ASSERT_TRUE(inTheWay.open(QIODevice::WriteOnly));
    Recovery recovery(folder());
    const auto kept = recovery.keep(m_project, path, today);
    ASSERT_FALSE(kept);
    EXPECT_EQ(kept.error().id, RefusalId::fileNotWritten);
    EXPECT_TRUE(leftProjects(folder()).empty());
}

} // namespace
} // namespace codewheel
