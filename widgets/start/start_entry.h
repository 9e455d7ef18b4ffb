// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPushButton>

class QAction;
class QLabel;

namespace codewheel {

// An action as a large button: icon, title, a sentence about what it does (its tooltip), and its key.
class StartEntry : public QPushButton
{
    Q_OBJECT

public:
    // The action outlives it, and provides its texts.
    explicit StartEntry(QAction &action, QWidget *parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

private:
    void follow();

    QAction &m_action;
    QLabel *m_icon;
    QLabel *m_title;
    QLabel *m_sentence;
    QLabel *m_key;
};

} // namespace codewheel
