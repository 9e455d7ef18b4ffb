// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/word_view.h"

#include "widgets/look/appearance.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/monitor/word_view_accessible.h"

#include <QAbstractScrollArea>
#include <QApplication>
#include <QHelpEvent>
#include <QPainter>
#include <QStatusTipEvent>
#include <QToolTip>

#include <algorithm>

namespace codewheel {

namespace {

// A narrower window has no room for 32 bits beside its docks.
constexpr int oneRowWindowWidth = 1280;
constexpr int cardMargins = 8 * grid::unit; // beside the bits, in a column of monitors

int numberHeight()
{
    return QFontMetrics(numberFont(TextSize::small)).ascent() + 2;
}

constexpr Word maskOf(int bit)
{
    return Word{1} << bit;
}

// The column of a scroll area the view stands in; null: none.
QWidget *viewportAround(const QWidget &view)
{
    for (QWidget *above = view.parentWidget(); above != nullptr; above = above->parentWidget())
        if (const auto *area = qobject_cast<QAbstractScrollArea *>(above))
            return area->viewport();
    return nullptr;
}

} // namespace

WordView::WordView(const WordForm &form, QWidget *parent)
    : QWidget(parent)
    , m_layout(form, 1, 1.0, numberHeight())
    , m_focusedBit(form.bits - 1)
{
    installWordViewAccessibility();
    setAutoFillBackground(true); // so that a bit that changes does not paint what is behind it
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    arrange();
}

void WordView::setPlace(const QString &place)
{
    m_place = place;
    setAccessibleName(tr("%1 bits", "OUT 1.0 bits").arg(place));
}

void WordView::setEditable(bool editable)
{
    m_editable = editable;
    m_pressedBit.reset();
    updateCells(~Word{0});
}

void WordView::setBitText(std::function<QString(int)> text)
{
    m_bitText = std::move(text);
}

void WordView::setWord(Word shown, Word onBus, Word edges, Instant now)
{
    const Word shownBefore = std::exchange(m_shown, shown);
    const Word stagedBefore = std::exchange(m_staged, shown ^ onBus);
    const Word markedBefore = m_marks.bits();
    m_marks.update(edges, now);
    updateCells((shownBefore ^ m_shown) | (stagedBefore ^ m_staged) | (markedBefore ^ m_marks.bits()));
    if (hasFocus() && ((shownBefore ^ m_shown) & maskOf(m_focusedBit)) != 0)
        announceBitState(*this, m_focusedBit);
}

bool WordView::isSet(int bit) const
{
    return (m_shown & maskOf(bit)) != 0;
}

bool WordView::isStaged(int bit) const
{
    return (m_staged & maskOf(bit)) != 0;
}

bool WordView::isMarked(int bit) const
{
    return (m_marks.bits() & maskOf(bit)) != 0;
}

QString WordView::bitName(int bit) const
{
    return tr("%1 bit %2", "OUT 1.0 bit 25").arg(m_place).arg(bit);
}

QString WordView::bitDescription(int bit) const
{
    QString meaning = m_bitText ? m_bitText(bit) : QString();
    if (!isStaged(bit))
        return meaning;
    return meaning.isEmpty() ? tr("Not sent yet") : tr("%1 (not sent yet)", "meaning of a bit").arg(meaning);
}

void WordView::setFocusedBit(int bit)
{
    if (bit < 0 || bit >= bits() || bit == m_focusedBit)
        return;
    updateCells(maskOf(std::exchange(m_focusedBit, bit)) | maskOf(bit));
    if (hasFocus()) {
        announceBitFocus(*this, bit);
        showStatusTip(bit);
    }
}

void WordView::toggleBit(int bit)
{
    if (m_editable && isEnabled() && bit >= 0 && bit < bits())
        Q_EMIT bitToggled(bit);
}

QSize WordView::sizeHint() const
{
    return m_layout.size();
}

void WordView::setMatrix(bool matrix)
{
    if (std::exchange(m_matrix, matrix) != matrix)
        arrange();
}

int WordView::wantedRows() const
{
    if (m_matrix)
        return bits() / WordLayout::matrixBitsPerRow;
    const bool narrow = window()->width() < oneRowWindowWidth * controlFactor(*this);
    return bits() == 32 && (narrow || !fitsIntoOneRow()) ? 2 : 1;
}

// Panels beside the monitors take room that the width of the window does not tell of.
bool WordView::fitsIntoOneRow() const
{
    if (m_room == nullptr)
        return true;
    const int needed = WordLayout(m_layout.form(), 1, controlFactor(*this), numberHeight()).size().width();
    return needed + cardMargins <= m_room->width();
}

// The width of window and column decides on one row or two, the style on the size of the cells.
void WordView::arrange()
{
    m_layout = WordLayout(m_layout.form(), wantedRows(), controlFactor(*this), numberHeight());
    updateGeometry();
    update();
}

void WordView::watchWindow()
{
    QWidget *room = viewportAround(*this);
    if (m_window == window() && m_room == room)
        return;
    for (QWidget *watched : {m_window.data(), m_room.data()})
        if (watched != nullptr)
            watched->removeEventFilter(this);
    m_window = window();
    m_room = room;
    for (QWidget *watched : {m_window.data(), m_room.data()})
        if (watched != nullptr && watched != this)
            watched->installEventFilter(this);
    arrange();
}

bool WordView::eventFilter(QObject *watched, QEvent *event)
{
    if ((watched == m_window || watched == m_room) && event->type() == QEvent::Resize) {
        if (wantedRows() != m_layout.rows())
            arrange();
    }
    return QWidget::eventFilter(watched, event);
}

bool WordView::event(QEvent *event)
{
    switch (event->type()) {
    case QEvent::ParentChange:
    case QEvent::Show:
    case QEvent::Polish:
        watchWindow();
        break;
    case QEvent::ToolTip: {
        const auto *help = static_cast<QHelpEvent *>(event);
        return showToolTip(help->pos(), help->globalPos());
    }
    default:
        break;
    }
    return QWidget::event(event);
}

void WordView::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    switch (event->type()) {
    case QEvent::StyleChange:
    case QEvent::FontChange:
    case QEvent::PaletteChange:
        m_pictures.clear();
        arrange();
        break;
    case QEvent::EnabledChange:
        update();
        break;
    default:
        break;
    }
}

