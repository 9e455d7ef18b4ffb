// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/bar_view.h"

#include "widgets/look/grid.h"
#include "widgets/look/roles.h"

#include <QLocale>
#include <QPainter>

#include <algorithm>

namespace codewheel {

namespace {

constexpr int barHeight = 2 * grid::unit;
constexpr int barTick = 3;

} // namespace

BarView::BarView(QWidget *parent)
    : ValueWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void BarView::setPlace(const QString &place)
{
    setAccessibleName(tr("%1 bar", "IN 1.0 bar").arg(place));
}

void BarView::setRange(qint64 first, qint64 last)
{
    m_first = first;
    m_last = std::max(last, first + 1);
    update();
}

void BarView::setValue(std::optional<qint64> value, bool isOld)
{
    const bool isOther = std::exchange(m_isOld, isOld) != isOld;
    const std::optional<int> before = filledWidth();
    m_value = value;
    if (isOther || filledWidth() != before)
        update();
}

std::optional<int> BarView::filledWidth() const
{
    if (!m_value)
        return {};
    const double share = static_cast<double>(std::clamp(*m_value, m_first, m_last) - m_first) /
                         static_cast<double>(m_last - m_first);
    return qRound(share * (width() - 2));
}

QString BarView::valueText() const
{
    if (!m_value)
        return tr("Not known");
    const QString text =
        tr("%1 of %2 to %3", "value, range")
            .arg(locale().toString(*m_value), locale().toString(m_first), locale().toString(m_last));
    return m_isOld ? tr("%1, not up to date", "value of range").arg(text) : text;
}

QSize BarView::sizeHint() const
{
    return {50 * grid::unit, barHeight + barTick + 1};
}

QSize BarView::minimumSizeHint() const
{
    return {20 * grid::unit, sizeHint().height()};
}

void BarView::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const QColor rim = roleColor(Role::inactive, palette());
    const QRect bar(0, 0, width(), barHeight);
    painter.fillRect(bar, rim);
    painter.fillRect(bar.adjusted(1, 1, -1, -1), palette().color(QPalette::Base));
    if (const auto filled = filledWidth()) {
        if (!m_isOld)
            painter.fillRect(QRect(1, 1, *filled, barHeight - 2), rim);
        painter.fillRect(QRect(std::max(0, *filled - 1), 0, 3, barHeight),
                         m_isOld ? rim : palette().color(QPalette::WindowText));
    }
    painter.setPen(rim);
    for (int quarter = 0; quarter <= 4; ++quarter) {
        const int x = quarter * (width() - 1) / 4;
        painter.drawLine(x, barHeight + 1, x, barHeight + barTick);
    }
}

} // namespace codewheel
