// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/help/manual.h"

#include "widgets/help/manual_headings.h"
#include "widgets/help/manual_text.h"

#include <QCoreApplication>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QResource>
#include <QTextBlock>
#include <QTextDocument>

#include <algorithm>

namespace codewheel {
namespace {

constexpr auto docsFolder = u":/codewheel-manual/docs/";
constexpr auto manualFolder = u":/codewheel-manual/docs/manual/"; // in English; others are within it

// In the build tree, or installed.
QStringList placesOfManual()
{
    const QString folder = QCoreApplication::applicationDirPath();
    return {folder + QStringLiteral("/codewheel-manual.rcc"),
            folder + QStringLiteral("/../share/codewheel/codewheel-manual.rcc")};
}

// A file of the resource and its URL.
QString fileOf(const QUrl &url)
{
    return u':' + url.path();
}

QUrl urlOf(const QString &file)
{
    return QUrl(QStringLiteral("qrc") + file);
}

// Of the manual in the program's language.
QString folderOfManual()
{
    const QString language =
        QCoreApplication::translate("DeviceDescription", "en", "code of the language of these texts");
    const QString folder = QString::fromUtf16(manualFolder) + language + u'/';
    return QFile::exists(folder + QStringLiteral("README.md")) ? folder : QString::fromUtf16(manualFolder);
}

bool isOfOtherLanguage(const QString &file)
{
    return file.startsWith(QString::fromUtf16(manualFolder)) &&
           QFileInfo(file).path() + u'/' != folderOfManual();
}

std::vector<ManualSection> sectionsOfPage(const QTextDocument &document)
{
    std::vector<ManualSection> sections;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        if (const int level = block.blockFormat().headingLevel(); level > 0 || sections.empty())
            sections.push_back({block.text(), anchorOf(block), level, {}});
        else
            sections.back().text += block.text() + u'\n';
    }
    return sections;
}

// Pages that the first one leads to, in its order.
void addLinked(std::vector<QUrl> &urls, const QTextDocument &document)
{
    const QUrl from = Manual::firstPage();
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next())
        for (auto part = block.begin(); !part.atEnd(); ++part) {
            const QString link = part.fragment().charFormat().anchorHref();
            const QUrl url = from.resolved(QUrl(link)).adjusted(QUrl::RemoveFragment);
            if (!link.isEmpty() && QFile::exists(fileOf(url)) && std::ranges::find(urls, url) == urls.end())
                urls.push_back(url);
        }
}

void addOthers(std::vector<QUrl> &urls)
{
    for (const QString &file : Manual::files())
        if (std::ranges::find(urls, urlOf(file)) == urls.end())
            urls.push_back(urlOf(file));
}

} // namespace

QString Manual::file()
{
    const QStringList places = placesOfManual();
    const auto found =
        std::ranges::find_if(places, [](const QString &place) { return QFile::exists(place); });
    return found == places.end() ? places.front() : *found;
}

bool Manual::open()
{
    return QFile::exists(fileOf(firstPage())) ||
           (QResource::registerResource(file()) && QFile::exists(fileOf(firstPage())));
}

QStringList Manual::files()
{
    if (!open())
        return {};
    QStringList files;
    for (QDirIterator each(QString::fromUtf16(docsFolder), {QStringLiteral("*.md")}, QDir::Files,
                           QDirIterator::Subdirectories);
         each.hasNext();)
        files << each.next();
    files.removeIf(isOfOtherLanguage);
    files.sort();
    return files;
}

Manual::Manual()
{
    if (!open())
        return;
    std::vector<QUrl> urls{firstPage()};
    for (std::size_t i = 0; i < urls.size(); ++i) {
        QFile source(fileOf(urls[i]));
        if (!source.open(QIODevice::ReadOnly))
            continue;
        QTextDocument document;
        document.setUndoRedoEnabled(false);
        document.setMarkdown(QString::fromUtf8(source.readAll()));
        nameHeadings(document);
        auto sections = sectionsOfPage(document);
        const QString title = sections.empty() ? source.fileName() : sections.front().title;
        m_pages.push_back({urls[i], title, std::move(sections),
                           urls[i].path().startsWith(firstPage().adjusted(QUrl::RemoveFilename).path())});
        if (i == 0) {
            addLinked(urls, document);
            addOthers(urls);
        }
    }
    std::stable_partition(m_pages.begin(), m_pages.end(),
                          [](const ManualPage &page) { return page.isOfManual; });
}

const ManualPage *Manual::find(const QUrl &url) const
{
    const auto found = std::ranges::find(m_pages, url.adjusted(QUrl::RemoveFragment), &ManualPage::url);
    return found == m_pages.end() ? nullptr : &*found;
}

bool Manual::has(const QUrl &url) const
{
    const ManualPage *page = find(url);
    return page != nullptr &&
           (!url.hasFragment() || std::ranges::count(page->sections, url.fragment(), &ManualSection::anchor));
}

QUrl Manual::firstPage()
{
    return urlOf(folderOfManual() + QStringLiteral("README.md"));
}

QUrl Manual::url(const QString &topic)
{
    return translated(urlOf(QString::fromUtf16(manualFolder)).resolved(QUrl(topic)));
}

QUrl Manual::translated(const QUrl &url)
{
    const QString file = fileOf(url);
    const QFileInfo page(file);
    const QString own = folderOfManual() + page.fileName();
    if (page.path() + u'/' != QString::fromUtf16(manualFolder) || own == file || !QFile::exists(own))
        return url;
    QUrl same = urlOf(own);
    const QString anchor = url.fragment(QUrl::FullyDecoded);
    const QStringList ownAnchors = headingAnchors(own);
    const qsizetype which = headingAnchors(file).indexOf(anchor);
    if (!anchor.isEmpty())
        same.setFragment(which >= 0 && which < ownAnchors.size() ? ownAnchors[which] : anchor);
    return same;
}

} // namespace codewheel
