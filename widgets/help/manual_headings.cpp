// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/help/manual_headings.h"

#include "widgets/help/manual.h"
#include "widgets/help/manual_text.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QSet>

namespace codewheel {
namespace {

// Without the marks of links, code and emphasis.
QString plainHeading(QString markdown)
{
    static const QRegularExpression link(QStringLiteral("\\[([^\\]]*)\\]\\([^)]*\\)"));
    static const QRegularExpression marks(QStringLiteral("[`*]"));
    return markdown.replace(link, QStringLiteral("\\1")).remove(marks).simplified();
}

struct Heading
{
    QString title;
    QString anchor;
};

std::vector<Heading> headingsOf(const QString &file)
{
    static const QRegularExpression heading(QStringLiteral("^#{1,6} +(.*)$"));
    QFile source(file);
    if (!source.open(QIODevice::ReadOnly))
        return {};
    const QString markdown = QString::fromUtf8(source.readAll());
    std::vector<Heading> headings;
    QSet<QString> used;
    bool isCode = false;
    for (const QString &line : markdown.split(u'\n')) {
        isCode ^= line.startsWith(QStringLiteral("```"));
        const auto match = heading.match(line);
        if (isCode || !match.hasMatch())
            continue;
        const QString title = plainHeading(match.captured(1));
        headings.push_back({title, unusedAnchor(title, used)});
        used.insert(headings.back().anchor);
    }
    return headings;
}

// Pages of the manual have the same names in each language; the others are named from docs/manual.
QString topicOf(const QString &file)
{
    const QFileInfo firstPage(u':' + Manual::firstPage().path());
    const QFileInfo page(file);
    const QString docs = file.left(file.indexOf(QStringLiteral("/docs/")) + 6);
    return page.path() == firstPage.path() ? page.fileName()
                                           : QStringLiteral("../") + QDir(docs).relativeFilePath(file);
}

} // namespace

QStringList headingAnchors(const QString &file)
{
    QStringList anchors;
    for (const Heading &heading : headingsOf(file))
        anchors << heading.anchor;
    return anchors;
}

std::vector<ManualHeading> manualHeadings()
{
    std::vector<ManualHeading> headings;
    for (const QString &file : Manual::files()) {
        const QString topic = topicOf(file);
        QString page;
        for (const Heading &its : headingsOf(file)) {
            const bool isPage = page.isEmpty();
            if (isPage)
                page = its.title;
            headings.push_back({page, its.title, isPage ? topic : topic + u'#' + its.anchor});
        }
    }
    return headings;
}

} // namespace codewheel
