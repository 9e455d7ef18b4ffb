// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/file_access.h"
#include "project/project_file.h"
#include "project/project_json.h"
#include "tests/project/made_up_project.h"
#include "tests/support/no_room.h"
#include "vocabulary/refusal_text.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <algorithm>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

namespace codewheel {
namespace {

class ProjectFile : public testing::Test
{
protected:
    QString path(const char *name = "crane.codewheel") const
    {
        return m_folder.filePath(QString::fromLatin1(name));
    }
    static void write(const QString &path, const QByteArray &bytes)
    {
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(bytes);
    }
    static QByteArray bytesOf(const QString &path)
    {
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
        return file.readAll();
    }
    QStringList files() const { return QDir(m_folder.path()).entryList(QDir::Files | QDir::Hidden); }

    const Project m_old = madeUpProject(1, 5);
    const Project m_new = madeUpProject(2, 5);

private:
    QTemporaryDir m_folder;
};

TEST_F(ProjectFile, WhatIsSavedIsLoaded)
{
    ASSERT_TRUE(saveProject(m_old, path()));
    EXPECT_EQ(loadProject(path()), m_old);
    EXPECT_EQ(files(), QStringList{QStringLiteral("crane.codewheel")});
}

TEST_F(ProjectFile, TheOneBeforeIsKept)
{
    ASSERT_TRUE(saveProject(m_old, path()));
    ASSERT_TRUE(saveProject(m_new, path()));
    EXPECT_EQ(loadProject(path()), m_new);
    EXPECT_EQ(loadProject(backupPath(path())), m_old);
    EXPECT_EQ(files(), (QStringList{QStringLiteral("crane.codewheel"), QStringLiteral("crane.codewheel~")}));
}

TEST_F(ProjectFile, SavingTheSameAgainKeepsTheOneBefore)
{
    ASSERT_TRUE(saveProject(m_old, path()));
    ASSERT_TRUE(saveProject(m_new, path()));
    ASSERT_TRUE(saveProject(m_new, path()));
    EXPECT_EQ(loadProject(backupPath(path())), m_old);
}

TEST_F(ProjectFile, ABrokenFileDoesNotPushOutTheLastGoodOne)
{
    ASSERT_TRUE(saveProject(m_old, path()));
    ASSERT_TRUE(saveProject(m_new, path()));
    write(path(), "broken");
    ASSERT_TRUE(saveProject(m_new, path()));
    EXPECT_EQ(loadProject(path()), m_new);
    EXPECT_EQ(loadProject(backupPath(path())), m_old);
}

TEST_F(ProjectFile, WhateverWasThereIsKeptIfNothingElseIs)
{
    write(path(), "a letter");
    ASSERT_TRUE(saveProject(m_new, path()));
    EXPECT_EQ(bytesOf(backupPath(path())), "a letter");
}

TEST_F(ProjectFile, ALinkIsFollowed)
{
    ASSERT_TRUE(saveProject(m_old, path()));
    const QString link = path("link.codewheel");
    ASSERT_TRUE(QFile::link(path(), link));
    ASSERT_TRUE(saveProject(m_new, link));
    EXPECT_TRUE(QFileInfo(link).isSymLink());
    EXPECT_EQ(loadProject(path()), m_new);
    EXPECT_EQ(loadProject(backupPath(path())), m_old);
}

TEST_F(ProjectFile, RightsOfTheFileStay)
{
    ASSERT_TRUE(saveProject(m_old, path()));
    ASSERT_TRUE(QFile::setPermissions(path(), QFile::ReadOwner | QFile::WriteOwner));
    ASSERT_TRUE(saveProject(m_new, path()));
    EXPECT_EQ(QFileInfo(path()).permission(QFile::ReadGroup | QFile::ReadOther), false);
}

TEST_F(ProjectFile, CannotBeWrittenWhereThereIsNoFolder)
{
    const auto saved = saveProject(m_old, path("missing/crane.codewheel"));
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().id, RefusalId::fileNotWritten);
    EXPECT_TRUE(refusalText(saved.error()).contains(QStringLiteral("cannot be written: No such file")))
        << refusalText(saved.error()).toStdString();
}

TEST_F(ProjectFile, StaysAsItIsWhereThereIsNoRoom)
{
    ASSERT_TRUE(saveProject(m_old, path()));
    ASSERT_TRUE(saveProject(m_new, path()));
    for (const std::size_t devices : {1u, 5u, 100u}) { // small ones are buffered, large ones written at once
        const Project project = madeUpProject(3, devices);
        const auto saved = [&] {
            const test::NoRoom disk(100);
            return saveProject(project, path());
        }();
        ASSERT_FALSE(saved) << devices;
        EXPECT_EQ(saved.error().id, RefusalId::fileNotWritten);
        EXPECT_TRUE(refusalText(saved.error()).contains(QStringLiteral("cannot be written: File too large.")))
            << refusalText(saved.error()).toStdString();
    }
    EXPECT_EQ(loadProject(path()), m_new);
    EXPECT_EQ(loadProject(backupPath(path())), m_old);
    EXPECT_EQ(files(), (QStringList{QStringLiteral("crane.codewheel"), QStringLiteral("crane.codewheel~")}));
}

// A folder in which nobody may write; root may, and so becomes another user.
class NoRight
{
public:
    explicit NoRight(const QString &folder)
        : m_folder(QFile::encodeName(folder))
    {
        EXPECT_EQ(::chmod(m_folder.constData(), 0555), 0);
        if (::geteuid() == 0) {
            EXPECT_EQ(::seteuid(nobody), 0);
        }
    }
    ~NoRight()
    {
        if (::getuid() == 0) {
            EXPECT_EQ(::seteuid(0), 0);
        }
        EXPECT_EQ(::chmod(m_folder.constData(), 0755), 0);
    }
    Q_DISABLE_COPY(NoRight)

private:
    static constexpr uid_t nobody = 65534;
    QByteArray m_folder;
};

TEST_F(ProjectFile, StaysAsItIsWhereThereIsNoRight)
{
    ASSERT_TRUE(saveProject(m_old, path()));
    for (const QString &name : {path(), path("other.codewheel")}) {
        const auto saved = [&] {
            const NoRight here(path("."));
            return saveProject(m_new, name);
        }();
        ASSERT_FALSE(saved);
        EXPECT_EQ(saved.error().id, RefusalId::fileNotWritten);
        EXPECT_TRUE(
            refusalText(saved.error()).contains(QStringLiteral("cannot be written: Permission denied.")))
            << refusalText(saved.error()).toStdString();
    }
    EXPECT_EQ(loadProject(path()), m_old);
    EXPECT_EQ(files(), QStringList{QStringLiteral("crane.codewheel")});
}

TEST_F(ProjectFile, APipeIsNotReplaced)
{
    ASSERT_EQ(::mkfifo(QFile::encodeName(path()).constData(), 0600), 0);
    const auto saved = saveProject(m_new, path());
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().id, RefusalId::fileNotWritten);
    EXPECT_FALSE(QFileInfo(path()).isFile());
}

