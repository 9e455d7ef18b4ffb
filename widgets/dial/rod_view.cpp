// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dial/rod_view.h"

#include "widgets/dial/dial_note.h"
#include "widgets/dial/resolution.h"
#include "widgets/dial/then_mark.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"

#include <QEvent>
#include <QLocale>
#include <QPainter>
#include <QPaintEvent>

#include <algorithm>
#include <cmath>

namespace codewheel {

namespace {

constexpr int smallestWidth = 160;

int largeLine()
{
    return QFontMetrics(numberFont(TextSize::large)).height();
}

} // namespace

RodView::RodView(QWidget *parent)
    : ValueWidget(parent)
{
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    setAccessibleName(tr("Rod"));
}

void RodView::setPlace(const QString &place)
{
    setAccessibleName(tr("Rod of %1", "device number").arg(place));
}

void RodView::setState(const RodState &state)
{
    const RodState before = std::exchange(m_state, state);
    if (before == state)
        return;
    if (before.note != state.note || before.then.has_value() != state.then.has_value()) {
        arrange();
        updateGeometry();
        update();
        return;
    }
    update(QRegion(m_picture.space()) + m_number + m_millimetres + m_speed + m_resolution);
}

QSize RodView::sizeHint() const
{
    return {RodPicture::usualWidth, RodPicture::height() + textHeight(2)};
}

QSize RodView::minimumSizeHint() const
{
    return {smallestWidth,
            m_state.then ? RodPicture::height() + textHeight(linesOfNote()) : sizeHint().height()};
}

// The texts below the rod: position, millimetres, speed, resolution, the note.
int RodView::textHeight(int noteLines) const
{
    if (m_state.then)
        return (2 + noteLines) * fontMetrics().height() + 3 * grid::unit;
    return largeLine() + (3 + noteLines) * fontMetrics().height() + 3 * grid::unit;
}

// Beside a question nobody waits for a note.
int RodView::linesOfNote() const
{
    return m_state.then && note().isEmpty() ? 0 : dial_note::lines(fontMetrics(), width(), note());
}

void RodView::arrange()
{
    const int line = fontMetrics().height();
    const int noteLines = linesOfNote();
    const int above = std::max(0, (height() - RodPicture::height() - textHeight(noteLines)) / 2);
    m_picture.setSpace(QRect(0, above, width(), RodPicture::height()));
    m_number =
        QRect(0, m_picture.space().bottom() + 1 + grid::unit, width(), m_state.then ? line : largeLine());
    m_millimetres = QRect(0, m_number.bottom() + 1, width(), line);
    m_speed = m_millimetres.translated(0, line);
    m_resolution = m_speed.translated(0, line);
    const QRect &last = m_state.then ? m_millimetres : m_resolution;
    m_note = QRect(0, last.bottom() + 1 + grid::unit, width(), noteLines * line + grid::unit);
}

void RodView::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    arrange();
    if (m_state.then && event->size().width() != event->oldSize().width())
        updateGeometry(); // its note wraps at other places
}

void RodView::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        arrange();
    update();
}

void RodView::paintEvent(QPaintEvent *event)
{
    QPainter painter(this);
    if (event->region().intersects(m_picture.space()))
        m_picture.paint(painter, palette(), m_state);
    drawNumbers(painter);
    if (event->region().intersects(m_note))
        dial_note::paint(painter, *this, m_note, m_state.role, note());
}

void RodView::drawNumbers(QPainter &painter) const
{
    if (m_state.then)
        drawNowAndThen(painter);
    else
        drawNumbersOfNow(painter);
}

void RodView::drawNumbersOfNow(QPainter &painter) const
{
    painter.setPen(palette().color(m_state.isLastKnown ? QPalette::PlaceholderText : QPalette::WindowText));
    painter.setFont(numberFont(TextSize::large));
    painter.drawText(m_number, Qt::AlignCenter, m_state.position ? shownPosition() : QString(QChar(0x2013)));
    painter.setFont(numberFont());
    painter.drawText(m_millimetres, Qt::AlignCenter, m_state.position ? millimetreText() : QString());
    painter.drawText(m_speed, Qt::AlignCenter, m_state.age.isEmpty() ? speedText() : m_state.age);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.setFont(font());
    painter.drawText(m_resolution, Qt::AlignCenter, resolutionText());
}