void WordView::setOld(bool old)
{
    if (std::exchange(m_old, old) != old)
        update();
}

BitCell WordView::lookOf(int bit) const
{
    return {.set = isSet(bit),
            .changed = isMarked(bit),
            .staged = isStaged(bit),
            .focused = hasFocus() && bit == m_focusedBit,
            .hovered = m_editable && m_hoveredBit == bit,
            .enabled = isEnabled() && !m_old};
}

void WordView::paintEvent(QPaintEvent *event)
{
    QPainter painter(this);
    painter.setFont(numberFont(TextSize::small));
    painter.setPen(
        palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::WindowText));
    const QRegion &exposed = event->region();
    for (int bit = 0; bit < bits(); ++bit) {
        const QRect cell = m_layout.cell(bit);
        if (exposed.intersects(cell))
            painter.drawPixmap(cell.topLeft(),
                               m_pictures.picture(lookOf(bit), cell.size(), devicePixelRatioF(), palette()));
        if (const QRect number = m_layout.number(bit); exposed.intersects(number))
            painter.drawText(number, Qt::AlignHCenter | Qt::AlignTop, QString::number(bit));
    }
}

// Neighbours together: each rectangle costs as much as its cells.
void WordView::updateCells(Word bitMask)
{
    QRect together;
    for (int bit = 0; bit < bits(); ++bit) {
        if ((bitMask & maskOf(bit)) == 0)
            continue;
        const QRect cell = m_layout.cell(bit);
        const bool isNext = bit > 0 && (bitMask & maskOf(bit - 1)) != 0 && cell.top() == together.top();
        if (!isNext)
            update(together);
        together = isNext ? together.united(cell) : cell;
    }
    update(together);
}

void WordView::setHoveredBit(std::optional<int> bit)
{
    const std::optional<int> before = std::exchange(m_hoveredBit, bit);
    if (before == bit)
        return;
    updateCells((before ? maskOf(*before) : 0) | (bit ? maskOf(*bit) : 0));
    showStatusTip(bit);
}

void WordView::mouseMoveEvent(QMouseEvent *event)
{
    setHoveredBit(bitAt(event->position().toPoint()));
}

void WordView::leaveEvent(QEvent *)
{
    setHoveredBit({});
}

void WordView::mousePressEvent(QMouseEvent *event)
{
    m_pressedBit = event->button() == Qt::LeftButton ? bitAt(event->position().toPoint()) : std::nullopt;
    if (m_pressedBit)
        setFocusedBit(*m_pressedBit);
}

void WordView::mouseReleaseEvent(QMouseEvent *event)
{
    const std::optional<int> pressed = std::exchange(m_pressedBit, std::nullopt);
    if (pressed && event->button() == Qt::LeftButton && bitAt(event->position().toPoint()) == pressed)
        toggleBit(*pressed);
}

std::optional<int> WordView::bitForKey(int key) const
{
    const int row = m_layout.bitsPerRow();
    switch (key) {
    case Qt::Key_Left:
        return std::min(m_focusedBit + 1, bits() - 1);
    case Qt::Key_Right:
        return std::max(m_focusedBit - 1, 0);
    case Qt::Key_Up:
        return m_focusedBit + row < bits() ? m_focusedBit + row : m_focusedBit;
    case Qt::Key_Down:
        return m_focusedBit - row >= 0 ? m_focusedBit - row : m_focusedBit;
    case Qt::Key_Home:
        return bits() - 1;
    case Qt::Key_End:
        return 0;
    default:
        return {};
    }
}

void WordView::keyPressEvent(QKeyEvent *event)
{
    if (const auto bit = bitForKey(event->key()))
        setFocusedBit(*bit);
    else if (event->key() == Qt::Key_Space && m_editable)
        toggleBit(m_focusedBit);
    else
        QWidget::keyPressEvent(event);
}

void WordView::focusInEvent(QFocusEvent *event)
{
    QWidget::focusInEvent(event);
    updateCells(maskOf(m_focusedBit));
    announceBitFocus(*this, m_focusedBit);
    showStatusTip(m_focusedBit);
}

void WordView::focusOutEvent(QFocusEvent *event)
{
    QWidget::focusOutEvent(event);
    updateCells(maskOf(m_focusedBit));
    showStatusTip({});
}

void WordView::showStatusTip(std::optional<int> bit)
{
    QString tip;
    if (bit) {
        const QString description = bitDescription(*bit);
        tip = description.isEmpty() ? bitName(*bit)
                                    : tr("%1: %2", "bit: meaning").arg(bitName(*bit), description);
    }
    QStatusTipEvent event(tip);
    QApplication::sendEvent(this, &event);
}

bool WordView::showToolTip(QPoint position, QPoint globalPosition)
{
    const auto bit = bitAt(position);
    if (!bit) {
        QToolTip::hideText();
        return true;
    }
    const QString description = bitDescription(*bit);
    const QString name = tr("Bit %1").arg(*bit);
    QToolTip::showText(globalPosition,
                       description.isEmpty() ? name : tr("%1: %2", "bit: meaning").arg(name, description),
                       this, m_layout.cell(*bit));
    return true;
}

} // namespace codewheel
