// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/input/number_fields.h"
#include "widgets/look/icons.h"
#include "widgets/look/wrapped_label.h"

#include <QLineEdit>
#include <QString>

class QAbstractSpinBox;
class QCheckBox;
class QGridLayout;
class QLabel;
class QToolButton;
class QVBoxLayout;
class QWidget;

// The fields of the training panel: as narrow as the dock wants, each named for screen readers.
namespace codewheel::training_fields {

QLabel *numberLabel(const QString &name, QWidget *parent);
void prepare(QAbstractSpinBox *field, int digits);
QToolButton *buttonBeside(Icon icon, const QString &name, QWidget *parent);
QCheckBox *addBox(QVBoxLayout *column, const QString &text, const QString &toolTip);
// Two columns, captions and fields, with room for a button after them.
QGridLayout *fieldGrid();
// The speed of something that moves, with a button that stops it.
void addSpeed(QGridLayout *grid, int row, const QString &caption, DecimalField *speed, double fastest,
              const QString &stopName);
void addCaption(QGridLayout *grid, int row, const QString &text, QWidget *field);
void addNumber(QGridLayout *grid, int row, const QString &text, QLabel *number);

// What is wrong with what was typed, for the place below the field: no button of the panel would tell it.
template <typename Field>
QLabel *wrongInput(const Field *field, QWidget *parent)
{
    QLabel *label = wrappedLabel(parent, "wrongInput");
    label->hide();
    const auto *text = field->template findChild<QLineEdit *>();
    QObject::connect(text, &QLineEdit::textChanged, label, [label, field] {
        label->setText(field->complaint());
        label->setVisible(!label->text().isEmpty());
    });
    return label;
}

} // namespace codewheel::training_fields
