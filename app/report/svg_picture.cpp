// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/svg_picture.h"

#include <QSvgRenderer>
#include <QTextDocument>

namespace codewheel {
namespace {

QByteArray svgOf(const QTextFormat &format)
{
    return QByteArray::fromBase64(format.toImageFormat().name().toLatin1());
}

} // namespace

QSizeF SvgPicture::intrinsicSize(QTextDocument *document, int, const QTextFormat &format)
{
    return QSvgRenderer(svgOf(format))
        .viewBoxF()
        .size()
        .scaled(document->textWidth(), INFINITY, Qt::KeepAspectRatio);
}

void SvgPicture::drawObject(QPainter *painter, const QRectF &rect, QTextDocument *, int,
                            const QTextFormat &format)
{
    QSvgRenderer(svgOf(format)).render(painter, rect);
}

} // namespace codewheel
