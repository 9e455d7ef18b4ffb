// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>

class QAction;

namespace codewheel {

// The hexadecimal field of a monitor: fixed width and fixed font, so that nothing moves while its word does.
// Clicking into it selects the word, as Tab does, so that typing replaces it.
class WordField : public QLineEdit
{
    Q_OBJECT

public:
    // widest: the longest text it will show.
    explicit WordField(const QString &widest, QWidget *parent = nullptr);

    void showText(const QString &text); // does nothing if it is already shown
    // Marks the input as bad; empty: it is good.
    void setProblem(const QString &sentence);
    bool hasProblem() const { return !m_problem.isEmpty(); }

Q_SIGNALS:
    // Typed, pasted, or set by a screen reader (which Qt does not count as edited).
    void typed(const QString &text);

public:
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;

private:
    QString m_widest;
    bool m_isClicked = false; // the click that gave it the focus has not ended
    bool m_shows = false;     // showing a text of the program's own
    QString m_problem;
    QString m_toolTip;
    QAction *m_mark = nullptr;
};

} // namespace codewheel
