// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QUrl>

#include <vector>

class QTextDocument;

namespace codewheel {

// A heading of the manual, with what stands below it up to the next one.
struct ManualSection
{
    QString title;
    QString anchor; // as links of the manual name it: "offline-and-online"
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

// The user manual, docs/manual and the pages it leads to, as it was when the program was built. It lies in a
// file beside the program, which is opened when the manual is, and of which only what is looked at is read.
class Manual
{
public:
    Manual();

    bool isThere() const { return !m_pages.empty(); }
    static QString file(); // where it lies, or where it was looked for
    // In the order of the manual's first page, then the rest by name.
    const std::vector<ManualPage> &pages() const { return m_pages; }
    const ManualPage *find(const QUrl &url) const; // null: there is no such page
    // Whether there is such a page, with such a heading if the topic names one.
    bool has(const QUrl &url) const;
    static QUrl firstPage();
    // As setHelpTopic() has it.
    static QUrl url(const QString &topic);

private:
    std::vector<ManualPage> m_pages;
};

} // namespace codewheel
