// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/training/training_fields.h"

#include "widgets/look/describe.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"

#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

namespace codewheel::training_fields {
namespace {

// Its text becomes selectable under the mouse: a selectable label costs six times as much to paint.
class NumberLabel : public QLabel
{
public:
    using QLabel::QLabel;

protected:
    void enterEvent(QEnterEvent *event) override
    {
        QLabel::enterEvent(event);
        setTextInteractionFlags(Qt::TextSelectableByMouse);
    }
    void leaveEvent(QEvent *event) override
    {
        QLabel::leaveEvent(event);
        if (!hasSelectedText())
            setTextInteractionFlags(Qt::NoTextInteraction);
    }
};

} // namespace

QLabel *numberLabel(const QString &name, QWidget *parent)
{
    auto *label = new NumberLabel(parent);
    label->setFont(numberFont());
    label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    label->setAccessibleName(name);
    label->setAutoFillBackground(true);
    // Of fixed size, so that a new number does not lay out the panel again.
    label->setFixedSize(QFontMetrics(numberFont()).size(0, QStringLiteral("-33,554,431")));
    return label;
}

void prepare(QAbstractSpinBox *field, int digits)
{
    field->setFont(numberFont());
    field->setAlignment(Qt::AlignRight);
    field->setKeyboardTracking(false);
    field->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    field->setMinimumWidth(QFontMetrics(numberFont()).averageCharWidth() * digits + 2 * grid::margin);
}

QToolButton *buttonBeside(Icon icon, const QString &name, QWidget *parent)
{
    auto *button = describe(new QToolButton(parent), name, name);
    button->setIcon(lineIcon(icon));
    button->setFocusPolicy(Qt::StrongFocus);
    return button;
}

QCheckBox *addBox(QVBoxLayout *column, const QString &text, const QString &toolTip)
{
    auto *box = new QCheckBox(text, column->parentWidget());
    box->setToolTip(toolTip);
    column->addWidget(box);
    return box;
}

QGridLayout *fieldGrid()
{
    auto *fields = new QGridLayout;
    fields->setHorizontalSpacing(grid::unit);
    fields->setVerticalSpacing(grid::unit);
    fields->setColumnStretch(1, 1);
    return fields;
}

void addSpeed(QGridLayout *grid, int row, const QString &caption, DecimalField *speed, double fastest,
              const QString &stopName)
{
    speed->setRange(-fastest, fastest);
    speed->setDecimals(1);
    speed->setSingleStep(10);
    prepare(speed, 8);
    auto *stop = buttonBeside(Icon::stop, stopName, speed->parentWidget());
    addCaption(grid, row, caption, speed);
    grid->addWidget(speed, row, 1);
    grid->addWidget(stop, row, 2);
    QObject::connect(stop, &QToolButton::clicked, speed, [speed] { speed->setValue(0); });
}

void addCaption(QGridLayout *grid, int row, const QString &text, QWidget *field)
{
    auto *caption = new QLabel(text, field->parentWidget());
    caption->setBuddy(field);
    grid->addWidget(caption, row, 0);
}

void addNumber(QGridLayout *grid, int row, const QString &text, QLabel *number)
{
    addCaption(grid, row, text, number);
    grid->addWidget(number, row, 1, 1, -1, Qt::AlignRight);
}

} // namespace codewheel::training_fields
