// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace codewheel {

// Enter that is held presses once: what it opens is not agreed to by the same press, and nothing is sent or
// written once more. In texts of several lines it goes on making lines. Installed on the application.
class HeldEnterRule : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    bool eventFilter(QObject *watched, QEvent *event) override;
};

} // namespace codewheel
