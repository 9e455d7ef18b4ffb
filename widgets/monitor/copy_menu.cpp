// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/copy_menu.h"

#include "widgets/look/icons.h"

namespace codewheel {

CopyMenu::CopyMenu(QWidget *view)
    : QMenu(tr("Copy &as"), view)
    , m_plcWords(new QAction(lineIcon(Icon::copy), tr("Copy as &two words of a PLC"), view))
{
    m_plcWords->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_C);
    m_plcWords->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    connect(m_plcWords, &QAction::triggered, this, [this] { Q_EMIT chosen(WordNotation::plcWords); });
    setIcon(lineIcon(Icon::copy));
    const auto add = [this](const QString &text, WordNotation notation) {
        connect(addAction(text), &QAction::triggered, this, [this, notation] { Q_EMIT chosen(notation); });
    };
    add(tr("&Hexadecimal: 020000FF"), WordNotation::hexadecimal);
    add(tr("&PLC: 16#0200_00FF"), WordNotation::plc);
    add(tr("PLC, two &words: 16#0200 16#00FF"), WordNotation::plcWords);
    add(tr("&Decimal: 33554687"), WordNotation::decimal);
    add(tr("&Binary: 2#0000_0010_…"), WordNotation::binary);
}

void CopyMenu::setOffered(bool offered)
{
    m_plcWords->setVisible(offered);
    menuAction()->setVisible(offered);
}

} // namespace codewheel
