// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QLineEdit;

namespace codewheel {

// Below a page: searches it, and shows whether there is a match. Hidden until asked for.
class FindBar : public QWidget
{
    Q_OBJECT

public:
    explicit FindBar(QWidget *parent = nullptr);

    void open();
    QString text() const; // empty while it is hidden
    void showResult(int which, int of);

Q_SIGNALS:
    void changed(); // the text to look for
    void nextRequested();
    void previousRequested();
    void closed();

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    void close();

    QLineEdit *m_text;
    QLabel *m_result;
};

} // namespace codewheel
