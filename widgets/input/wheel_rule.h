// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace codewheel {

// No field changes by the wheel unless it has the focus, and the wheel gives no focus, so that scrolling over
// a form only scrolls. Installed on the application, it holds for every number, choice and slider of the
// program.
class WheelRule : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    bool eventFilter(QObject *watched, QEvent *event) override;
};

} // namespace codewheel
