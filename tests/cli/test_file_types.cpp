// SPDX-License-Identifier: GPL-3.0-or-later
// What a desktop takes the files of the program for, by their names and by what they hold.
#include "tests/cli/cli_run.h"

#include <QDir>
#include <QFile>
#include <QMimeDatabase>
#include <QProcess>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

const QString desktopEntry = QStringLiteral(CODEWHEEL_ROOT "/packaging/io.codewheel.Codewheel.desktop");
const QString definitions = QStringLiteral(CODEWHEEL_ROOT "/packaging/io.codewheel.Codewheel.mime.xml");

class FileTypes : public testing::Test
{
protected:
    // Qt reads the types once: those of the system, and ours as they are installed.
    static void SetUpTestSuite()
    {
        static const QTemporaryDir data;
        const QString packages = data.filePath(QStringLiteral("mime/packages"));
        QDir().mkpath(packages);
        EXPECT_TRUE(QFile::copy(QStringLiteral("/usr/share/mime/packages/freedesktop.org.xml"),
                                packages + QStringLiteral("/freedesktop.org.xml")));
        EXPECT_TRUE(QFile::copy(definitions, packages + QStringLiteral("/codewheel.xml")));
        EXPECT_EQ(QProcess::execute(QStringLiteral("update-mime-database"),
                                    {data.filePath(QStringLiteral("mime"))}),
                  0);
        const QByteArray before = qgetenv("XDG_DATA_DIRS");
        qputenv("XDG_DATA_DIRS", data.path().toLocal8Bit());
        EXPECT_TRUE(QMimeDatabase().mimeTypeForName(QStringLiteral("application/json")).isValid());
        qputenv("XDG_DATA_DIRS", before);
    }

    QString example(const char *name, const char *as, const char *from = "docs/examples/")
    {
        const QString path = folder.filePath(QString::fromLatin1(as));
        EXPECT_TRUE(QFile::copy(
            QStringLiteral(CODEWHEEL_ROOT "/") + QLatin1String(from) + QLatin1String(name), path));
        return path;
    }
    std::string typeOf(const QString &path, QMimeDatabase::MatchMode mode = QMimeDatabase::MatchDefault)
    {
        return m_types.mimeTypeForFile(path, mode).name().toStdString();
    }

    QTemporaryDir folder;

private:
    QMimeDatabase m_types;
};

TEST_F(FileTypes, AProjectIsKnownByNameAndContent)
{
    EXPECT_EQ(typeOf(example("crane.codewheel", "a.codewheel")), "application/x-codewheel-project");
    EXPECT_EQ(typeOf(example("crane.codewheel", "crane"), QMimeDatabase::MatchContent),
              "application/x-codewheel-project");
}

TEST_F(FileTypes, CamsAreKnownByNameAndContent)
{
    EXPECT_EQ(typeOf(example("cams.json", "a.cwcams")), "application/x-codewheel-cams");
    EXPECT_EQ(typeOf(example("cams.json", "cams"), QMimeDatabase::MatchContent),
              "application/x-codewheel-cams");
}

TEST_F(FileTypes, AFaultPlanIsKnownByNameAndContent)
{
    EXPECT_EQ(typeOf(example("faults.json", "a.cwfaults", "resources/examples/")),
              "application/x-codewheel-faults");
    EXPECT_EQ(typeOf(example("faults.json", "faults", "resources/examples/"), QMimeDatabase::MatchContent),
              "application/x-codewheel-faults");
}

TEST_F(FileTypes, ARecordingIsKnownByNameAndContent)
{
    const QString path = folder.filePath(QStringLiteral("shaft.cwrec"));
    ASSERT_EQ(runLine(QStringLiteral("record 1.0 --for 1 -o ") + path).exit, 0);
    EXPECT_EQ(typeOf(path), "application/x-codewheel-recording");
    EXPECT_EQ(typeOf(path, QMimeDatabase::MatchContent), "application/x-codewheel-recording");
}

TEST_F(FileTypes, OtherFilesAreLeftAlone)
{
    QFile file(folder.filePath(QStringLiteral("other.json")));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly) && file.write(R"({"format": "something-else"})") > 0);
    file.close();
    EXPECT_EQ(typeOf(file.fileName()), "application/json");
}

TEST_F(FileTypes, TheDesktopEntryOpensAllOfThem)
{
    QFile file(desktopEntry);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QString text = QString::fromUtf8(file.readAll());
    const QStringList types =
        text.section(QStringLiteral("\nMimeType="), 1).section(u'\n', 0, 0).split(u';', Qt::SkipEmptyParts);
    EXPECT_EQ(types.size(), 4);
    for (const QString &type : types)
        EXPECT_TRUE(QMimeDatabase().mimeTypeForName(type).isValid()) << type.toStdString();
    EXPECT_TRUE(text.contains(QStringLiteral("\nExec=codewheel %f\n")));
}

} // namespace
} // namespace codewheel
