// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/look/tool_bar_fit.h"

#include "app/window/buses/mode_switch.h"
#include "widgets/look/on_event.h"

#include <QAction>
#include <QEvent>
#include <QLayout>
#include <QToolBar>
#include <QToolButton>

#include <vector>

namespace codewheel {

ToolBarFit::ToolBarFit(QToolBar &bar, ModeSwitch &mode, const QWidget &alarmStop)
    : QObject(&bar)
    , m_bar(bar)
    , m_mode(mode)
    , m_alarmStop(alarmStop)
    , m_measured(new QToolButton(&bar))
{
    m_measured->hide();
    using enum QEvent::Type;
    onEventOf(&bar, {Resize, LayoutRequest, StyleChange, FontChange, Show}, this, [this] { fit(); });
}

QList<QToolButton *> ToolBarFit::buttons() const
{
    QList<QToolButton *> buttons;
    for (QAction *action : m_bar.actions())
        if (auto *button = qobject_cast<QToolButton *>(m_bar.widgetForAction(action));
            button != nullptr && button != &m_alarmStop && action->isVisible())
            buttons << button;
    return buttons;
}

int ToolBarFit::widthOf(const QToolButton &button, bool words) const
{
    m_measured->setFont(button.font());
    m_measured->setAutoRaise(button.autoRaise());
    m_measured->setIcon(button.icon());
    m_measured->setIconSize(button.iconSize());
    m_measured->setText(button.text());
    m_measured->setToolButtonStyle(words ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
    return m_measured->sizeHint().width();
}

// ALARM STOP, separators, spacing and margins.
int ToolBarFit::widthOfRest() const
{
    const QMargins margins = m_bar.layout()->contentsMargins();
    const int spacing = qMax(0, m_bar.layout()->spacing());
    int width = margins.left() + margins.right() + m_alarmStop.sizeHint().width();
    for (QAction *action : m_bar.actions()) {
        if (action->isSeparator())
            width += m_bar.widgetForAction(action)->sizeHint().width();
        width += spacing;
    }
    return width;
}

void ToolBarFit::fit()
{
    using Shown = ModeSwitch::Shown;
    const QList<QToolButton *> all = buttons();
    const int rest = widthOfRest();
    int width = rest + m_mode.widthOf(Shown::all);
    int least = rest + m_mode.widthOf(Shown::icons);
    std::vector<int> saved; // per button, without its words
    for (const QToolButton *button : all) {
        const int whole = widthOf(*button, true);
        const int icon = widthOf(*button, false);
        saved.push_back(whole - icon);
        width += whole;
        least += icon;
    }
    m_bar.setMinimumWidth(least);
    auto withWords = all.size();
    for (; withWords > 0 && width > m_bar.width(); --withWords)
        width -= saved.at(static_cast<std::size_t>(withWords - 1));
    for (qsizetype i = 0; i < all.size(); ++i)
        all.at(i)->setToolButtonStyle(i < withWords ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
    const int others = width - m_mode.widthOf(Shown::all);
    const auto fits = [&](Shown what) { return others + m_mode.widthOf(what) <= m_bar.width(); };
    m_mode.showOnly(fits(Shown::all) ? Shown::all : fits(Shown::words) ? Shown::words : Shown::icons);
}

} // namespace codewheel
