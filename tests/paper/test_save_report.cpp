// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/report_pages.h"
#include "app/report/save_report.h"
#include "project/file_access.h"
#include "report/html_report.h"
#include "tests/report/report_example.h"
#include "tests/support/no_room.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return file.readAll();
}

TEST(SaveReport, TheEndingTellsTheFormat)
{
    EXPECT_EQ(reportFormat(QStringLiteral("a.html")), ReportFormat::html);
    EXPECT_EQ(reportFormat(QStringLiteral("a.b.PDF")), ReportFormat::pdf);
    EXPECT_EQ(reportFormat(QStringLiteral("a.doc")), std::nullopt);
    EXPECT_EQ(reportFormat(QStringLiteral("pdf")), std::nullopt);
}

TEST(SaveReport, WritesAPdfOfAllSheets)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("report.pdf"));
    const Report report = reportOf(exampleInput());
    const auto sheets = saveReport(report, path, ReportFormat::pdf);
    ASSERT_TRUE(sheets);
    EXPECT_EQ(*sheets, ReportPages(report).count());
    const QByteArray pdf = contentOf(path);
    EXPECT_TRUE(pdf.startsWith("%PDF-1."));
    EXPECT_TRUE(pdf.contains("/Count " + QByteArray::number(*sheets) + '\n'));
    EXPECT_TRUE(pdf.trimmed().endsWith("%%EOF"));
}

TEST(SaveReport, WritesTheWebPage)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("report.html"));
    ASSERT_TRUE(saveReport(reportOf(exampleInput()), path, ReportFormat::html));
    EXPECT_EQ(contentOf(path), reportAsHtml(reportOf(exampleInput())));
}

TEST(SaveReport, SaysWhichFileCouldNotBeWritten)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("nowhere/report.pdf"));
    const auto saved = saveReport(reportOf(exampleInput()), path, ReportFormat::pdf);
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().id, RefusalId::fileNotWritten);
    EXPECT_EQ(saved.error().arguments.front(), RefusalArgument(path));
}

TEST(SaveReport, WhereThereIsNoRoomWhatWasThereStays)
{
    const QTemporaryDir folder;
    for (const auto &[name, format] :
         {std::pair{"report.pdf", ReportFormat::pdf}, std::pair{"report.html", ReportFormat::html}}) {
        const QString path = folder.filePath(QString::fromLatin1(name));
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write("old");
        file.close();
        const auto saved = [&, format = format] {
            const test::NoRoom disk(1'000);
            return saveReport(reportOf(exampleInput()), path, format);
        }();
        ASSERT_FALSE(saved) << name;
        EXPECT_EQ(saved.error().id, RefusalId::fileNotWritten);
        EXPECT_EQ(whyNotWritten(saved.error()), QStringLiteral("File too large"));
        EXPECT_EQ(contentOf(path), "old");
    }
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 2);
}

} // namespace
} // namespace codewheel
