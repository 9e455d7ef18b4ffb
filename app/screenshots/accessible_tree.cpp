// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/screenshots/accessible_tree.h"

#include <QAccessible>
#include <QMainWindow>
#include <QMetaEnum>
#include <QStringList>
#include <QWidget>

#include <algorithm>
#include <utility>

namespace codewheel {
namespace {

constexpr int mostChildren = 2'000; // children of one element: a table of words may have more, all alike

QString roleOf(const QAccessibleInterface &element)
{
    return QString::fromLatin1(QMetaEnum::fromType<QAccessible::Role>().valueToKey(element.role()));
}

QString statesOf(const QAccessible::State &state)
{
    QStringList states;
    const auto add = [&states](bool on, const char *name) {
        if (on)
            states << QString::fromLatin1(name);
    };
    add(state.disabled, "disabled");
    add(state.checked, "checked");
    add(state.selected, "selected");
    add(state.expanded, "expanded");
    add(state.readOnly, "read only");
    add(state.defaultButton, "default");
    return states.join(QStringLiteral(", "));
}

QString lineOf(const QAccessibleInterface &element)
{
    QString line = roleOf(element);
    const std::pair<QAccessible::Text, const char *> texts[] = {{QAccessible::Name, "name"},
                                                                {QAccessible::Value, "value"},
                                                                {QAccessible::Description, "description"},
                                                                {QAccessible::Accelerator, "key"}};
    for (const auto &[text, what] : texts)
        if (const QString its = element.text(text); !its.isEmpty())
            line += QStringLiteral(" %1=\"%2\"").arg(QLatin1String(what), QString(its).replace(u'\n', u'|'));
    if (const QString states = statesOf(element.state()); !states.isEmpty())
        line += QStringLiteral(" [%1]").arg(states);
    return line;
}

// The tabs of panels come last, sorted: a window keeps them in no particular order.
QString treeOf(const QAccessibleInterface *element, int depth)
{
    if (element == nullptr || element->state().invisible)
        return {};
    QString tree = QString(qsizetype{2} * depth, u' ') + lineOf(*element) + u'\n';
    const bool hasPanels = qobject_cast<const QMainWindow *>(element->object()) != nullptr;
    QStringList tabs;
    for (int i = 0; i < std::min(element->childCount(), mostChildren); ++i) {
        const QAccessibleInterface *child = element->child(i);
        if (hasPanels && child != nullptr && child->role() == QAccessible::PageTabList)
            tabs << treeOf(child, depth + 1);
        else
            tree += treeOf(child, depth + 1);
    }
    tabs.sort();
    return tree + tabs.join(QString());
}

} // namespace

QString accessibleTree(QWidget &widget)
{
    return treeOf(QAccessible::queryAccessibleInterface(&widget), 0);
}

} // namespace codewheel
