// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/icons.h"

#include "widgets/look/grid.h"
#include "widgets/look/roles.h"

#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPixmapCache>
#include <QSvgRenderer>

#include <array>
#include <optional>

namespace codewheel {
namespace {

// Paints one line icon in the colour the palette has now.
class LineIconEngine final : public QIconEngine
{
public:
    LineIconEngine(Icon icon, std::optional<Role> role);

    void paint(QPainter *painter, const QRect &rect, QIcon::Mode mode, QIcon::State state) override;
    QPixmap pixmap(const QSize &size, QIcon::Mode mode, QIcon::State state) override;
    QPixmap scaledPixmap(const QSize &size, QIcon::Mode mode, QIcon::State state, qreal scale) override;
    QList<QSize> availableSizes(QIcon::Mode mode, QIcon::State state) override;
    QString key() const override;
    QIconEngine *clone() const override;

private:
    QColor color(QIcon::Mode mode) const;

    Icon m_icon;
    std::optional<Role> m_role;
};

// In the order of Icon.
constexpr std::array fileNames{
    "add",         "alarm-stop", "attention", "back",       "battery",    "cams",       "cancel",
    "compare",     "computer",   "copy",      "details",    "down",       "drive",      "encoder",
    "export-data", "fault",      "file",      "filter",     "folder",     "home",       "inactive",
    "information", "list",       "master",    "messages",   "monitor",    "new-folder", "next",
    "ok",          "open",       "operate",   "parameters", "paste",      "pause",      "pin",
    "play-back",   "power",      "preset",    "question",   "read",       "record",     "refresh",
    "remove",      "ring",       "running",   "save",       "search",     "sequence",   "set-bit",
    "shaft",       "start",      "step",      "step-back",  "stop",       "to-begin",   "to-end",
    "trace",       "training",   "trend",     "turn-left",  "turn-right", "up",         "watch",
    "wizard",      "write",
};
static_assert(fileNames.size() == iconCount);

QLatin1String fileName(Icon icon)
{
    return QLatin1String(fileNames.at(static_cast<std::size_t>(icon)));
}

// The drawings are on a grid of 24 with strokes of 1.5; a smaller icon needs wider strokes in them.
QByteArray drawing(Icon icon, int logicalSize)
{
    QFile file(QStringLiteral(":/codewheel/icons/%1.svg").arg(fileName(icon)));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const double width = 1.5 * grid::largeIcon / qBound(1, logicalSize, grid::largeIcon);
    return file.readAll().replace("stroke-width=\"1.5\"",
                                  "stroke-width=\"" + QByteArray::number(width) + '"');
}

QPixmap drawnIcon(Icon icon, QSize size, qreal scale, const QColor &color)
{
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    const int logicalSize = qRound(qMin(size.width(), size.height()) / scale);
    QSvgRenderer renderer(drawing(icon, logicalSize));
    renderer.setAspectRatioMode(Qt::KeepAspectRatio);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    renderer.render(&painter);
    painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
    painter.fillRect(pixmap.rect(), color);
    painter.end();
    pixmap.setDevicePixelRatio(scale);
    return pixmap;
}

LineIconEngine::LineIconEngine(Icon icon, std::optional<Role> role)
    : m_icon(icon)
    , m_role(role)
{}

QColor LineIconEngine::color(QIcon::Mode mode) const
{
    const QPalette palette = QGuiApplication::palette();
    if (mode == QIcon::Disabled)
        return palette.color(QPalette::Disabled, QPalette::WindowText);
    if (mode == QIcon::Selected)
        return palette.color(QPalette::HighlightedText);
    return m_role ? roleColor(*m_role, palette) : palette.color(QPalette::WindowText);
}

void LineIconEngine::paint(QPainter *painter, const QRect &rect, QIcon::Mode mode, QIcon::State state)
{
    const qreal scale = painter->device()->devicePixelRatio();
    const QSize size = (QSizeF(rect.size()) * scale).toSize();
    painter->drawPixmap(rect, scaledPixmap(size, mode, state, scale));
}

QPixmap LineIconEngine::pixmap(const QSize &size, QIcon::Mode mode, QIcon::State state)
{
    return scaledPixmap(size, mode, state, 1.0);
}

// size is in device pixels.
QPixmap LineIconEngine::scaledPixmap(const QSize &size, QIcon::Mode mode, QIcon::State, qreal scale)
{
    const QColor ink = color(mode);
    const QString cacheKey = QStringLiteral("codewheel %1 %2x%3 %4 %5")
                                 .arg(fileName(m_icon))
                                 .arg(size.width())
                                 .arg(size.height())
                                 .arg(scale)
                                 .arg(ink.rgba(), 8, 16);
    QPixmap found;
    if (!QPixmapCache::find(cacheKey, &found)) {
        found = drawnIcon(m_icon, size, scale, ink);
        QPixmapCache::insert(cacheKey, found);
    }
    return found;
}

QList<QSize> LineIconEngine::availableSizes(QIcon::Mode, QIcon::State)
{
    return {QSize(grid::smallIcon, grid::smallIcon), QSize(grid::largeIcon, grid::largeIcon)};
}

QString LineIconEngine::key() const
{
    return QStringLiteral("codewheel-line");
}

QIconEngine *LineIconEngine::clone() const
{
    return new LineIconEngine(*this);
}

} // namespace

QIcon lineIcon(Icon icon)
{
    return QIcon(new LineIconEngine(icon, std::nullopt));
}

QIcon lineIcon(Icon icon, Role role)
{
    return QIcon(new LineIconEngine(icon, role));
}

} // namespace codewheel
