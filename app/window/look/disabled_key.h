// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QKeyEvent;
class QMainWindow;

namespace codewheel {

// The key of an action that is disabled: says in the status line why nothing happens, as the action describes
// itself there.
class DisabledKey : public QObject
{
    Q_OBJECT

public:
    explicit DisabledKey(QMainWindow &window); // is its parent

    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void tell(const QKeyEvent &key);

    QMainWindow &m_window;
};

} // namespace codewheel
