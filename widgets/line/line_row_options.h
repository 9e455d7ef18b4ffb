// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QCheckBox;

namespace codewheel {

class LineRowTable;

// What of the rows of a line is shown: what the program asks by itself, their text, their bytes.
class LineRowOptions : public QWidget
{
    Q_OBJECT

public:
    explicit LineRowOptions(LineRowTable &table, QWidget *parent = nullptr);

Q_SIGNALS:
    void changed();

private:
    QCheckBox *addBox(const QString &text, const QString &toolTip, bool isOn);
};

} // namespace codewheel
