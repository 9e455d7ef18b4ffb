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

void addHeadings(std::vector<ManualHeading> &headings, const QString &markdown, const QString &topic)
{
    static const QRegularExpression heading(QStringLiteral("^#{1,6} +(.*)$"));
    QSet<QString> used;
    QString page;
    bool isCode = false;
    for (const QString &line : markdown.split(u'\n')) {
        isCode ^= line.startsWith(QStringLiteral("```"));
        const auto match = heading.match(line);
        if (isCode || !match.hasMatch())
            continue;
        const QString title = plainHeading(match.captured(1));
        const QString anchor = unusedAnchor(title, used);
        used.insert(anchor);
        const bool isPage = page.isEmpty();
        if (isPage)
            page = title;
        headings.push_back({page, title, isPage ? topic : QStringLiteral("%1#%2").arg(topic, anchor)});
    }
}

} // namespace

std::vector<ManualHeading> manualHeadings()
{
    std::vector<ManualHeading> headings;
    const QDir folder(QFileInfo(u':' + Manual::firstPage().path()).path());
    for (const QString &file : Manual::files()) {
        QFile source(file);
        if (source.open(QIODevice::ReadOnly))
            addHeadings(headings, QString::fromUtf8(source.readAll()), folder.relativeFilePath(file));
    }
    return headings;
}

} // namespace codewheel
