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
    m_rows.clear();
}

void CheckList::add(Role role, const QString &what, const QString &sentence)
{
    const bool isFurther = !m_rows.empty() && role == Role::inactive && m_rows.back().step->role() == role &&
                           m_rows.back().told->text() == sentence;
    if (!isFurther)
        addRow();
    const Row &row = m_rows.back();
    const QString title = isFurther ? tr("Further steps") : what;
    row.step->setState(role, title);
    row.told->setText(sentence);
    row.told->setAccessibleName(QStringLiteral("%1: %2").arg(title, sentence));
}

void CheckList::addRow()
{
    const Row row{new RoleLabel(this), wrappedLabel(this, "checkSentence")};
    row.told->setTextFormat(Qt::PlainText);
    row.told->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_grid->addWidget(row.step, count(), 0, Qt::AlignTop | Qt::AlignLeft);
    m_grid->addWidget(row.told, count(), 1, Qt::AlignTop);
    m_rows.push_back(row);
}

QString CheckList::text() const
{
    QStringList lines;
    for (const Row &row : m_rows)
        lines << row.told->accessibleName();
    return lines.join(u'\n');
}

} // namespace codewheel
