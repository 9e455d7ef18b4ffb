// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/sheet_format.h"
#include "kinds/interbus/words/device_number.h"
#include "tests/paper/painted_texts.h"
#include "tests/report/report_example.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::PaintedText;
using testing::HasSubstr;

using Pages = std::vector<std::vector<PaintedText>>;

Pages pagesOf(const Report &report)
{
    const ReportPages painted(report);
    Pages pages;
    for (int page = 0; page < painted.count(); ++page)
        pages.push_back(test::paintedTexts(painted, page));
    return pages;
}

// Without spaces and line breaks.
QString packed(QString text)
{
    return text.remove(u' ');
}

QString textOf(const std::vector<PaintedText> &page)
{
    QString all;
    for (const PaintedText &text : page)
        all += text.text;
    return packed(all);
}

QString textOf(const Pages &pages)
{
    QString all;
    for (const std::vector<PaintedText> &page : pages)
        all += textOf(page);
    return all;
}

ReportInput withStations(int count, const QString &station)
{
    ReportInput input = exampleInput();
    const ProjectDevice first = fraba(input);
    input.project.devices.clear();
    for (int segment = 1; segment <= count; ++segment) {
        input.project.devices.push_back(first);
        input.project.devices.back().participant.number = DeviceNumber{segment, 0}.node();
        input.project.devices.back().station = station + QString::number(segment);
    }
    return input;
}

// Nothing outside the margins, nothing cut off, nothing overlapping.
void expectTidy(const Pages &pages)
{
    const QRectF paper = sheet::body.adjusted(-1, -sheet::mm(10), 1, sheet::mm(12));
    for (const std::vector<PaintedText> &page : pages)
        for (std::size_t i = 0; i < page.size(); ++i) {
            EXPECT_TRUE(paper.contains(page[i].box)) << page[i].text.toStdString();
            EXPECT_FALSE(page[i].isCut) << page[i].text.toStdString();
            for (std::size_t k = i + 1; k < page.size(); ++k)
                EXPECT_FALSE(page[i].box.adjusted(2, 2, -2, -2).intersects(page[k].box))
                    << page[i].text.toStdString() << " and " << page[k].text.toStdString();
        }
}

TEST(ReportPages, SayWhatTheReportSays)
{
    const Report report = reportOf(exampleInput());
    const Pages pages = pagesOf(report);
    const QString all = textOf(pages);
    for (const ReportSection &section : report.sections) {
        EXPECT_TRUE(all.contains(packed(section.heading)));
        for (const std::string &row : rowsOf(section))
            for (const QString &cell : QString::fromStdString(row).split(QStringLiteral(" | ")))
                EXPECT_TRUE(all.contains(packed(cell))) << cell.toStdString();
    }
    expectTidy(pages);
}

TEST(ReportPages, AreNumbered)
{
    const Pages pages = pagesOf(reportOf(withStations(20, QStringLiteral("Station "))));
    ASSERT_GT(pages.size(), 2U);
    const std::string count = std::to_string(pages.size());
    EXPECT_THAT(textOf(pages.front()).toStdString(), HasSubstr("Page1of" + count));
    EXPECT_THAT(textOf(pages.back()).toStdString(), HasSubstr("Page" + count + "of" + count));
    EXPECT_THAT(textOf(pages.back()).toStdString(), HasSubstr("Codewheel0.1.0,1Mar202614:00:00"));
    EXPECT_THAT(textOf(pages[1]).toStdString(), HasSubstr("Harbourcrane"));
    expectTidy(pages);
}

TEST(ReportPages, ATableHasItsHeaderOnEachSheet)
{
    Report report;
    ReportTable table{{QStringLiteral("Header")}, {ReportTable::Column::text}, {}};
    for (int i = 0; i < 200; ++i)
        table.rows.push_back({{QString::number(i)}});
    report.sections.push_back({.heading = QStringLiteral("Long"), .blocks = {table}});
    const Pages pages = pagesOf(report);
    ASSERT_GT(pages.size(), 2U);
    for (const std::vector<PaintedText> &page : pages)
        EXPECT_EQ(textOf(page).count(QStringLiteral("Header")), 1);
    expectTidy(pages);
}