TEST_F(ProjectFile, APipeIsNotReplacedByTheBackup)
{
    ASSERT_TRUE(saveProject(m_old, path()));
    const QByteArray pipe = QFile::encodeName(backupPath(path()));
    ASSERT_EQ(::mkfifo(pipe.constData(), 0600), 0);
    const auto saved = saveProject(m_new, path());
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().id, RefusalId::fileNotWritten);
    EXPECT_EQ(loadProject(path()), m_old);
    struct stat there = {};
    ASSERT_EQ(::stat(pipe.constData(), &there), 0);
    EXPECT_TRUE(S_ISFIFO(there.st_mode));
}

TEST_F(ProjectFile, ASocketIsNotReplaced)
{
    const int socket = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_un address{AF_UNIX, {}};
    const QByteArray name = QFile::encodeName(path());
    ASSERT_LT(static_cast<std::size_t>(name.size()), sizeof address.sun_path);
    std::ranges::copy(name, std::begin(address.sun_path));
    ASSERT_EQ(::bind(socket, reinterpret_cast<const sockaddr *>(&address), sizeof address), 0); // NOLINT
    for (const auto &refused : {checkReplaceable(path()), replaceFile(path(), "new", OldFile::goes)}) {
        ASSERT_FALSE(refused);
        EXPECT_TRUE(
            refusalText(refused.error())
                .endsWith(QStringLiteral("cannot be written: It is not a file. Nothing was changed there.")))
            << refusalText(refused.error()).toStdString();
    }
    struct stat there = {};
    ASSERT_EQ(::stat(name.constData(), &there), 0);
    EXPECT_TRUE(S_ISSOCK(there.st_mode));
    ::close(socket);
}

TEST_F(ProjectFile, ALoopOfLinksIsNotReplaced)
{
    ASSERT_TRUE(QFile::link(path("two"), path("one")));
    ASSERT_TRUE(QFile::link(path("one"), path("two")));
    for (const auto &refused :
         {checkReplaceable(path("one")), replaceFile(path("one"), "new", OldFile::goes)}) {
        ASSERT_FALSE(refused);
        EXPECT_TRUE(
            refusalText(refused.error()).contains(QStringLiteral("Too many levels of symbolic links")))
            << refusalText(refused.error()).toStdString();
    }
    EXPECT_TRUE(QFileInfo(path("one")).isSymLink());
    EXPECT_TRUE(QFileInfo(path("two")).isSymLink());
}

