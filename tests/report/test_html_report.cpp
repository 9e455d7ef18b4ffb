// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/ring_device.h"
#include "report/html_report.h"
#include "report/printable_text.h"
#include "tests/report/report_example.h"
#include "tests/support/plans.h"

#include <QRegularExpression>
#include <QXmlStreamReader>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;

void expectWellFormed(const QString &html)
{
    QXmlStreamReader reader(html);
    while (!reader.atEnd())
        reader.readNext();
    EXPECT_FALSE(reader.hasError()) << reader.lineNumber() << ": " << qPrintable(reader.errorString());
}

// The names of its elements, and their texts joined.
std::pair<QSet<QString>, QString> parsed(const QString &html)
{
    QXmlStreamReader reader(html);
    QSet<QString> names;
    QString text;
    while (!reader.atEnd()) {
        reader.readNext();
        if (reader.isStartElement())
            names.insert(reader.name().toString());
        if (reader.isCharacters())
            text += reader.text();
    }
    return {names, text};
}

TEST(HtmlReport, HasTheTablesWithHeaders)
{
    const std::string html = htmlOf(exampleInput()).toStdString();
    EXPECT_THAT(html, HasSubstr("<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\" "
                                "xml:lang=\"en\">\n"));
    EXPECT_THAT(html, HasSubstr("<title>Commissioning report: Harbour crane</title>"));
    EXPECT_THAT(html, HasSubstr("<th scope=\"row\">Program</th><td>Codewheel 0.1.0</td>"));
    EXPECT_THAT(html, HasSubstr("<thead><tr><th scope=\"col\">Parameter</th><th scope=\"col\" "
                                "class=\"number\">Wanted</th>"));
    EXPECT_THAT(html, HasSubstr("<tr class=\"stressed\"><td>Steps</td><td class=\"number\">4096</td><td "
                                "class=\"number\">8192</td><td>steps</td><td>read</td>"));
    EXPECT_THAT(html, HasSubstr("<td class=\"code\">37h</td>"));
    EXPECT_THAT(html,
                HasSubstr("<p class=\"role\">Commissioned by</p>\n<table class=\"sign\"><tr><td>Name</td>"));
}

TEST(HtmlReport, IsMadeForPaper)
{
    const std::string html = htmlOf(exampleInput()).toStdString();
    EXPECT_THAT(html, HasSubstr("@page { size: A4;"));
    EXPECT_THAT(html, HasSubstr("thead { display: table-header-group; }"));
    EXPECT_THAT(html, HasSubstr("color: black; background: white;"));
}

TEST(HtmlReport, IsXmlAndNeedsNothingFromElsewhere)
{
    const QString html = htmlOf(exampleInput());
    expectWellFormed(html);
    EXPECT_FALSE(html.contains(QRegularExpression(QStringLiteral("(src|href)=|url[(]"))));
    EXPECT_FALSE(parsed(html).first.contains(QStringLiteral("script")));
}

TEST(HtmlReport, TheSameInputGivesTheSameBytes)
{
    EXPECT_EQ(reportAsHtml(reportOf(exampleInput())), reportAsHtml(reportOf(exampleInput())));
}

TEST(HtmlReport, DrawsCamsAsBars)
{
    ReportInput input = exampleInput();
    replaceValue(fraba(input).wanted, {Parameter::revolutions, 4096}); // 4096 positions
    CamProgram program{.number = 1};
    program.cam[2] = {1024, 2047, true};
    program.cam[3] = {3072, 1023, false};
    fraba(input).wantedCams = {program};
    const QString html = htmlOf(input);
    expectWellFormed(html);
    EXPECT_THAT(html.toStdString(), HasSubstr("<figcaption><p>Cam program 1, wanted</p></figcaption>"));
    // From 20 to 676: a quarter of the range is 164 wide.
    EXPECT_THAT(html.toStdString(), HasSubstr("<rect x=\"184.0\" y=\"31.0\" width=\"164.0\" height=\"8.0\" "
                                              "fill=\"black\" stroke=\"black\"/>"));
    EXPECT_THAT(html.toStdString(), HasSubstr("<rect x=\"20.0\" y=\"45.0\" width=\"164.0\" height=\"8.0\" "
                                              "fill=\"white\" stroke=\"black\"/>"));
    EXPECT_THAT(html.toStdString(), HasSubstr("<rect x=\"512.0\" y=\"45.0\" width=\"164.0\" height=\"8.0\" "
                                              "fill=\"white\" stroke=\"black\"/>"));
}

// Whatever a station is called: text stays text.
class HostileReport : public testing::TestWithParam<QString>
{};

TEST_P(HostileReport, StaysAPageOfTexts)
{
    const QString text = GetParam();
    ReportInput input = exampleInput();
    input.project.title = text;
    input.project.note = text;
    input.file = text;
    changeRing(input.project, [&](RingPlan &ring) { ring.link = {text, {{text, text}}}; });
    input.project.buses.front().name = text;
    for (ProjectDevice &device : input.project.devices) {
        device.station = text;
        device.group = text;
        device.note = text;
        device.label.serialNumber = text;
    }
    input.project.devices[2].participant.deviceKey = text;
    input.connected[firstBus].devices = {RingDevice{NodeId("1.0"), 0x0237, 2, 2, text, 0}};
    const QString html = htmlOf(input);
    expectWellFormed(html);
    const QSet<QString> usual = parsed(htmlOf(exampleInput())).first;
    const auto [names, texts] = parsed(html);
    EXPECT_EQ(names - usual, QSet<QString>());
    EXPECT_TRUE(texts.contains(printableText(text)));
}

INSTANTIATE_TEST_SUITE_P(
    Texts, HostileReport,
    testing::Values(QStringLiteral("<script>alert(1)</script>"), QStringLiteral("\"><img src=x onerror=y>"),
                    QStringLiteral("</td></tr></table><!--"), QStringLiteral("]]>&amp;&#0;"),
                    QStringLiteral("%1 %2 %n %99"), QString(QChar(0)) + u'\x01' + QChar(0xFFFE),
                    QString(QChar(0xD800)) + u'x', QString(QChar(0x202E)) + QStringLiteral("txt.exe"),
                    QStringLiteral("' onload='x"), QString(20'000, u'W'), QStringLiteral("two\nlines\ttab")));

TEST(PrintableText, ReplacesWhatMayNotBePrinted)
{
    const QChar replaced = QChar::ReplacementCharacter;
    EXPECT_EQ(printableText(QStringLiteral("a\nb\tc")), QStringLiteral("a\nb\tc"));
    EXPECT_EQ(printableText(QStringLiteral("a\r\nb")), QStringLiteral("a\nb"));
    EXPECT_EQ(printableText(QString(QChar(0x1B)) + QStringLiteral("[0m")), replaced + QStringLiteral("[0m"));
    EXPECT_EQ(printableText(QString(QChar(0x202E))), QString(replaced));
    EXPECT_EQ(printableText(QString(QChar(0xDC00))), QString(replaced));
    EXPECT_EQ(printableText(QStringLiteral("Größe Ω 測")), QStringLiteral("Größe Ω 測"));
}

} // namespace
} // namespace codewheel
