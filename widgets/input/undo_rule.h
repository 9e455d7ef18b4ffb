// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace codewheel {

// Ctrl+Z in a field in which nothing is being typed undoes the last step of the project, as it does
// everywhere else; Qt's fields would do nothing then. Installed on the application.
class UndoRule : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    bool eventFilter(QObject *watched, QEvent *event) override;
};

} // namespace codewheel
