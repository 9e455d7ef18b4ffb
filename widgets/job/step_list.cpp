// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/job/step_list.h"

#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/on_event.h"
#include "widgets/look/roles.h"

#include <QGridLayout>
#include <QLabel>

#include <algorithm>

namespace codewheel {

StepList::StepList(const QStringList &titles, QWidget *parent)
    : QWidget(parent)
    , m_titles(titles)
{
    auto *layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, grid::margin, 0);
    layout->setHorizontalSpacing(grid::unit);
    layout->setVerticalSpacing(grid::margin);
    for (const QString &title : titles) {
        auto *icon = new QLabel(this);
        auto *label = new QLabel(title, this);
        icon->setFixedSize(grid::smallIcon, grid::smallIcon);
        const int row = static_cast<int>(m_labels.size());
        layout->addWidget(icon, row, 0);
        layout->addWidget(label, row, 1);
        m_icons.append(icon);
        m_labels.append(label);
    }
    layout->setRowStretch(static_cast<int>(titles.size()), 1);
    draw();
    onEvent(this, {QEvent::PaletteChange, QEvent::StyleChange}, [this] { draw(); });
}

void StepList::setCurrent(int step)
{
    m_current = step;
    setAccessibleName(tr("Step %1 of %2: %3").arg(step + 1).arg(m_titles.size()).arg(m_titles.at(step)));
    draw();
}

void StepList::draw()
{
    QFont bold = textFont();
    bold.setBold(true);
    int widest = 0; // also of those to come, so that the page beside keeps its place
    for (int i = 0; i < m_labels.size(); ++i) {
        QFont font = textFont();
        font.setBold(i == m_current);
        widest = std::max(widest, QFontMetrics(bold).horizontalAdvance(m_titles.at(i)));
        m_labels[i]->setFont(font);
        m_labels[i]->setForegroundRole(i > m_current ? QPalette::PlaceholderText : QPalette::WindowText);
        const QSize size(grid::smallIcon, grid::smallIcon);
        if (i < m_current)
            m_icons[i]->setPixmap(lineIcon(Icon::ok, Role::running).pixmap(size, devicePixelRatioF()));
        else if (i == m_current)
            m_icons[i]->setPixmap(lineIcon(Icon::next).pixmap(size, devicePixelRatioF()));
        else
            m_icons[i]->clear();
    }
    static_cast<QGridLayout *>(layout())->setColumnMinimumWidth(1, widest);
}

} // namespace codewheel
