// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/page.h"

#include <QPointer>

class QStackedWidget;
class QToolButton;

namespace codewheel {

class MeaningLine;

// The head of the page that is open: what it is, which encoder or bus it is about, what it changes, and
// Close. Not there while the monitors are shown. Esc closes the page, unless something else in the window
// wants it; what would be lost is asked about first.
class PageHead : public QWidget
{
    Q_OBJECT

public:
    // `pages`: the pages, and what is no Page.
    PageHead(QStackedWidget &pages, QWidget &window);

    Page *page() const { return m_page; } // null: the monitors
    void closePage();
    void showHead(); // buses may have other names

Q_SIGNALS:
    void closed();
    void opened(bool isOpen); // a page in place of the monitors, or they in place of it

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void follow();
    bool mayClose(Page &page);
    bool ask(const QString &what);

    QStackedWidget &m_pages;
    QWidget &m_window;
    QPointer<Page> m_page;
    MeaningLine *m_title;
    MeaningLine *m_effect;
    QToolButton *m_close;
};

} // namespace codewheel
