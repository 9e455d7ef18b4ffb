// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/painted_parts.h"

#include <QAccessibleWidget>
#include <QPointer>
#include <QWidget>
#include <QWindow>

#include <map>

namespace codewheel {
namespace {

// One part: a check box, with a toggle action if it can be edited.
class PartAccessible final : public QAccessibleInterface, public QAccessibleActionInterface
{
public:
    PartAccessible(QWidget &widget, int part)
        : m_widget(&widget)
        , m_part(part)
    {}

    int part() const { return m_part; }

    bool isValid() const override { return !m_widget.isNull(); }
    QObject *object() const override { return nullptr; } // the widget's object is the group
    QWindow *window() const override { return m_widget ? m_widget->window()->windowHandle() : nullptr; }
    QAccessibleInterface *parent() const override { return QAccessible::queryAccessibleInterface(m_widget); }
    QAccessibleInterface *child(int) const override { return nullptr; }
    QAccessibleInterface *childAt(int, int) const override { return nullptr; }
    int childCount() const override { return 0; }
    int indexOfChild(const QAccessibleInterface *) const override { return -1; }
    void setText(QAccessible::Text, const QString &) override {}
    QAccessible::Role role() const override { return QAccessible::CheckBox; }
    QString text(QAccessible::Text text) const override;
    QRect rect() const override;
    QAccessible::State state() const override;
    void *interface_cast(QAccessible::InterfaceType type) override;
    QStringList actionNames() const override;
    void doAction(const QString &name) override;
    QStringList keyBindingsForAction(const QString &) const override { return {}; }

private:
    PaintedParts &parts() const { return *dynamic_cast<PaintedParts *>(m_widget.data()); }

    QPointer<QWidget> m_widget;
    int m_part;
};

QString PartAccessible::text(QAccessible::Text text) const
{
    if (!m_widget)
        return {};
    switch (text) {
    case QAccessible::Name:
        return parts().partName(m_part);
    case QAccessible::Description:
        return parts().partDescription(m_part);
    default:
        return {};
    }
}

QRect PartAccessible::rect() const
{
    if (!m_widget)
        return {};
    const QRect cell = parts().partRect(m_part);
    return {m_widget->mapToGlobal(cell.topLeft()), cell.size()};
}

QAccessible::State PartAccessible::state() const
{
    QAccessible::State state;
    if (!m_widget) {
        state.invalid = true;
        return state;
    }
    state.checkable = true;
    state.checked = parts().isPartChecked(m_part);
    state.readOnly = !parts().isPartEditable(m_part);
    state.disabled = !m_widget->isEnabled();
    state.invisible = !m_widget->isVisible();
    state.focusable = true;
    state.focused = m_widget->hasFocus() && parts().focusedPart() == m_part;
    return state;
}

void *PartAccessible::interface_cast(QAccessible::InterfaceType type)
{
    return type == QAccessible::ActionInterface ? static_cast<QAccessibleActionInterface *>(this) : nullptr;
}

QStringList PartAccessible::actionNames() const
{
    if (m_widget && m_widget->isEnabled() && parts().isPartEditable(m_part))
        return {toggleAction(), setFocusAction()};
    return {setFocusAction()};
}

void PartAccessible::doAction(const QString &name)
{
    if (!m_widget || !m_widget->isEnabled())
        return;
    if (name == toggleAction()) {
        parts().togglePart(m_part);
    } else if (name == setFocusAction()) {
        parts().focusPart(m_part);
        m_widget->setFocus(Qt::OtherFocusReason);
    }
}

// The group. Its children are made when first asked for.
class PartsAccessible final : public QAccessibleWidget
{
public:
    explicit PartsAccessible(QWidget &widget)
        : QAccessibleWidget(&widget, QAccessible::Grouping)
    {}
    ~PartsAccessible() override
    {
        for (const auto &[part, id] : m_children)
            QAccessible::deleteAccessibleInterface(id);
    }
    PartsAccessible(const PartsAccessible &) = delete;
    PartsAccessible &operator=(const PartsAccessible &) = delete;

    int childCount() const override { return isValid() ? parts().partCount() : 0; }
    QAccessibleInterface *child(int index) const override;
    QAccessibleInterface *childAt(int x, int y) const override;
    int indexOfChild(const QAccessibleInterface *child) const override;
    QAccessibleInterface *focusChild() const override
    {
        return isValid() && widget()->hasFocus() ? child(parts().focusedPart()) : nullptr;
    }

private:
    PaintedParts &parts() const { return *dynamic_cast<PaintedParts *>(widget()); }

    mutable std::map<int, QAccessible::Id> m_children;
};

QAccessibleInterface *PartsAccessible::child(int index) const
{
    if (index < 0 || index >= childCount())
        return nullptr;
    QAccessible::Id &id = m_children[index];
    if (id == 0)
        id = QAccessible::registerAccessibleInterface(new PartAccessible(*widget(), index));
    return QAccessible::accessibleInterface(id);
}

QAccessibleInterface *PartsAccessible::childAt(int x, int y) const
{
    if (!isValid())
        return nullptr;
    const auto part = parts().partAt(widget()->mapFromGlobal(QPoint(x, y)));
    return part ? child(*part) : nullptr;
}

int PartsAccessible::indexOfChild(const QAccessibleInterface *child) const
{
    const auto *part = dynamic_cast<const PartAccessible *>(child);
    return part != nullptr && part->parent() == this ? part->part() : -1;
}

QAccessibleInterface *makePartsInterface(const QString &, QObject *object)
{
    const bool hasParts = object != nullptr && dynamic_cast<PaintedParts *>(object) != nullptr;
    return hasParts ? new PartsAccessible(*static_cast<QWidget *>(object)) : nullptr;
}

} // namespace

std::optional<int> PaintedParts::partAt(QPoint point) const
{
    for (int part = 0; part < partCount(); ++part)
        if (partRect(part).contains(point))
            return part;
    return std::nullopt;
}

void installPaintedPartsAccessibility()
{
    QAccessible::installFactory(makePartsInterface); // ignored if it is there already
}

void announcePartFocus(QWidget &widget, int part)
{
    QAccessibleEvent event(&widget, QAccessible::Focus);
    event.setChild(part);
    QAccessible::updateAccessibility(&event);
}

void announcePartState(QWidget &widget, int part)
{
    QAccessible::State changed;
    changed.checked = true;
    QAccessibleStateChangeEvent event(&widget, changed);
    event.setChild(part);
    QAccessible::updateAccessibility(&event);
}

} // namespace codewheel
