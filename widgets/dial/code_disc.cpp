// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dial/code_disc.h"

#include "widgets/dial/dial_note.h"
#include "widgets/dial/then_mark.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"

#include <QEvent>
#include <QLocale>
#include <QPainter>
#include <QPaintEvent>

#include <algorithm>
#include <array>
#include <cmath>

namespace codewheel {

namespace {

constexpr int arcWidth = 4;
constexpr int scaleWidth = 10;  // between arc and disc
constexpr double arcHalf = 150; // degrees to each side of the top
constexpr int usualSide = 232;  // of the dial
constexpr int smallestSide = 144;
constexpr int smallestWithThen = 64; // it stands among other things
constexpr int largestSide = 320;     // anything larger costs more and shows no more
constexpr int pointerPlaces = 2880;  // of a turn: anything finer cannot be seen

int heightOf(const QFont &font)
{
    return QFontMetrics(font).height();
}

// The part of a turn that can be seen.
std::optional<int> placeOf(const std::optional<double> &turnFraction)
{
    if (!turnFraction)
        return {};
    return qRound(*turnFraction * pointerPlaces) % pointerPlaces;
}

double arcDegrees(double rpm)
{
    const double share = std::log10(1 + std::abs(rpm)) / std::log10(1 + CodeDisc::fullSpeed);
    return std::copysign(std::min(share, 1.0) * arcHalf, rpm);
}

// The part of a speed that can be seen: whole degrees.
std::optional<int> arcOf(const std::optional<double> &rpm)
{
    return rpm ? std::optional(qRound(arcDegrees(*rpm))) : std::nullopt;
}

// At this speed nobody sees the edges move from frame to frame.
bool isBlur(const DialState &state)
{
    constexpr double slowest = 20; // rpm: 4 degrees a frame
    return std::abs(state.rpm.value_or(0)) > slowest;
}

} // namespace

CodeDisc::CodeDisc(QWidget *parent)
    : ValueWidget(parent)
{
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    setSizePolicy(policy);
    setAccessibleName(tr("Dial"));
}

void CodeDisc::setPlace(const QString &place)
{
    setAccessibleName(tr("Dial of %1", "device number").arg(place));
}

void CodeDisc::setState(const DialState &state)
{
    const DialState before = std::exchange(m_state, state);
    if (before.note != state.note || before.position.has_value() != state.position.has_value() ||
        before.role != state.role || before.isLastKnown != state.isLastKnown ||
        before.turnFraction.has_value() != state.turnFraction.has_value() ||
        before.then.has_value() != state.then.has_value()) {
        arrange();
        updateGeometry();
        update();
        return;
    }
    const bool isStillOther = arcOf(before.rpm) != arcOf(state.rpm) || before.turn != state.turn;
    if (isStillOther)
        m_still = {};
    if (before.then != state.then || before.age != state.age)
        update(m_dial | m_number | m_speed);
    if (isStillOther || placeOf(before.turnFraction) != placeOf(state.turnFraction) ||
        isBlur(before) != isBlur(state))
        update(m_dial);
    if (before.position != state.position || before.velocity != state.velocity)
        update(m_number);
    if (speedText(before) != speedText(state))
        update(m_speed);
}

QSize CodeDisc::sizeHint() const
{
    return {usualSide, usualSide + textHeight(2)};
}

QSize CodeDisc::minimumSizeHint() const
{
    if (!m_state.then)
        return {smallestSide, smallestSide + textHeight(2)};
    return {smallestSide, (m_state.turnFraction ? smallestWithThen : 0) + textHeight(linesOfNote())};
}

// The texts below the dial: position, speed, the note.
int CodeDisc::textHeight(int noteLines) const
{
    const int number = heightOf(m_state.then ? numberFont() : numberFont(TextSize::large));
    return number + (1 + noteLines) * heightOf(font()) + 3 * grid::unit;
}

// Beside a question nobody waits for a note.
int CodeDisc::linesOfNote() const
{
    return m_state.then && note().isEmpty() ? 0 : dial_note::lines(fontMetrics(), width(), note());
}

void CodeDisc::arrange()
{
    const int line = heightOf(font());
    const int noteLines = linesOfNote();
    const int side = std::clamp(std::min(width(), height() - textHeight(noteLines)), 0, largestSide);
    const int above = std::max(0, (height() - side - textHeight(noteLines)) / 2);
    m_dial = QRect((width() - side) / 2, above, side, side);
    m_still = {};
    m_number = QRect(0, m_dial.bottom() + 1 + grid::unit, width(),
                     heightOf(m_state.then ? numberFont() : numberFont(TextSize::large)));
    m_speed = QRect(0, m_number.bottom() + 1, width(), line);
    m_note = QRect(0, m_speed.bottom() + 1 + grid::unit, width(), noteLines * line + grid::unit);
}

void CodeDisc::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    arrange();
    if (m_state.then && event->size().width() != event->oldSize().width())
        updateGeometry(); // its note wraps at other places
}