TEST(ReportPages, ARowIsNotCut)
{
    Report report;
    ReportTable table{{QStringLiteral("A"), QStringLiteral("B")},
                      {ReportTable::Column::text, ReportTable::Column::text},
                      {}};
    for (int i = 100; i < 200; ++i)
        table.rows.push_back({{QStringLiteral("from%1 ").arg(i) + QStringLiteral("word ").repeated(100) +
                                   QStringLiteral("to%1").arg(i),
                               QStringLiteral("x")}});
    report.sections.push_back({.heading = QStringLiteral("Rows"), .blocks = {table}});
    const Pages pages = pagesOf(report);
    for (int i = 100; i < 200; ++i)
        EXPECT_TRUE(std::ranges::any_of(pages, [i](const std::vector<PaintedText> &page) {
            const QString text = textOf(page);
            return text.contains(QStringLiteral("from%1").arg(i)) &&
                   text.contains(QStringLiteral("to%1").arg(i));
        }));
    expectTidy(pages);
}

TEST(ReportPages, NoWordIsTooLong)
{
    const QString word(5'000, u'W'); // longer than a sheet, within a column
    const Pages pages = pagesOf(reportOf(withStations(2, word)));
    EXPECT_GE(textOf(pages).count(u'W'), 2 * 5'000);
    expectTidy(pages);
}

TEST(ReportPages, LongNotesGoOnOnTheNextSheet)
{
    ReportInput input = exampleInput();
    input.project.note = QStringLiteral("All of it is read.\n").repeated(500);
    fraba(input).note = QStringLiteral("word ").repeated(5'000);
    const Pages pages = pagesOf(reportOf(input));
    EXPECT_EQ(textOf(pages).count(QStringLiteral("Allofitisread.")), 500);
    EXPECT_EQ(textOf(pages).count(QStringLiteral("word")), 5'000);
    expectTidy(pages);
}

TEST(ReportPages, HostileTextsStayOnPaper)
{
    ReportInput input =
        withStations(3, QString(QChar(0x202E)) + QStringLiteral("\n\n\t<b>") + QChar(0) + u'x');
    input.project.title = QString(3'000, u'T');
    const Pages pages = pagesOf(reportOf(input));
    EXPECT_TRUE(textOf(pages).contains(QStringLiteral("<b>")));
    expectTidy(pages);
}

TEST(ReportPages, APictureStandsWithItsTitle)
{
    for (int count = 1; count < 8; ++count) {
        ReportInput input = withStations(count, QStringLiteral("S"));
        replaceValue(fraba(input).wanted, {Parameter::revolutions, 4096});
        CamProgram program{.number = 1};
        program.cam[0] = {0, 2047, true};
        fraba(input).wantedCams = {program};
        int pictures = 0;
        for (const std::vector<PaintedText> &page : pagesOf(reportOf(input)))
            for (const PaintedText &text : page)
                if (text.text == QStringLiteral("Cam program 1, wanted")) {
                    ++pictures;
                    EXPECT_LE(text.box.bottom() + sheet::mm(32), sheet::body.bottom());
                }
        EXPECT_EQ(pictures, 1);
    }
}

// Both roles on one sheet, with their heading.
TEST(ReportPages, SignaturesStandTogether)
{
    for (int count = 1; count < 12; ++count)
        EXPECT_THAT(textOf(pagesOf(reportOf(withStations(count, QStringLiteral("S")))).back()).toStdString(),
                    HasSubstr("SignaturesCommissionedbyNameDateSignatureAcceptedbyNameDateSignature"));
}

} // namespace
} // namespace codewheel