TEST_F(ProjectFile, AFullDiskIsNoBadInput)
{
    const auto saved = [&] {
        const test::NoRoom disk(100);
        return replaceFile(path(), QByteArray(1'000, 'x'), OldFile::goes);
    }();
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().kind, RefusalKind::link);
    const auto nowhere = replaceFile(path("no/such"), "x", OldFile::goes);
    ASSERT_FALSE(nowhere);
    EXPECT_EQ(nowhere.error().kind, RefusalKind::badInput);
    EXPECT_EQ(files(), QStringList());
}

TEST_F(ProjectFile, WithoutABackupIsNotReplaced)
{
    ASSERT_TRUE(saveProject(m_old, path()));
    ASSERT_TRUE(QDir().mkpath(backupPath(path()) + QStringLiteral("/full")));
    const auto saved = saveProject(m_new, path());
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().id, RefusalId::fileNotWritten);
    EXPECT_EQ(loadProject(path()), m_old);
    EXPECT_EQ(files(), QStringList{QStringLiteral("crane.codewheel")});
}

TEST_F(ProjectFile, WhatCouldNotBeOpenedAgainIsNotSaved)
{
    ASSERT_TRUE(saveProject(m_old, path()));
    Project broken = m_new;
    broken.devices[2].participant.number = NodeId("9.9");
    const auto saved = saveProject(broken, path());
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().id, RefusalId::fileNotWritten);
    EXPECT_TRUE(refusalText(saved.error())
                    .contains(QStringLiteral("cannot be written: It could not be opened again. "
                                             "buses[0].devices[2].place: \"9.9\" cannot be here")))
        << refusalText(saved.error()).toStdString();
    Project large = m_new;
    large.note = QString(largestProjectFile, u'x');
    const auto tooLarge = saveProject(large, path());
    ASSERT_FALSE(tooLarge);
    EXPECT_TRUE(refusalText(tooLarge.error())
                    .contains(QStringLiteral("It would have 9 MB; the largest that can be opened has 8 MB.")))
        << refusalText(tooLarge.error()).toStdString();
    EXPECT_EQ(loadProject(path()), m_old);
}

TEST_F(ProjectFile, WhatAnotherProgramHasSavedIsSeen)
{
    EXPECT_FALSE(holdsAnother(path(), {})) << "there is nothing";
    ASSERT_TRUE(saveProject(m_old, path()));
    EXPECT_FALSE(holdsAnother(path(), projectMark(*loadProject(path()))));
    EXPECT_TRUE(holdsAnother(path(), {}));
    ASSERT_TRUE(saveProject(m_new, path()));
    EXPECT_TRUE(holdsAnother(path(), projectMark(m_old)));
    EXPECT_FALSE(holdsAnother(path(), projectMark(m_new)));
}

TEST_F(ProjectFile, AMissingFileGetsASentence)
{
    const auto loaded = loadProject(path());
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().id, RefusalId::fileNotReadable);
    EXPECT_TRUE(refusalText(loaded.error())
                    .endsWith(QStringLiteral("crane.codewheel cannot be read: No such file or directory.")))
        << refusalText(loaded.error()).toStdString();
}

TEST_F(ProjectFile, WhatIsNoFileIsNotRead)
{
    ASSERT_EQ(::mkfifo(path("pipe").toLocal8Bit().constData(), 0600), 0);
    for (const QString &name : {path("pipe"), path("."), QStringLiteral("/dev/zero")}) {
        const auto loaded = loadProject(name);
        ASSERT_FALSE(loaded);
        EXPECT_EQ(loaded.error().id, RefusalId::fileNotReadable) << name.toStdString();
    }
}

TEST_F(ProjectFile, OfAGigabyteIsNotRead)
{
    QFile file(path());
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    ASSERT_TRUE(file.resize(qint64{1} << 30));
    const auto loaded = loadProject(path());
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().id, RefusalId::fileTooLarge);
    EXPECT_TRUE(refusalText(loaded.error()).contains(QStringLiteral("has 1,074 MB; the largest")) ||
                refusalText(loaded.error()).contains(QStringLiteral("has 1074 MB; the largest")))
        << refusalText(loaded.error()).toStdString();
}

} // namespace
} // namespace codewheel
