// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/word_view.h"

#include "widgets/look/appearance.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/on_event.h"

#include <QApplication>
#include <QHelpEvent>
#include <QPainter>
#include <QStatusTipEvent>
#include <QToolTip>

#include <algorithm>

namespace codewheel {

namespace {

int numberHeight()
{
    return QFontMetrics(numberFont(TextSize::small)).ascent() + 2;
}

constexpr Word maskOf(int bit)
{
    return Word{1} << bit;
}

} // namespace

WordView::WordView(const WordForm &form, std::vector<Line> lines, QWidget *parent)
    : QWidget(parent)
    , m_layout(form, static_cast<int>(lines.size()), 1, {})
    , m_focused{0, form.bits - 1}
{
    installPaintedPartsAccessibility(); // before assistive technology hears of it
    QStringList places;
    for (Line &line : lines) {
        places << line.place;
        m_words.push_back({.line = std::move(line)});
    }
    setAccessibleName(tr("%1 bits", "OUT 1.0, IN 1.0 bits").arg(places.join(QStringLiteral(", "))));
    setAutoFillBackground(true); // so that a changing bit does not repaint what is behind it
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    arrange();
    onEvent(this, {QEvent::Resize}, [this] { arrange(); });
    onEvent(this, {QEvent::Leave}, [this] { setHoveredBit({}); });
}

int WordView::captionWidth(const QStringList &captions)
{
    const QFontMetrics metrics(textFont(TextSize::small));
    int widest = 0;
    for (const QString &caption : captions)
        widest = std::max(widest, metrics.horizontalAdvance(caption));
    return widest + grid::unit;
}

QStringList WordView::captions() const
{
    QStringList captions;
    for (const Shown &shown : m_words)
        captions << shown.line.caption;
    return captions;
}

void WordView::setWord(int word, Word shown, Word onBus, Word edges, Instant now)
{
    Shown &its = at(word);
    const Word shownBefore = std::exchange(its.shown, shown);
    const Word stagedBefore = std::exchange(its.staged, shown ^ onBus);
    const Word markedBefore = its.marks.bits();
    its.marks.update(edges, now);
    updateCells(word,
                (shownBefore ^ its.shown) | (stagedBefore ^ its.staged) | (markedBefore ^ its.marks.bits()));
    if (hasFocus() && m_focused.word == word && ((shownBefore ^ its.shown) & maskOf(m_focused.bit)) != 0)
        announcePartState(*this, focusedPart());
}

bool WordView::isSet(WordBit bit) const
{
    return (at(bit.word).shown & maskOf(bit.bit)) != 0;
}

bool WordView::isStaged(WordBit bit) const
{
    return (at(bit.word).staged & maskOf(bit.bit)) != 0;
}

bool WordView::isMarked(WordBit bit) const
{
    return (at(bit.word).marks.bits() & maskOf(bit.bit)) != 0;
}

QString WordView::bitName(WordBit bit) const
{
    return tr("%1 bit %2", "OUT 1.0 bit 25").arg(at(bit.word).line.place).arg(bit.bit);
}

QString WordView::bitDescription(WordBit bit) const
{
    const auto &bitText = at(bit.word).line.bitText;
    if (!at(bit.word).isKnown)
        return tr("Not recorded");
    QString meaning = bitText ? bitText(bit.bit) : QString();
    if (!isStaged(bit))
        return meaning;
    return meaning.isEmpty() ? tr("Not sent yet") : tr("%1 (not sent yet)", "meaning of a bit").arg(meaning);
}

bool WordView::has(WordBit bit) const
{
    return bit.bit >= 0 && bit.bit < bits() && bit.word >= 0 && bit.word < words();
}

std::optional<int> WordView::partAt(QPoint point) const
{
    const auto bit = bitAt(point);
    return bit ? std::optional(partOf(*bit)) : std::nullopt;
}

void WordView::setFocusedBit(WordBit bit)
{
    if (!has(bit) || bit == m_focused)
        return;
    updateCell(std::exchange(m_focused, bit));
    updateCell(bit);
    if (hasFocus()) {
        announcePartFocus(*this, focusedPart());
        showStatusTip(bit);
    }
}

void WordView::toggleBit(WordBit bit)
{
    if (isEnabled() && has(bit) && isEditable(bit.word))
        Q_EMIT bitToggled(bit);
}

WordLayout WordView::layoutWith(int rows, bool isTight) const
{
    return {m_layout.form(),
            words(),
            rows,
            {.factor = controlFactor(*this),
             .isTight = isTight,
             .numberHeight = numberHeight(),
             .captionWidth = captionWidth(captions())}};
}

WordLayout WordView::layoutFor(int width) const
{
    if (m_matrix)
        return layoutWith(bits() / WordLayout::matrixBitsPerRow);
    const WordLayout oneRow = layoutWith(1);
    if (oneRow.size().width() <= width)
        return oneRow;
    const int rows = bits() == 16 ? 1 : 2;
    const WordLayout usual = layoutWith(rows);
    return usual.size().width() <= width ? usual : layoutWith(rows, true);
}

QSize WordView::sizeHint() const
{
    return layoutFor(QWIDGETSIZE_MAX).size();
}

QSize WordView::minimumSizeHint() const
{
    return {layoutFor(0).size().width(), sizeHint().height()};
}

void WordView::setMatrix(bool matrix)
{
    if (std::exchange(m_matrix, matrix) == matrix)
        return;
    arrange();
    updateGeometry();
}

// The width decides between one row and two, the style the size of the cells.
void WordView::arrange()
{
    m_layout = layoutFor(width());
    update();
}

bool WordView::event(QEvent *event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto *help = static_cast<QHelpEvent *>(event);
        return showToolTip(help->pos(), help->globalPos());
    }
    if (event->type() == QEvent::Polish) {
        arrange();
        updateGeometry();
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
        updateGeometry();
        break;
    case QEvent::EnabledChange:
        update();
        break;
    default:
        break;
    }
}