void CodeDisc::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    switch (event->type()) {
    case QEvent::PaletteChange:
    case QEvent::StyleChange:
    case QEvent::FontChange:
        m_face.clear();
        m_coarseFace.clear();
        arrange();
        update();
        break;
    default:
        break;
    }
}

void CodeDisc::paintEvent(QPaintEvent *event)
{
    QPainter painter(this);
    if (event->region().intersects(m_dial)) {
        painter.save();
        painter.setClipRect(m_dial); // Qt rotates a pixmap faster within a single clip rectangle
        painter.translate(QRectF(m_dial).center());
        drawDisc(painter);
        drawThen(painter);
        drawStill(painter);
        painter.restore();
    }
    if (event->region().intersects(m_number | m_speed))
        drawNumbers(painter);
    if (event->region().intersects(m_note))
        dial_note::paint(painter, *this, m_note, m_state.role, note());
}

// Everything that does not turn with the disc, and so stays the same over many frames.
void CodeDisc::drawStill(QPainter &painter)
{
    if (m_isForPaper) {
        drawStillParts(painter);
        return;
    }
    const QPointF center = QRectF(m_dial).center() - m_dial.topLeft();
    if (m_still.isNull() || !qFuzzyCompare(m_still.devicePixelRatio(), devicePixelRatioF())) {
        m_still = QPixmap(m_dial.size() * devicePixelRatioF());
        m_still.setDevicePixelRatio(devicePixelRatioF());
        m_still.fill(Qt::transparent);
        QPainter onto(&m_still);
        onto.setRenderHint(QPainter::Antialiasing);
        onto.translate(center);
        drawStillParts(onto);
    }
    painter.drawPixmap(-center, m_still);
}

void CodeDisc::drawStillParts(QPainter &painter) const
{
    drawSpeed(painter);
    drawScale(painter);
    drawHub(painter);
}

void CodeDisc::drawSpeed(QPainter &painter) const
{
    const double radius = m_dial.width() / 2.0 - arcWidth / 2.0 - 1;
    const QRectF square(-radius, -radius, 2 * radius, 2 * radius);
    const auto arc = [&](const QColor &color, double from, double to) {
        painter.setPen(QPen(color, arcWidth, Qt::SolidLine, Qt::FlatCap));
        painter.drawArc(square, qRound((90 - from) * 16), qRound((from - to) * 16));
    };
    arc(palette().color(QPalette::Midlight), -arcHalf, arcHalf);
    if (m_state.rpm)
        arc(palette().color(QPalette::WindowText), 0, arcDegrees(*m_state.rpm));
    painter.setPen(QPen(palette().color(QPalette::Window), 1.5));
    for (const double rpm : {-1000.0, -100.0, -10.0, 0.0, 10.0, 100.0, 1000.0}) { // the decades
        painter.save();
        painter.rotate(arcDegrees(rpm));
        painter.drawLine(QPointF(0, -radius - arcWidth / 2.0), QPointF(0, -radius + arcWidth / 2.0));
        painter.restore();
    }
}

// The fixed scale the pointer turns on: eighths of a turn, with longer quarters.
void CodeDisc::drawScale(QPainter &painter) const
{
    const double outer = m_dial.width() / 2.0 - arcWidth - 3;
    painter.setPen(QPen(roleColor(Role::inactive, palette()), 1));
    for (int eighth = 0; eighth < 8; ++eighth) {
        painter.save();
        painter.rotate(eighth * 45);
        painter.drawLine(QPointF(0, -outer), QPointF(0, -outer + (eighth % 2 == 0 ? 5 : 3)));
        painter.restore();
    }
}

