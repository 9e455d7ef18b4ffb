// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connect/check_list.h"

#include "widgets/look/grid.h"
#include "widgets/look/role_label.h"
#include "widgets/look/wrapped_label.h"

#include <QGridLayout>
#include <QLabel>

namespace codewheel {

CheckList::CheckList(QWidget *parent)
    : QWidget(parent)
    , m_grid(new QGridLayout(this))
{
    setAccessibleName(tr("Steps of the test"));
    m_grid->setContentsMargins({});
    m_grid->setHorizontalSpacing(grid::groupGap);
    m_grid->setVerticalSpacing(grid::unit);
    m_grid->setColumnStretch(1, 1);
}

void CheckList::clear()
{
    while (const QLayoutItem *item = m_grid->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    m_rows = 0;
    m_lines.clear();
}

void CheckList::add(Role role, const QString &what, const QString &sentence)
{
    auto *step = new RoleLabel(this);
    step->setState(role, what);
    auto *told = wrappedLabel(this, "checkSentence");
    told->setTextFormat(Qt::PlainText);
    told->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    told->setText(sentence);
    told->setAccessibleName(QStringLiteral("%1: %2").arg(what, sentence));
    m_grid->addWidget(step, m_rows, 0, Qt::AlignTop | Qt::AlignLeft);
    m_grid->addWidget(told, m_rows, 1, Qt::AlignTop);
    ++m_rows;
    m_lines << told->accessibleName();
}

QString CheckList::text() const
{
    return m_lines.join(u'\n');
}

} // namespace codewheel
