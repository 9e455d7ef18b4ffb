// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace codewheel {

// A painted widget that shows a value, and puts it into words for screen readers: accessible name as set,
// description from valueText(). Base of the dial and of the bar.
class ValueWidget : public QWidget
{
    Q_OBJECT

public:
    explicit ValueWidget(QWidget *parent = nullptr);

    virtual QString valueText() const = 0;
};

} // namespace codewheel
