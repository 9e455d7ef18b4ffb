// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdf/report_sheets.h"
#include "pdf/sheet_format.h"
#include "tests/report/report_example.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::Contains;

std::vector<std::string> textsOf(const Sheet &sheet)
{
    std::vector<std::string> texts;
    for (const Sheet::Text &text : sheet.texts)
        texts.push_back(text.text.toStdString());
    return texts;
}

// Without spaces and line breaks.
QString allTextOf(const std::vector<Sheet> &sheets)
{
    QString all;
    for (const Sheet &sheet : sheets)
        for (const Sheet::Text &text : sheet.texts)
            all += text.text;
    return all.remove(u' ');
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

// Nothing beside the paper's margins, nothing over something else.
void expectTidy(const std::vector<Sheet> &sheets)
{
    const QRectF paper = sheet::body.adjusted(-1, -sheet::mm(10), 1, sheet::mm(12));
    for (const Sheet &sheet : sheets) {
        for (std::size_t i = 0; i < sheet.texts.size(); ++i) {
            const Sheet::Text &text = sheet.texts[i];
            EXPECT_TRUE(paper.contains(text.box)) << text.text.toStdString();
            for (std::size_t k = i + 1; k < sheet.texts.size(); ++k)
                EXPECT_FALSE(text.box.adjusted(1, 1, -1, -1).intersects(sheet.texts[k].box))
                    << text.text.toStdString() << " and " << sheet.texts[k].text.toStdString();
        }
        for (const Sheet::Line &line : sheet.lines)
            EXPECT_TRUE(paper.contains(line.line.p1()) && paper.contains(line.line.p2()));
        for (const Sheet::Bar &bar : sheet.bars)
            EXPECT_TRUE(paper.contains(bar.box));
    }
}

TEST(ReportSheets, SayWhatTheReportSays)
{
    const Report report = reportOf(exampleInput());
    const std::vector<Sheet> sheets = reportSheets(report);
    const QString all = allTextOf(sheets);
    for (const ReportSection &section : report.sections) {
        EXPECT_TRUE(all.contains(QString(section.heading).remove(u' ')));
        for (const std::string &row : rowsOf(section))
            for (const QString &cell : QString::fromStdString(row).split(QStringLiteral(" | ")))
                EXPECT_TRUE(all.contains(QString(cell).remove(u' '))) << cell.toStdString();
    }
    expectTidy(sheets);
}

TEST(ReportSheets, AreNumbered)
{
    const std::vector<Sheet> sheets = reportSheets(reportOf(withStations(20, QStringLiteral("Station "))));
    ASSERT_GT(sheets.size(), 2U);
    const std::string count = std::to_string(sheets.size());
    EXPECT_THAT(textsOf(sheets.front()), Contains("Page 1 of " + count));
    EXPECT_THAT(textsOf(sheets.back()), Contains("Page " + count + " of " + count));
    EXPECT_THAT(textsOf(sheets.back()), Contains("Codewheel 0.1.0, 1 Mar 2026 14:00:00"));
    EXPECT_THAT(textsOf(sheets[1]), Contains("Harbour crane"));
}

TEST(ReportSheets, ATableHasItsHeaderOnEachSheet)
{
    Report report;
    ReportTable table{{QStringLiteral("Header of the table")}, {ReportTable::Column::text}, {}};
    for (int i = 0; i < 200; ++i)
        table.rows.push_back({{QString::number(i)}});
    report.sections.push_back({.heading = QStringLiteral("Long"), .blocks = {table}});
    const std::vector<Sheet> sheets = reportSheets(report);
    ASSERT_GT(sheets.size(), 2U);
    for (const Sheet &sheet : sheets)
        EXPECT_THAT(textsOf(sheet), Contains("Header of the table"));
    expectTidy(sheets);
}

TEST(ReportSheets, NoWordIsTooLong)
{
    const QString word(5'000, u'W'); // more than a sheet, in a column
    const std::vector<Sheet> sheets = reportSheets(reportOf(withStations(2, word)));
    EXPECT_GE(allTextOf(sheets).count(u'W'), 2 * 5'000);
    expectTidy(sheets);
}

TEST(ReportSheets, LongNotesGoOnOnTheNextSheet)
{
    ReportInput input = exampleInput();
    input.project.note = QStringLiteral("All of it is read.\n").repeated(500);
    fraba(input).note = QStringLiteral("word ").repeated(5'000);
    const std::vector<Sheet> sheets = reportSheets(reportOf(input));
    EXPECT_EQ(allTextOf(sheets).count(QStringLiteral("Allofitisread.")), 500);
    expectTidy(sheets);
}

TEST(ReportSheets, HostileTextsStayOnPaper)
{
    ReportInput input =
        withStations(3, QString(QChar(0x202E)) + QStringLiteral("\n\n\t<b>") + QChar(0) + u'x');
    input.project.title = QString(3'000, u'T');
    const std::vector<Sheet> sheets = reportSheets(reportOf(input));
    EXPECT_TRUE(allTextOf(sheets).contains(QStringLiteral("<b>")));
    expectTidy(sheets);
}

TEST(ReportSheets, CamsAreDrawnOverTheRange)
{
    ReportInput input = exampleInput();
    replaceValue(fraba(input).wanted, {Parameter::revolutions, 4096});
    CamProgram program{.number = 1};
    program.cam[0] = {0, 2047, true};
    program.cam[1] = {3072, 1023, false};
    fraba(input).wantedCams = {program};
    std::vector<Sheet::Bar> bars;
    for (const Sheet &sheet : reportSheets(reportOf(input)))
        bars.insert(bars.end(), sheet.bars.begin(), sheet.bars.end());
    ASSERT_EQ(bars.size(), 3U);
    EXPECT_TRUE(bars[0].filled);
    EXPECT_FALSE(bars[1].filled);
    EXPECT_DOUBLE_EQ(bars[0].box.width(), 2 * bars[1].box.width());
    EXPECT_DOUBLE_EQ(bars[2].box.right(), sheet::body.right());
}

// Both roles on one sheet, with their heading.
TEST(ReportSheets, SignaturesStandTogether)
{
    for (int count = 1; count < 12; ++count) {
        const auto sheets = reportSheets(reportOf(withStations(count, QStringLiteral("S"))));
        EXPECT_THAT(textsOf(sheets.back()),
                    testing::IsSupersetOf(
                        {"Signatures", "Commissioned by", "Accepted by", "Name", "Date", "Signature"}));
    }
}

} // namespace
} // namespace codewheel
