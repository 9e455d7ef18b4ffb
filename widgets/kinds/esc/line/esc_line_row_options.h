// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QCheckBox;

namespace codewheel {

class TrafficTable;

// What is shown of a line's rows: the program's own requests, text, bytes.
class EscLineRowOptions : public QWidget
{
    Q_OBJECT

public:
    explicit EscLineRowOptions(TrafficTable &table, QWidget *parent = nullptr);

Q_SIGNALS:
    void changed();

private:
    QCheckBox *addBox(const QString &text, const QString &toolTip, bool isOn);
};

} // namespace codewheel