void WordView::setOld(int word, bool old)
{
    if (std::exchange(at(word).isOld, old) != old)
        updateCells(word, ~Word{0});
}

void WordView::setKnown(int word, bool known)
{
    if (std::exchange(at(word).isKnown, known) != known)
        updateCells(word, ~Word{0});
}

BitCell WordView::lookOf(WordBit bit) const
{
    return {.set = isSet(bit),
            .changed = isMarked(bit),
            .staged = isStaged(bit),
            .focused = hasFocus() && bit == m_focused,
            .hovered = isEditable(bit.word) && m_hovered == bit,
            .enabled = isEnabled() && !isOld(bit.word)};
}

void WordView::paintEvent(QPaintEvent *event)
{
    QPainter painter(this);
    painter.setPen(
        palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::WindowText));
    const QRegion &exposed = event->region();
    painter.setFont(textFont(TextSize::small));
    paintCaptions(painter, exposed);
    painter.setFont(numberFont(TextSize::small));
    for (int bit = 0; bit < bits(); ++bit) {
        if (const QRect number = m_layout.number(bit); exposed.intersects(number))
            painter.drawText(number, Qt::AlignHCenter | Qt::AlignTop, QString::number(bit));
        for (int word = 0; word < words(); ++word)
            if (const QRect cell = m_layout.cell({word, bit}); at(word).isKnown && exposed.intersects(cell))
                painter.drawPixmap(cell.topLeft(), m_pictures.picture(lookOf({word, bit}), cell.size(),
                                                                      devicePixelRatioF(), palette()));
    }
}

void WordView::paintCaptions(QPainter &painter, const QRegion &exposed) const
{
    for (int row = 0; row < m_layout.rows(); ++row)
        for (int word = 0; word < words(); ++word)
            if (const QRect caption = m_layout.caption(word, row); exposed.intersects(caption))
                painter.drawText(caption, Qt::AlignLeft | Qt::AlignVCenter, at(word).line.caption);
}

