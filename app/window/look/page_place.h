// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QMainWindow;

namespace codewheel {

// Has the place of a page, in a panel or among the pages of the window, until that is made: because most
// people never need it, it is wanted only when its place is shown.
class PagePlace : public QWidget
{
    Q_OBJECT

public:
    using QWidget::QWidget;

    void giveWay(QWidget *page);                                  // once
    QWidget *page() { return m_page != nullptr ? m_page : this; } // what is there now
    // For what looks through all pages, shown or not.
    static void wantAll(const QMainWindow &window);

Q_SIGNALS:
    void pageWanted();

protected:
    void showEvent(QShowEvent *) override { Q_EMIT pageWanted(); }

private:
    QWidget *m_page = nullptr;
};

} // namespace codewheel
