// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QDoubleSpinBox;
class QGridLayout;
class QWidget;

namespace codewheel {

// A number for a calculator of the wizard. `caption` includes its mnemonic, `name` is for screen readers.
struct CalculatorField
{
    QString caption;
    QString name;
    QString toolTip;
    double least = 0;
    int decimals = 3;
};
QDoubleSpinBox *addCalculatorField(QGridLayout &grid, QWidget &parent, const CalculatorField &field,
                                   double value);

} // namespace codewheel
