// SPDX-License-Identifier: GPL-3.0-or-later
// The manual as built into the program: everything a page links to or shows exists.
#include "widgets/help/manual.h"
#include "widgets/help/manual_search.h"

#include <QFile>
#include <QTextBlock>
#include <QTextDocument>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

class ManualTest : public testing::Test
{
protected:
    // Visits each link of a page, and each picture.
    template <class Link, class Picture>
    void walk(const ManualPage &page, Link link, Picture picture)
    {
        QFile file(u':' + page.url.path());
        EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << page.url.toString().toStdString();
        QTextDocument document;
        document.setMarkdown(QString::fromUtf8(file.readAll()));
        for (QTextBlock block = document.begin(); block.isValid(); block = block.next())
            for (auto part = block.begin(); !part.atEnd(); ++part) {
                const QTextCharFormat format = part.fragment().charFormat();
                if (!format.anchorHref().isEmpty())
                    link(QUrl(format.anchorHref()));
                if (format.isImageFormat())
                    picture(QUrl(format.toImageFormat().name()));
            }
    }

    Manual manual;
};

TEST_F(ManualTest, BeginsWithTheFirstPageAndHasThoseItLeadsTo)
{
    ASSERT_TRUE(manual.isThere()) << Manual::file().toStdString();
    EXPECT_EQ(manual.pages().front().url, Manual::firstPage());
    EXPECT_TRUE(manual.has(Manual::url(QStringLiteral("project.md#offline-and-online"))));
    EXPECT_TRUE(manual.has(Manual::url(QStringLiteral("../command-line.md#replace"))));
    EXPECT_FALSE(manual.has(Manual::url(QStringLiteral("project.md#nowhere"))));
    EXPECT_FALSE(manual.has(Manual::url(QStringLiteral("../architecture.md")))) << "it is for maintainers";
}

TEST_F(ManualTest, EveryLinkLeadsSomewhere)
{
    int links = 0;
    for (const ManualPage &page : manual.pages())
        walk(
            page,
            [&](const QUrl &link) {
                ++links;
                if (link.scheme().startsWith(u"http"))
                    return;
                const QUrl url = page.url.resolved(link);
                EXPECT_TRUE(manual.has(url))
                    << page.url.fileName().toStdString() << " leads to " << link.toString().toStdString();
            },
            [](const QUrl &) {});
    EXPECT_GT(links, 40);
}

TEST_F(ManualTest, EveryPictureIsThereLightAndDark)
{
    int pictures = 0;
    for (const ManualPage &page : manual.pages())
        walk(
            page, [](const QUrl &) {},
            [&](const QUrl &name) {
                ++pictures;
                QString file = u':' + page.url.resolved(name).path();
                EXPECT_TRUE(QFile::exists(file)) << file.toStdString();
                file.replace(QStringLiteral(".png"), QStringLiteral("-dark.png"));
                EXPECT_TRUE(QFile::exists(file)) << file.toStdString();
            });
    EXPECT_GT(pictures, 20);
}

TEST_F(ManualTest, IsSearchedForSectionsThatHaveAllWords)
{
    const auto hits = searchManual(manual, searchedWords(QStringLiteral("ADAPTER unplugged")));
    ASSERT_FALSE(hits.empty());
    EXPECT_EQ(hits.front().url, Manual::url(QStringLiteral("serial-line.md#when-the-adapter-is-unplugged")))
        << "what has it in its heading comes first";
    EXPECT_FALSE(hits.front().excerpt.isEmpty());
    EXPECT_TRUE(searchManual(manual, searchedWords(QStringLiteral("adapter xyzzy"))).empty());
    EXPECT_TRUE(searchManual(manual, searchedWords(QStringLiteral("  "))).empty());
}

TEST(SearchedWords, AreOneBetweenQuotationMarks)
{
    EXPECT_EQ(searchedWords(QStringLiteral("zero offset")),
              (QStringList{QStringLiteral("zero"), QStringLiteral("offset")}));
    EXPECT_EQ(searchedWords(QStringLiteral("\"zero offset\" K3")),
              (QStringList{QStringLiteral("zero offset"), QStringLiteral("K3")}));
    EXPECT_EQ(searchedWords(QStringLiteral("\"zero off")), QStringList{QStringLiteral("zero off")})
        << "while it is typed";
}

} // namespace
} // namespace codewheel
