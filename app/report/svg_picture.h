// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTextObjectInterface>

namespace codewheel {

// Draws the images of a text document whose name is an SVG picture in Base64, as wide as the text.
class SvgPicture : public QObject, public QTextObjectInterface
{
    Q_OBJECT
    Q_INTERFACES(QTextObjectInterface)

public:
    using QObject::QObject;

    QSizeF intrinsicSize(QTextDocument *document, int position, const QTextFormat &format) override;
    void drawObject(QPainter *painter, const QRectF &rect, QTextDocument *document, int position,
                    const QTextFormat &format) override;
};

} // namespace codewheel
