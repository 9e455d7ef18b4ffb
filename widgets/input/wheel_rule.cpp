// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/input/wheel_rule.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QScrollBar>
#include <QWidget>

namespace codewheel {
namespace {

QWidget *fieldIn(QObject *watched)
{
    const bool isField = qobject_cast<QAbstractSpinBox *>(watched) != nullptr ||
                         qobject_cast<QComboBox *>(watched) != nullptr ||
                         (qobject_cast<QAbstractSlider *>(watched) != nullptr &&
                          qobject_cast<QScrollBar *>(watched) == nullptr);
    return isField ? static_cast<QWidget *>(watched) : nullptr;
}

} // namespace

bool WheelRule::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::Wheel && event->type() != QEvent::Polish)
        return false;
    QWidget *field = fieldIn(watched);
    if (field == nullptr)
        return false;
    if (event->type() == QEvent::Polish) {
        if (field->focusPolicy() == Qt::WheelFocus)
            field->setFocusPolicy(Qt::StrongFocus);
        return false;
    }
    if (field->hasFocus())
        return false;
    event->ignore(); // so that the surroundings of the field scroll
    return true;
}

} // namespace codewheel