void RodView::drawNowAndThen(QPainter &painter) const
{
    const QColor now = roleColor(m_state.isLastKnown ? Role::inactive : m_state.role, palette());
    then_mark::paintLegend(
        painter, palette(), numberFont(),
        {m_number, then_mark::nowText(inBoth(m_state.position, m_state.scale), m_state.age), now});
    then_mark::paintLegend(painter, palette(), numberFont(), {m_millimetres, thenText(), {}});
}

// "12 500 (125.0 mm)"
QString RodView::inBoth(std::optional<qint64> position, const std::optional<RodScale> &scale) const
{
    if (!position)
        return {};
    const QString steps = locale().toString(*position);
    return scale ? QStringLiteral("%1 (%2)").arg(steps, scale->text(*position)) : steps;
}

QString RodView::thenText() const
{
    return then_mark::thenText(inBoth(m_state.then->position, m_state.then->scale));
}

QString RodView::positionText() const
{
    return tr("%1 steps").arg(locale().toString(*m_state.position));
}

// Without the unit where the view is narrow.
QString RodView::shownPosition() const
{
    const QString text = positionText();
    const bool fits = QFontMetrics(numberFont(TextSize::large)).horizontalAdvance(text) <= width();
    return fits ? text : locale().toString(*m_state.position);
}

QString RodView::millimetreText() const
{
    return m_state.scale ? m_state.scale->text(*m_state.position) : tr("mm not known");
}

QString RodView::speedText() const
{
    if (!m_state.stepsPerSecond)
        return {};
    const double speed = *m_state.stepsPerSecond * (m_state.scale ? m_state.scale->millimetres(1) : 1);
    const QString number = locale().toString(std::abs(speed), 'f', 1);
    QString text = m_state.scale ? tr("%1 mm/s").arg(number) : tr("%1 steps/s").arg(number);
    if (std::abs(speed) < 0.05 || !m_state.countsUpToTheEnd)
        return text;
    return (speed > 0) == *m_state.countsUpToTheEnd ? tr("%1 to the end", "of the rod").arg(text)
                                                    : tr("%1 to the head", "of the rod").arg(text);
}

QString RodView::resolutionText() const
{
    return m_state.scale ? resolution(m_state.scale->millimetres(1)) : QString();
}

QString RodView::note() const
{
    if (m_state.note.isEmpty() && !m_state.position)
        return tr("No position yet. Start the bus and choose an encoder in the bus structure.");
    return m_state.note;
}

std::vector<std::pair<QString, QString>> RodView::values() const
{
    std::vector<std::pair<QString, QString>> values;
    const auto add = [&values](const QString &name, const QString &value) {
        if (!value.isEmpty())
            values.emplace_back(name, value);
    };
    if (m_state.position) {
        add(m_state.isLastKnown ? tr("Last position") : tr("Position"), positionText());
        add(tr("From the head"), m_state.scale ? millimetreText() : QString());
    }
    add(tr("Speed"), speedText());
    add(tr("Age"), m_state.age);
    add(tr("Resolution"), resolutionText());
    add(tr("Note"), note());
    return values;
}

QString RodView::valueText() const
{
    QStringList parts;
    if (m_state.position) {
        parts.append(m_state.isLastKnown ? tr("Last position %1").arg(positionText())
                                         : tr("Position %1").arg(positionText()));
        parts.append(millimetreText());
    }
    if (m_state.then)
        parts.append(thenText());
    if (m_state.length)
        parts.append(tr("measuring length %1 steps").arg(locale().toString(*m_state.length)));
    for (const QString &text : {speedText(), m_state.age, resolutionText(), note()})
        if (!text.isEmpty())
            parts.append(text);
    return parts.join(QStringLiteral(", "));
}

} // namespace codewheel
