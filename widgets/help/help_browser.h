// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QStringList>
#include <QTextBrowser>

namespace codewheel {

class Manual;

// Shows the pages of the manual: pictures as wide as the window at most and light or dark as the program is,
// words that are searched for marked. Goes by itself where a link leads.
class HelpBrowser : public QTextBrowser
{
    Q_OBJECT

public:
    HelpBrowser(const Manual &manual, QWidget *parent = nullptr);

    // On this page and those that follow; none: nothing is marked.
    void mark(const QStringList &words);
    int marked() const { return static_cast<int>(m_marks.size()); }
    // To the next marked word behind what is chosen, or the one before it, around the end if need be. Its
    // number, from 1; 0: there is none.
    int goToMark(bool forward);
    // To the first one from the top of what is seen; its number as well.
    int goToFirstMark();

    QVariant loadResource(int type, const QUrl &name) override;
    void backward() override;
    void forward() override;

protected:
    void doSetSource(const QUrl &url, QTextDocument::ResourceType type) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void preparePage();
    void leaveFor(const QUrl &url);
    void returnToPlace();
    void tellLanguage();
    void fitPictures();
    QImage picture(const QUrl &url) const;
    void findMarks();
    void choose(const QTextCursor &mark);

    const Manual &m_manual;
    QUrl m_url;      // where it goes, or is
    QUrl m_prepared; // the page, so that its document is formatted once
    QStringList m_words;
    QList<QTextCursor> m_marks;
    QHash<QUrl, int> m_left; // where each page was when it was left
    int m_width = 0;         // for which the pictures are
};

} // namespace codewheel
