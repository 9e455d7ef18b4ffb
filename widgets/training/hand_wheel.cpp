// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/training/hand_wheel.h"

#include "vocabulary/circle.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"

#include <QDial>
#include <QGridLayout>
#include <QSignalBlocker>
#include <QToolButton>
#include <QWheelEvent>

#include <cmath>

namespace codewheel {

namespace {

constexpr int wheelSide = 54;

// Has the focus once it was dragged; a mouse wheel that comes by scrolls the panel all the same.
class DraggedDial : public QDial
{
public:
    using QDial::QDial;

protected:
    void wheelEvent(QWheelEvent *event) override { event->ignore(); }
};

} // namespace

HandWheel::HandWheel(QWidget *parent)
    : QWidget(parent)
    , m_wheel(describe(new DraggedDial(this), tr("Wheel"),
                       tr("Turn the shaft by hand: drag, or use the arrow keys and Page Up, Page Down")))
{
    m_wheel->setRange(0, places);
    m_wheel->setWrapping(true);
    m_wheel->setPageStep(places / 8);
    m_wheel->setFixedSize(wheelSide, wheelSide);
    connect(m_wheel, &QDial::valueChanged, this, &HandWheel::turnWheel);

    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(grid::unit / 2);
    grid->setVerticalSpacing(grid::unit);
    grid->addWidget(m_wheel, 0, 0, 3, 1);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(2, 1);
    const QString minus(QChar(0x2212));
    const QString quarter = QChar(0x00BC) + QLatin1Char(' ') + tr("turn");
    const QString whole = QStringLiteral("1 ") + tr("turn");
    addButton(grid, 0, {0, -1, minus + QLatin1Char('1'), tr("1 step counter-clockwise")});
    addButton(grid, 0, {0, 1, QStringLiteral("+1"), tr("1 step clockwise")});
    addButton(grid, 1, {4, -1, minus + quarter, tr("A quarter turn counter-clockwise")});
    addButton(grid, 1, {4, 1, QLatin1Char('+') + quarter, tr("A quarter turn clockwise")});
    addButton(grid, 2, {1, -1, minus + whole, tr("1 turn counter-clockwise")});
    addButton(grid, 2, {1, 1, QLatin1Char('+') + whole, tr("1 turn clockwise")});
}

void HandWheel::addButton(QGridLayout *grid, int row, const Turn &turn)
{
    auto *button = describe(new QToolButton(this), turn.name, turn.name);
    button->setText(turn.text);
    button->setAutoRepeat(true);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    button->setMinimumWidth(button->fontMetrics().horizontalAdvance(turn.text) + grid::margin);
    grid->addWidget(button, row, turn.sense < 0 ? 1 : 2);
    connect(button, &QToolButton::clicked, this, [this, part = turn.part, sense = turn.sense] {
        Q_EMIT turned(part == 0 ? sense : sense * (m_stepsPerTurn / part));
    });
}

void HandWheel::setStepsPerTurn(int steps)
{
    m_stepsPerTurn = steps;
}

void HandWheel::showRaw(std::int64_t raw)
{
    if (m_wheel->isSliderDown())
        return;
    const std::int64_t inTurn = raw % m_stepsPerTurn;
    const int place = static_cast<int>(inTurn * places / m_stepsPerTurn);
    m_place = (place + places / 2) % places; // a wrapping dial has its 0 at the bottom
    const QSignalBlocker silent(m_wheel);
    m_wheel->setValue(m_place);
}

// The wheel is taken to have turned the shorter way.
void HandWheel::turnWheel(int place)
{
    const std::int64_t moved = shorterWay(m_place % places, place % places, places);
    m_place = place;
    if (moved != 0)
        Q_EMIT turned(std::llround(static_cast<double>(moved) * m_stepsPerTurn / places));
}

} // namespace codewheel
