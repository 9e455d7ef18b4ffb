// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/trend/trend_chart.h"

#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/on_event.h"
#include "widgets/trend/lane_layout.h"
#include "widgets/trend/ticks.h"
#include "widgets/trend/track_text.h"
#include "widgets/trend/trend_item.h"

#include <QApplication>
#include <QCategoryAxis>
#include <QChart>
#include <QGraphicsLayout>
#include <QHelpEvent>
#include <QLineSeries>
#include <QMouseEvent>
#include <QRubberBand>
#include <QToolTip>
#include <QWheelEvent>

#include <cmath>

namespace codewheel {
namespace {

// Qt Charts has its grid and its axes at 2 and 3.
constexpr double aboveGrid = 10;
constexpr int nearCursor = 5;       // pixels within which it is taken
constexpr double wheelZoom = 1.25;  // per notch
constexpr double notch = 120;       // of a wheel
constexpr double wheelScroll = 0.1; // lengths per notch
constexpr double keyScroll = 0.1;   // lengths
constexpr double keyZoom = 1.5;
constexpr int flatBox = 16;        // pixels: a box no higher is of the time alone
constexpr int labelWidth = 96;     // of a time, with its distance to the next
constexpr double labelHeight = 26; // of a value, with its distance to the next

// The labels of a category axis must differ; these do so invisibly.
void putLabels(QCategoryAxis &axis, const std::vector<Tick> &ticks)
{
    for (const QString &label : axis.categoriesLabels())
        axis.remove(label);
    axis.setStartValue(-1);
    QString difference;
    for (const Tick &tick : ticks) {
        axis.append(tick.text + difference, tick.at);
        difference += QChar(0x200B);
    }
}

std::vector<Tick> laneTicks(const TrendLane &lane, int most, const QLocale &locale)
{
    return bitCount(lane.curves.front().track.channel) == 0 ? valueTicks(lane.low, lane.high, most, locale)
                                                            : hexTicks(lane.low, lane.high, most);
}

} // namespace

TrendChart::TrendChart(QWidget *parent)
    : QChartView(new QChart, parent)
    , m_time(new QCategoryAxis)
    , m_values(new QCategoryAxis)
    , m_item(new TrendItem(chart()))
    , m_box(new QRubberBand(QRubberBand::Rectangle, viewport()))
{
    setFocusPolicy(Qt::StrongFocus);
    setFrameShape(QFrame::NoFrame);
    setAcceptDrops(false); // they are for the page
    viewport()->setAcceptDrops(false);
    setMouseTracking(true);
    viewport()->setMouseTracking(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    chart()->setAnimationOptions(QChart::NoAnimation);
    chart()->setBackgroundRoundness(0);
    chart()->setMargins(QMargins(0, 4 * grid::unit, 6 * grid::unit, 0));
    chart()->layout()->setContentsMargins(0, 0, 0, 0);
    chart()->legend()->hide();
    auto *none = new QLineSeries(this); // axes need one
    chart()->addSeries(none);
    for (const auto &[axis, where] :
         {std::pair(m_time, Qt::AlignBottom), std::pair(m_values, Qt::AlignLeft)}) {
        axis->setLabelsPosition(QCategoryAxis::AxisLabelsPositionOnValue);
        axis->setRange(0, 1);
        axis->setTruncateLabels(false);
        chart()->addAxis(axis, where);
        none->attachAxis(axis);
    }
    m_item->setZValue(aboveGrid);
    useColors();
    connect(chart(), &QChart::plotAreaChanged, this, &TrendChart::showItem);
    onEvent(this, {QEvent::PaletteChange, QEvent::FontChange}, [this] {
        useColors();
        showItem();
    });
}

QSize TrendChart::sizeHint() const
{
    return {640, 320};
}

void TrendChart::resizeForPaper(QSize size)
{
    resize(size);
    chart()->resize(size);
    setSceneRect(QRectF(QPointF(), size));
}

QRectF TrendChart::plot() const
{
    return chart()->plotArea();
}

const std::vector<QRectF> &TrendChart::lanes() const
{
    return m_item->lanes();
}

Instant TrendChart::resolution() const
{
    return std::max((m_shown.span.to - m_shown.span.from) / std::max(static_cast<int>(plot().width()), 1),
                    Instant(1));
}

void TrendChart::useColors()
{
    chart()->setBackgroundBrush(palette().color(QPalette::Base));
    for (QAbstractAxis *axis :
         {static_cast<QAbstractAxis *>(m_time), static_cast<QAbstractAxis *>(m_values)}) {
        axis->setLabelsColor(palette().color(QPalette::Text));
        axis->setLinePenColor(palette().color(QPalette::Dark));
        axis->setGridLineColor(palette().color(QPalette::Midlight));
        axis->setLabelsFont(textFont(TextSize::small));
        axis->setTitleFont(textFont(TextSize::small));
        axis->setTitleBrush(palette().color(QPalette::Text));
    }
}

void TrendChart::showScene(const TrendScene &scene)
{
    m_shown = scene;
    showAxes();
    showItem();
}

// Labels are laid out only where they differ: that costs more than the curves.
void TrendChart::showAxes()
{
    const int most = std::max(static_cast<int>(plot().width()) / labelWidth, 2);
    const std::vector<Tick> times = timeTicks(m_shown.span, most, m_locale);
    const auto areas = layOutLanes(m_shown.lanes, plot());
    std::vector<Tick> values;
    for (std::size_t index = m_shown.lanes.size(); index-- > 0;) {
        const TrendLane &lane = m_shown.lanes[index];
        if (lane.isLogic())
            continue;
        const QRectF &area = areas[index];
        const int labels = std::max(static_cast<int>(area.height() / labelHeight), 2);
        for (const Tick &tick : laneTicks(lane, labels, m_locale)) {
            const double y = area.bottom() - tick.at * area.height();
            values.push_back({(plot().bottom() - y) / std::max(plot().height(), 1.0), tick.text});
        }
    }
    const QString day = spanDayText(m_shown.span, m_locale);
    QString ticks = day;
    for (const std::vector<Tick> *axis : {&times, static_cast<const std::vector<Tick> *>(&values)})
        for (const Tick &tick : *axis)
            ticks += QStringLiteral("|%1 %2").arg(tick.at, 0, 'f', 6).arg(tick.text);
    if (std::exchange(m_shownTicks, ticks) == ticks)
        return;
    putLabels(*m_time, times);
    putLabels(*m_values, values);
    if (m_time->titleText() != day)
        m_time->setTitleText(day);
}

void TrendChart::showItem()
{
    m_item->show(m_shown, plot(), palette());
}

// With Shift it scrolls.
void TrendChart::wheelEvent(QWheelEvent *event)
{
    const QPoint delta = event->angleDelta();
    const double turned = (delta.y() != 0 ? delta.y() : delta.x()) / notch;
    if ((event->modifiers() & Qt::ShiftModifier) != 0 || delta.y() == 0)
        Q_EMIT scrollWanted(-turned * wheelScroll);
    else
        Q_EMIT zoomWanted(
            std::pow(wheelZoom, -turned),
            std::clamp((event->position().x() - plot().left()) / std::max(plot().width(), 1.0), 0.0, 1.0));
    event->accept();
}

std::optional<std::size_t> TrendChart::cursorAt(double x) const
{
    for (std::size_t index = 0; index < m_shown.cursors.size(); ++index)
        if (m_shown.cursors[index] && std::abs(m_item->x(*m_shown.cursors[index]) - x) <= nearCursor)
            return index;
    return {};
}

void TrendChart::mousePressEvent(QMouseEvent *event)
{
    m_pressedAt = event->position().toPoint();
    m_spanBefore = m_shown.span;
    m_drag = Drag::none;
    const bool isLeft = event->button() == Qt::LeftButton;
    if (event->button() == Qt::MiddleButton || (isLeft && (event->modifiers() & Qt::ControlModifier) != 0)) {
        m_drag = Drag::time;
        viewport()->setCursor(Qt::ClosedHandCursor);
    } else if (const auto cursor = cursorAt(m_pressedAt.x()); isLeft && cursor) {
        m_drag = Drag::cursor;
        Q_EMIT cursorWanted(*cursor, *m_shown.cursors[*cursor]);
    } else if (isLeft) {
        m_drag = Drag::pressed;
    }
    event->accept();
}

void TrendChart::mouseMoveEvent(QMouseEvent *event)
{
    const QPoint at = event->position().toPoint();
    if (m_drag == Drag::pressed && (at - m_pressedAt).manhattanLength() >= QApplication::startDragDistance())
        m_drag = Drag::box;
    switch (m_drag) {
    case Drag::none:
        viewport()->setCursor(cursorAt(at.x()) ? Qt::SplitHCursor : Qt::CrossCursor);
        break;
    case Drag::pressed:
        break;
    case Drag::box: {
        QRect box = QRect(m_pressedAt, at).normalized();
        if (box.height() < flatBox)
            box = {box.left(), static_cast<int>(plot().top()), box.width(),
                   static_cast<int>(plot().height())};
        m_box->setGeometry(box.intersected(plot().toAlignedRect()));
        m_box->show();
        break;
    }
    case Drag::time: {
        const double moved = (m_pressedAt.x() - at.x()) / std::max(plot().width(), 1.0);
        const Instant by(
            std::llround(moved * static_cast<double>((m_spanBefore.to - m_spanBefore.from).count())));
        Q_EMIT spanWanted({m_spanBefore.from + by, m_spanBefore.to + by});
        break;
    }
    case Drag::cursor:
        Q_EMIT cursorWanted(m_shown.chosenCursor, m_item->timeAt(at.x()));
        break;
    }
    event->accept();
}

// A click places the first cursor, with Shift the second one.
void TrendChart::mouseReleaseEvent(QMouseEvent *event)
{
    const Drag ended = std::exchange(m_drag, Drag::none);
    if (ended == Drag::box) {
        const QRectF box = m_box->geometry();
        m_box->hide();
        zoomTo(box);
    } else if (ended == Drag::pressed && plot().contains(event->position())) {
        Q_EMIT cursorWanted((event->modifiers() & Qt::ShiftModifier) != 0 ? 1 : 0,
                            m_item->timeAt(event->position().x()));
    } else if (ended == Drag::time) {
        viewport()->setCursor(Qt::CrossCursor);
    }
    event->accept();
}

// A box within one lane also zooms its axis.
void TrendChart::zoomTo(const QRectF &box)
{
    if (box.width() < 2)
        return;
    const auto lane = laneAt(lanes(), box.top());
    if (box.height() < plot().height() && lane && lane == laneAt(lanes(), box.bottom()) &&
        lane < m_shown.lanes.size() && !m_shown.lanes[*lane].isLogic()) {
        const TrendLane &its = m_shown.lanes[*lane];
        const QRectF area = lanes()[*lane];
        const auto value = [&](double y) {
            return its.low + (area.bottom() - std::clamp(y, area.top(), area.bottom())) *
                                 (its.high - its.low) / area.height();
        };
        Q_EMIT axisWanted(*lane, value(box.bottom()), value(box.top()));
    }
    Q_EMIT spanWanted({m_item->timeAt(box.left()), m_item->timeAt(box.right())});
}

void TrendChart::moveCursor(int pixels)
{
    const auto cursor = m_shown.cursors[m_shown.chosenCursor];
    const Instant middle = m_shown.span.from + (m_shown.span.to - m_shown.span.from) / 2;
    Q_EMIT cursorWanted(m_shown.chosenCursor, cursor ? *cursor + resolution() * pixels : middle);
}

QList<KeyHelp> TrendChart::keys()
{
    return {
        {keyNames({Qt::Key_Left, Qt::Key_Right}), tr("Scrolls to earlier or later times")},
        {keyNames({Qt::Key_Plus, Qt::Key_Minus}), tr("Zooms in or out")},
        {keyNames({Qt::Key_A, Qt::Key_B}), tr("Chooses the cursor that keys move")},
        {keyNames({Qt::CTRL | Qt::Key_Left, Qt::CTRL | Qt::Key_Right}), tr("Moves the cursor by a pixel")},
        {keyNames({Qt::CTRL | Qt::SHIFT | Qt::Key_Left, Qt::CTRL | Qt::SHIFT | Qt::Key_Right}),
         tr("Moves the cursor by ten pixels")},
        {keyNames({Qt::Key_Escape}), tr("Ends a drag without an effect")}};
}

void TrendChart::keyPressEvent(QKeyEvent *event)
{
    const bool isCursor = (event->modifiers() & Qt::ControlModifier) != 0;
    const int pixels = (event->modifiers() & Qt::ShiftModifier) != 0 ? 10 : 1;
    const Instant middle = m_shown.span.from + (m_shown.span.to - m_shown.span.from) / 2;
    switch (event->key()) {
    case Qt::Key_Left:
        isCursor ? moveCursor(-pixels) : Q_EMIT scrollWanted(-keyScroll);
        break;
    case Qt::Key_Right:
        isCursor ? moveCursor(pixels) : Q_EMIT scrollWanted(keyScroll);
        break;
    case Qt::Key_Plus:
        Q_EMIT zoomWanted(1 / keyZoom, 0.5);
        break;
    case Qt::Key_Minus:
        Q_EMIT zoomWanted(keyZoom, 0.5);
        break;
    case Qt::Key_A:
        Q_EMIT cursorWanted(0, m_shown.cursors[0].value_or(middle));
        break;
    case Qt::Key_B:
        Q_EMIT cursorWanted(1, m_shown.cursors[1].value_or(middle));
        break;
    case Qt::Key_Escape:
        if (m_drag == Drag::none) {
            event->ignore(); // closes the page
            return;
        }
        m_box->hide();
        m_drag = Drag::none;
        break;
    default:
        QChartView::keyPressEvent(event);
        return;
    }
    event->accept();
}

bool TrendChart::viewportEvent(QEvent *event)
{
    if (event->type() != QEvent::ToolTip)
        return QChartView::viewportEvent(event);
    const auto *help = static_cast<QHelpEvent *>(event);
    showToolTip(help->pos(), help->globalPos());
    return true;
}

// Of the marks here, or else the time.
void TrendChart::showToolTip(const QPoint &position, const QPoint &globalPosition)
{
    if (!plot().adjusted(0, -2 * nearCursor, 0, 0).contains(position)) {
        QToolTip::hideText();
        return;
    }
    const Instant length = m_shown.span.to - m_shown.span.from;
    QStringList lines;
    for (const Mark &mark : m_shown.marks)
        if (std::abs(m_item->x(mark.at) - position.x()) <= nearCursor)
            lines << QStringLiteral("%1  %2").arg(timeText(mark.at, length, m_locale), markText(mark));
    if (lines.isEmpty())
        lines << timeText(m_item->timeAt(position.x()), length, m_locale);
    QToolTip::showText(globalPosition, lines.join(u'\n'), viewport());
}

} // namespace codewheel
