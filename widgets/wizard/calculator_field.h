// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/input/number_fields.h"

#include <QString>

#include <functional>
#include <span>

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
// `changed`: its value, or whether what is in it is good.
DecimalField *addCalculatorField(QGridLayout &grid, QWidget &parent, const CalculatorField &field,
                                 double value, const std::function<void()> &changed);

// What is wrong with the first of the fields that is; empty: nothing.
QString firstComplaint(std::span<const DecimalField *const> fields);

} // namespace codewheel
