// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/value_widget.h"

#include <QAccessibleWidget>

namespace codewheel {

namespace {

class ValueAccessible final : public QAccessibleWidget
{
public:
    explicit ValueAccessible(ValueWidget &widget)
        : QAccessibleWidget(&widget, QAccessible::Indicator)
    {}

    QString text(QAccessible::Text text) const override
    {
        if (text == QAccessible::Description || text == QAccessible::Value)
            return static_cast<const ValueWidget *>(object())->valueText();
        return QAccessibleWidget::text(text);
    }
};

QAccessibleInterface *makeValueInterface(const QString &className, QObject *object)
{
    auto *widget =
        className == QLatin1String("codewheel::ValueWidget") ? qobject_cast<ValueWidget *>(object) : nullptr;
    return widget != nullptr ? new ValueAccessible(*widget) : nullptr;
}

} // namespace

ValueWidget::ValueWidget(QWidget *parent)
    : QWidget(parent)
{
    setAutoFillBackground(true); // so that a changing value does not repaint what is behind it
    QAccessible::installFactory(makeValueInterface); // ignored if it is there already
}

} // namespace codewheel
