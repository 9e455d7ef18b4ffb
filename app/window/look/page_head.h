// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/page.h"

#include <QPointer>

class QStackedWidget;
class QToolButton;

namespace codewheel {

class MeaningLine;

// The head of the open page: what it is, which encoder or bus it is about, what it changes, and Close. Hidden
// while the monitors are shown. Esc closes the page, unless something else in the window takes it; first it
// asks about anything that would be lost.
class PageHead : public QWidget
{
    Q_OBJECT

public:
    // `pages`: the pages, and the widgets that are no Page.
    PageHead(QStackedWidget &pages, QWidget &window);

    Page *page() const { return m_page; } // null: the monitors
    void closePage();
    void showHead(); // buses may have other names
    // What is shown needs the height of the panels at the bottom: all but the monitors do.
    bool needsRoom() const { return m_needsRoom; }

Q_SIGNALS:
    void closed();
    void opened(bool isOpen); // a page, or there is none now
    void roomChanged();       // needsRoom(): it is there before the head needs it

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void follow();
    void take(Page *page);
    void setNeedsRoom(bool needs);
    bool mayClose(Page &page);
    bool ask(const QString &what);

    QStackedWidget &m_pages;
    QWidget &m_window;
    QPointer<Page> m_page;
    bool m_needsRoom = false;
    MeaningLine *m_title;
    MeaningLine *m_effect;
    QToolButton *m_close;
};

} // namespace codewheel
