// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/calculator_field.h"

#include "widgets/look/describe.h"
#include "widgets/look/fonts.h"

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>

namespace codewheel {
namespace {

constexpr double largest = 1'000'000;

} // namespace

DecimalField *addCalculatorField(QGridLayout &grid, QWidget &parent, const CalculatorField &field,
                                 double value, const std::function<void()> &changed)
{
    auto *box = describe(new DecimalField(&parent), field.name, field.toolTip);
    box->setDecimals(field.decimals);
    box->setRange(field.least, largest);
    box->setValue(value);
    box->setAlignment(Qt::AlignRight);
    box->setFont(numberFont());
    box->setButtonSymbols(QAbstractSpinBox::NoButtons);
    auto *caption = new QLabel(field.caption, &parent);
    caption->setBuddy(box);
    const int row = grid.rowCount();
    grid.addWidget(caption, row, 0);
    grid.addWidget(box, row, 1);
    QObject::connect(box, &QDoubleSpinBox::valueChanged, &parent, changed);
    QObject::connect(box->findChild<QLineEdit *>(), &QLineEdit::textChanged, &parent, changed);
    return box;
}

QString firstComplaint(std::span<const DecimalField *const> fields)
{
    for (const DecimalField *field : fields)
        if (QString wrong = field->complaint(); !wrong.isEmpty())
            return wrong;
    return {};
}

} // namespace codewheel
