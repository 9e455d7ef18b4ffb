// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QStringList>
#include <QTextBrowser>

namespace codewheel {

class Manual;

// Shows the pages of the manual: pictures no wider than the window, and light or dark as the program is; the
// words of a search are marked. Follows links by itself.
class HelpBrowser : public QTextBrowser
{
    Q_OBJECT

public:
    HelpBrowser(const Manual &manual, QWidget *parent = nullptr);

    // On this page and the following ones; none: nothing is marked.
    void mark(const QStringList &words);
    int marked() const { return static_cast<int>(m_marks.size()); }
    // To the next marked word after the selection, or the previous one, wrapping around at the end. Returns
    // its number, from 1; 0: there is none.
    int goToMark(bool forward);
    // To the first one from the top of the visible part; also returns its number.
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
    void fitPictures();
    QImage picture(const QUrl &url) const;
    void findMarks();
    void choose(const QTextCursor &mark);

    const Manual &m_manual;
    QUrl m_url;      // the destination, or the present page
    QUrl m_prepared; // the page already formatted
    QStringList m_words;
    QList<QTextCursor> m_marks;
    QHash<QUrl, int> m_left; // scroll position of each page when it was left
    int m_width = 0;         // that the pictures are fitted to
};

} // namespace codewheel