double CodeDisc::discRadius() const
{
    return m_dial.width() / 2.0 - arcWidth - scaleWidth;
}

void CodeDisc::drawDisc(QPainter &painter)
{
    const double radius = discRadius();
    if (radius <= 0)
        return;
    painter.save();
    painter.setOpacity(m_state.turnFraction && !m_state.isLastKnown ? 1.0 : 0.35); // no place of now
    painter.rotate(360.0 * placeOf(m_state.turnFraction).value_or(0) / pointerPlaces);
    drawFace(painter, qRound(2 * radius));
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setOpacity(1);
    if (m_state.turnFraction)
        drawPointer(painter, radius);
    painter.restore();
}

void CodeDisc::drawFace(QPainter &painter, int diameter)
{
    if (m_isForPaper) {
        DiscFace::paint(painter, diameter, palette());
        return;
    }
    const bool isFine = !isBlur(m_state);
    painter.setRenderHint(QPainter::SmoothPixmapTransform, isFine);
    painter.drawPixmap(QPointF(-diameter, -diameter) / 2,
                       (isFine ? m_face : m_coarseFace)
                           .picture(diameter, devicePixelRatioF() * (isFine ? 2 : 1), palette()));
}

QColor CodeDisc::pointerColor() const
{
    if (m_state.role == Role::inactive && !m_state.isLastKnown)
        return palette().color(QPalette::WindowText);
    return roleColor(m_state.isLastKnown ? Role::inactive : m_state.role, palette());
}

void CodeDisc::drawPointer(QPainter &painter, double radius) const
{
    const QColor color = pointerColor();
    const std::array head{QPointF(0, -radius - 5), QPointF(-5, -radius + 5), QPointF(5, -radius + 5)};
    painter.setPen(m_state.isLastKnown ? QPen(color, 1.5) : QPen(Qt::NoPen));
    painter.setBrush(m_state.isLastKnown ? palette().brush(QPalette::Window) : QBrush(color));
    painter.drawPolygon(head.data(), static_cast<int>(head.size()));
    painter.setPen(QPen(color, 1.5, m_state.isLastKnown ? Qt::DashLine : Qt::SolidLine));
    painter.drawLine(QPointF(0, -radius), QPointF(0, -radius * DiscFace::hubShare));
}

void CodeDisc::drawThen(QPainter &painter) const
{
    if (!m_state.then || !m_state.then->turnFraction)
        return;
    const double radius = discRadius();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.rotate(360.0 * *m_state.then->turnFraction);
    painter.setPen(then_mark::pen(palette()));
    painter.drawLine(QPointF(0, -radius), QPointF(0, -radius * DiscFace::hubShare));
    then_mark::paint(painter, palette(), QPointF(0, -radius));
    painter.restore();
}

void CodeDisc::drawHub(QPainter &painter) const
{
    const double radius = discRadius() * DiscFace::hubShare - 3;
    if (radius < 12)
        return;
    painter.setPen(QPen(roleColor(Role::inactive, palette()), 1));
    painter.setBrush(palette().color(QPalette::Window));
    painter.drawEllipse(QPointF(), radius, radius);
    if (!m_state.turn)
        return;
    painter.setPen(numberColor());
    painter.setFont(textFont(TextSize::small));
    const int small = painter.fontMetrics().height();
    const bool hasName =
        painter.fontMetrics().horizontalAdvance(tr("turn")) <= 2 * std::sqrt(radius * radius - small * small);
    if (hasName)
        painter.drawText(QRectF(-radius, -small, 2 * radius, small), Qt::AlignCenter, tr("turn"));
    painter.setFont(numberFont());
    const double number = painter.fontMetrics().height();
    painter.drawText(QRectF(-radius, hasName ? -grid::unit / 2.0 : -number / 2, 2 * radius, number),
                     Qt::AlignCenter, locale().toString(*m_state.turn));
}

