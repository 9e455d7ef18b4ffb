// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/printed_view.h"

#include <QTextObjectInterface>

namespace codewheel {

// A picture in the text of a printed sheet, as wide as it is on a screen and a half, or as the sheet.
class PictureInText : public QObject, public QTextObjectInterface
{
    Q_OBJECT
    Q_INTERFACES(QTextObjectInterface)

public:
    explicit PictureInText(const std::vector<PrintedPicture> &pictures);

    void insertInto(QTextDocument &document); // at its end; it outlives the printing of it

    QSizeF intrinsicSize(QTextDocument *document, int position, const QTextFormat &format) override;
    void drawObject(QPainter *painter, const QRectF &room, QTextDocument *document, int position,
                    const QTextFormat &format) override;

private:
    const PrintedPicture &pictureOf(const QTextFormat &format) const;

    const std::vector<PrintedPicture> &m_pictures;
};

} // namespace codewheel
