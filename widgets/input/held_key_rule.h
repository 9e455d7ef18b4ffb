// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace codewheel {

// A key that is held presses once: what it opens is not agreed to by the same press, and nothing is sent or
// written once more. This goes for Enter, for Alt with the letter of a button, and for a letter alone in
// questions and menus. In texts of several lines Enter goes on making lines. Installed on the application.
class HeldKeyRule : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    bool m_isHeld = false; // the key that a shortcut event is about
};

} // namespace codewheel