// Neighbouring cells together: the cost is per rectangle.
void WordView::updateCells(int word, Word bitMask)
{
    QRect together;
    for (int bit = 0; bit < bits(); ++bit) {
        if ((bitMask & maskOf(bit)) == 0)
            continue;
        const QRect cell = m_layout.cell({word, bit});
        const bool isNext = bit > 0 && (bitMask & maskOf(bit - 1)) != 0 && cell.top() == together.top();
        if (!isNext)
            update(together);
        together = isNext ? together.united(cell) : cell;
    }
    update(together);
}

void WordView::setHoveredBit(std::optional<WordBit> bit)
{
    const std::optional<WordBit> before = std::exchange(m_hovered, bit);
    if (before == bit)
        return;
    for (const std::optional<WordBit> &one : {before, bit})
        if (one)
            updateCell(*one);
    showStatusTip(bit);
}

void WordView::mouseMoveEvent(QMouseEvent *event)
{
    setHoveredBit(bitAt(event->position().toPoint()));
}

void WordView::mousePressEvent(QMouseEvent *event)
{
    const auto bit = bitAt(event->position().toPoint());
    m_pressed = event->button() == Qt::LeftButton ? bit : std::nullopt;
    if (bit)
        setFocusedBit(*bit);
}

void WordView::mouseReleaseEvent(QMouseEvent *event)
{
    const std::optional<WordBit> pressed = std::exchange(m_pressed, std::nullopt);
    if (pressed && event->button() == Qt::LeftButton && bitAt(event->position().toPoint()) == pressed)
        toggleBit(*pressed);
}

// So many lines of bits further down, counting words and rows; the same bit if there is no such line.
WordBit WordView::below(WordBit bit, int lines) const
{
    const int line = (bits() - 1 - bit.bit) / m_layout.bitsPerRow() * words() + bit.word + lines;
    if (line < 0 || line >= words() * m_layout.rows())
        return bit;
    const int inRow = bit.bit % m_layout.bitsPerRow();
    return {line % words(), bits() - (line / words() + 1) * m_layout.bitsPerRow() + inRow};
}

std::optional<WordBit> WordView::bitForKey(int key) const
{
    switch (key) {
    case Qt::Key_Left:
        return WordBit{m_focused.word, std::min(m_focused.bit + 1, bits() - 1)};
    case Qt::Key_Right:
        return WordBit{m_focused.word, std::max(m_focused.bit - 1, 0)};
    case Qt::Key_Up:
        return below(m_focused, -1);
    case Qt::Key_Down:
        return below(m_focused, 1);
    case Qt::Key_Home:
        return WordBit{m_focused.word, bits() - 1};
    case Qt::Key_End:
        return WordBit{m_focused.word, 0};
    default:
        return {};
    }
}

QList<KeyHelp> WordView::keys()
{
    return {{keyNames({Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down}), tr("To the next bit")},
            {keyNames({Qt::Key_Home, Qt::Key_End}), tr("To the highest or the lowest bit")},
            {keyNames({Qt::Key_Space}), tr("Toggles a bit of OUT")}};
}

void WordView::keyPressEvent(QKeyEvent *event)
{
    if (const auto bit = bitForKey(event->key()))
        setFocusedBit(*bit);
    else if (event->key() == Qt::Key_Space && isEditable(m_focused.word))
        toggleBit(m_focused);
    else
        QWidget::keyPressEvent(event);
}

void WordView::focusInEvent(QFocusEvent *event)
{
    QWidget::focusInEvent(event);
    updateCell(m_focused);
    announcePartFocus(*this, focusedPart());
    showStatusTip(m_focused);
}

void WordView::focusOutEvent(QFocusEvent *event)
{
    QWidget::focusOutEvent(event);
    updateCell(m_focused);
    showStatusTip({});
}

void WordView::showStatusTip(std::optional<WordBit> bit)
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
    const QString name = words() == 1 ? tr("Bit %1").arg(bit->bit)
                                      : tr("%1 bit %2").arg(at(bit->word).line.caption).arg(bit->bit);
    QToolTip::showText(globalPosition,
                       description.isEmpty() ? name : tr("%1: %2", "bit: meaning").arg(name, description),
                       this, m_layout.cell(*bit));
    return true;
}

} // namespace codewheel
