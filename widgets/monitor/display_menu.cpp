// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/display_menu.h"

namespace codewheel {

DisplayMenu::DisplayMenu(QWidget *parent)
    : QMenu(parent)
{
    addFlag(tr("Bits in &rows of 8"), &MonitorDisplay::matrix);
    addFlag(tr("Bar over the &position range"), &MonitorDisplay::bar);
    addSeparator();
    addFlag(tr("&Decimal"), &MonitorDisplay::decimal);
    addFlag(tr("&Signed"), &MonitorDisplay::signedDecimal);
    addFlag(tr("&Gray"), &MonitorDisplay::gray);
    addFlag(tr("&Binary"), &MonitorDisplay::binary);
    addSeparator();
    addFlag(tr("Numbers of the &whole word, not of D24..D0"), &MonitorDisplay::wholeWord);
}

void DisplayMenu::addFlag(const QString &text, bool MonitorDisplay::*value)
{
    QAction *action = addAction(text);
    action->setCheckable(true);
    action->setChecked(m_display.*value);
    m_flags.emplace_back(action, value);
    connect(action, &QAction::triggered, this, [this, value](bool on) {
        m_display.*value = on;
        Q_EMIT chosen(m_display);
    });
}

void DisplayMenu::setDisplay(const MonitorDisplay &display)
{
    m_display = display;
    for (const auto &[action, value] : m_flags)
        action->setChecked(m_display.*value);
}

} // namespace codewheel
