// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/fonts.h"

#include <QApplication>
#include <QFontDatabase>

namespace codewheel {

namespace {

double factorOf(TextSize size)
{
    switch (size) {
    case TextSize::small:
        return 0.8;
    case TextSize::normal:
        return 1.0;
    case TextSize::large:
        break;
    }
    return 1.6;
}

// The application's font may be given in points or in pixels.
QFont sized(QFont font, TextSize size)
{
    const QFont normal = QApplication::font();
    if (normal.pointSizeF() > 0)
        font.setPointSizeF(normal.pointSizeF() * factorOf(size));
    else
        font.setPixelSize(qRound(normal.pixelSize() * factorOf(size)));
    return font;
}

} // namespace

QFont textFont(TextSize size)
{
    return sized(QApplication::font(), size);
}

// The one that comes with the package fits the height of the texts; other computers have it first or not.
QFont numberFont(TextSize size)
{
    QFont font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    font.setFamilies({QStringLiteral("DejaVu Sans Mono"), font.family()});
    font.setStyleHint(QFont::Monospace);
    return sized(font, size);
}

} // namespace codewheel