void CodeDisc::drawNumbers(QPainter &painter) const
{
    if (m_state.then) {
        drawNowAndThen(painter);
        return;
    }
    painter.setPen(numberColor());
    painter.setFont(numberFont(TextSize::large));
    painter.drawText(m_number, Qt::AlignCenter, numberText());
    painter.setFont(m_state.isLastKnown ? font() : numberFont());
    painter.drawText(m_speed, Qt::AlignCenter, speedText(m_state));
}

void CodeDisc::drawNowAndThen(QPainter &painter) const
{
    const auto text = [this](const std::optional<qint64> &position) {
        return position ? locale().toString(*position) : QString();
    };
    then_mark::paintLegend(
        painter, palette(), numberFont(),
        {m_number, then_mark::nowText(text(m_state.position), m_state.age), pointerColor()});
    then_mark::paintLegend(painter, palette(), numberFont(),
                           {m_speed, then_mark::thenText(text(m_state.then->position)), {}});
}

QColor CodeDisc::numberColor() const
{
    return palette().color(m_state.isLastKnown ? QPalette::PlaceholderText : QPalette::WindowText);
}

QString CodeDisc::numberText() const
{
    if (m_state.position)
        return locale().toString(*m_state.position);
    return m_state.velocity ? tr("%1 rpm", "revolutions per minute").arg(locale().toString(*m_state.velocity))
                            : QString(QChar(0x2013));
}

// Or the age of the position.
QString CodeDisc::speedText(const DialState &state) const
{
    if (!state.rpm)
        return state.age;
    const double rpm = *state.rpm;
    const QString number = locale().toString(std::abs(rpm), 'f', 1);
    if (std::abs(rpm) < 0.05)
        return tr("%1 rpm", "revolutions per minute").arg(number);
    return rpm > 0 ? tr("%1 rpm cw", "clockwise").arg(number)
                   : tr("%1 rpm ccw", "counter-clockwise").arg(number);
}

QString CodeDisc::note() const
{
    const bool nothingKnown =
        !m_state.position && !m_state.turnFraction && !m_state.turn && !m_state.velocity && !m_state.rpm;
    if (m_state.note.isEmpty() && nothingKnown)
        return tr("No position yet. Start the bus and choose an encoder in the bus structure.");
    return m_state.note;
}

std::vector<std::pair<QString, QString>> CodeDisc::values() const
{
    std::vector<std::pair<QString, QString>> values;
    if (m_state.position)
        values.emplace_back(m_state.isLastKnown ? tr("Last position") : tr("Position"),
                            tr("%1 steps").arg(locale().toString(*m_state.position)));
    if (m_state.velocity)
        values.emplace_back(tr("Velocity"), numberText());
    if (m_state.turn)
        values.emplace_back(tr("Turn"), locale().toString(*m_state.turn));
    if (m_state.turnFraction)
        values.emplace_back(tr("Angle"),
                            tr("%1 degrees").arg(locale().toString(*m_state.turnFraction * 360, 'f', 0)));
    if (m_state.rpm)
        values.emplace_back(tr("Speed"), speedText(m_state));
    if (!m_state.age.isEmpty())
        values.emplace_back(tr("Age"), m_state.age);
    if (!note().isEmpty())
        values.emplace_back(tr("Note"), note());
    return values;
}

QString CodeDisc::valueText() const
{
    QStringList parts;
    if (m_state.position)
        parts.append((m_state.isLastKnown ? tr("Last position %1") : tr("Position %1"))
                         .arg(locale().toString(*m_state.position)));
    if (m_state.velocity)
        parts.append(tr("Velocity %1").arg(numberText()));
    if (m_state.turn)
        parts.append(tr("turn %1").arg(locale().toString(*m_state.turn)));
    if (m_state.turnFraction)
        parts.append(tr("%1 degrees").arg(locale().toString(*m_state.turnFraction * 360, 'f', 0)));
    if (m_state.rpm)
        parts.append(speedText(m_state));
    if (m_state.then)
        parts.append(then_mark::thenText(m_state.then->position ? locale().toString(*m_state.then->position)
                                                                : QString()));
    if (!m_state.age.isEmpty())
        parts.append(m_state.age);
    if (!note().isEmpty())
        parts.append(note());
    return parts.join(QStringLiteral(", "));
}

} // namespace codewheel
