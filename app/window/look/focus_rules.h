// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QKeySequence;
class QStackedWidget;

namespace codewheel {

// Where the focus goes by a key. A letter (Alt+letter) that both the open page and a panel have is that of
// the part with the focus. What gets the focus by a key or by the program comes into sight.
class FocusRules : public QObject
{
    Q_OBJECT

public:
    // `pages` are those of the window, which outlives this.
    FocusRules(QStackedWidget &pages, QObject *parent);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QWidget *partWithFocus() const; // the page or the panel; null: neither
    static bool press(const QWidget &part, const QKeySequence &letter);
    static void showFocus(QWidget *widget);

    QStackedWidget &m_pages;
};

} // namespace codewheel
