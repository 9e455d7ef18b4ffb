// SPDX-License-Identifier: GPL-3.0-or-later
// The manual says the same in each language: the same pages, with the same headings, tables, pictures and
// examples in the same places.
#include "widgets/help/manual.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

const QString englishPages = QStringLiteral(":/codewheel-manual/docs/manual/");
const QString germanPages = englishPages + QStringLiteral("de/");

QStringList linesOf(const QString &file)
{
    QFile page(file);
    EXPECT_TRUE(page.open(QIODevice::ReadOnly)) << file.toStdString();
    return QString::fromUtf8(page.readAll()).split(u'\n');
}

// "##", "table of 3", "picture dial.png", "code": what stands on the page, in its order.
std::vector<std::string> outlineOf(const QString &file)
{
    static const QRegularExpression picture(QStringLiteral("^ *!\\[[^\\]]*\\]\\((?:.*/)?([^/)]+)\\)"));
    static const QRegularExpression table(QStringLiteral("^ *\\|[-|: ]+\\|$"));
    std::vector<std::string> outline;
    bool isCode = false;
    for (const QString &line : linesOf(file)) {
        if (line.startsWith(QStringLiteral("```"))) {
            isCode = !isCode;
            outline.push_back("code");
        } else if (isCode)
            continue;
        else if (line.startsWith(u'#'))
            outline.push_back(line.section(u' ', 0, 0).toStdString());
        else if (const auto match = picture.match(line); match.hasMatch())
            outline.push_back("picture " + match.captured(1).toStdString());
        else if (table.match(line).hasMatch())
            outline.push_back("table of " + std::to_string(line.count(u'|') - 1));
    }
    return outline;
}

TEST(ManualInGerman, HasThePagesOfTheEnglishOneWithTheSameOutline)
{
    ASSERT_FALSE(Manual::files().isEmpty());
    const QStringList pages = QDir(englishPages).entryList({QStringLiteral("*.md")});
    EXPECT_GT(pages.size(), 25);
    EXPECT_EQ(QDir(germanPages).entryList({QStringLiteral("*.md")}), pages);
    for (const QString &page : pages)
        EXPECT_EQ(outlineOf(germanPages + page), outlineOf(englishPages + page)) << page.toStdString();
}

TEST(ManualInGerman, ShowsTheGermanWindow)
{
    ASSERT_FALSE(Manual::files().isEmpty());
    static const QRegularExpression picture(QStringLiteral("!\\[[^\\]]*\\]\\(([^)]+)\\)"));
    int seen = 0;
    for (const QString &page : QDir(germanPages).entryList({QStringLiteral("*.md")}))
        for (auto each = picture.globalMatch(linesOf(germanPages + page).join(u'\n')); each.hasNext();
             ++seen) {
            const QString path = each.next().captured(1);
            EXPECT_TRUE(path.startsWith(QStringLiteral("../../images/de/"))) << path.toStdString();
            EXPECT_TRUE(QFile::exists(QDir::cleanPath(germanPages + path))) << path.toStdString();
        }
    EXPECT_GT(seen, 30);
}

} // namespace
} // namespace codewheel
