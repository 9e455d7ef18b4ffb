// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <QUrl>

#include <vector>

namespace codewheel {

// A heading of the manual, with the text below it up to the next one.
struct ManualSection
{
    QString title;
    QString anchor; // as in links of the manual: "offline-and-online"
    int level = 1;
    QString text;
};

struct ManualPage
{
    QUrl url;
    QString title;
    std::vector<ManualSection> sections; // the first is the page's own heading
    bool isOfManual = true;              // else a page that the manual leads to: files, protocols
};

// The user manual, docs/manual or docs/manual/LANGUAGE, and the pages it leads to, as of the build. It is in
// a file beside the program, opened only when the manual is, of which only the pages looked at are read.
//
// Its pages have the same names and the same headings in each language, so that a topic, which names those of
// the English one, leads to the page of the program's language.
class Manual
{
public:
    Manual();

    bool isThere() const { return !m_pages.empty(); }
    static QString file();      // where it lies, or where it was looked for
    static QStringList files(); // its pages in the program's language as resources, by name; opens it
    // In the order of the manual's first page, then the rest by name.
    const std::vector<ManualPage> &pages() const { return m_pages; }
    const ManualPage *find(const QUrl &url) const; // null: there is no such page
    // Whether there is such a page, with such a heading if the topic names one.
    bool has(const QUrl &url) const;
    static QUrl firstPage();
    // From a topic in the form of setHelpTopic(), or of ManualHeading.
    static QUrl url(const QString &topic);
    // The same page and heading in the program's language; pages that are not of the manual are in one only.
    static QUrl translated(const QUrl &url);

private:
    static bool open(); // false: there is none

    std::vector<ManualPage> m_pages;
};

} // namespace codewheel
