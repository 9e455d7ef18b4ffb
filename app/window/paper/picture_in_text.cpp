// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/paper/picture_in_text.h"

#include <QAbstractTextDocumentLayout>
#include <QPainter>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextFrame>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int pictureObject = QTextFormat::UserObject + 1;
constexpr int whichPicture = QTextFormat::UserProperty + 1;
constexpr double enlarged = 1.5;
constexpr int gap = 12; // above a picture, and below the last one

QTextBlockFormat apart()
{
    QTextBlockFormat format;
    format.setTopMargin(gap);
    return format;
}

double roomIn(const QTextDocument &document)
{
    const QTextFrameFormat format = document.rootFrame()->frameFormat();
    return document.pageSize().width() - format.leftMargin() - format.rightMargin();
}

} // namespace

PictureInText::PictureInText(const std::vector<PrintedPicture> &pictures)
    : m_pictures(pictures)
{}

void PictureInText::insertInto(QTextDocument &document)
{
    document.documentLayout()->registerHandler(pictureObject, this);
    QTextCursor cursor(&document);
    cursor.movePosition(QTextCursor::End);
    for (std::size_t i = 0; i < m_pictures.size(); ++i) {
        QTextCharFormat format;
        format.setObjectType(pictureObject);
        format.setProperty(whichPicture, static_cast<int>(i));
        cursor.insertBlock(apart(), QTextCharFormat());
        cursor.insertText(QString(QChar::ObjectReplacementCharacter), format);
    }
    cursor.insertBlock(apart(), QTextCharFormat());
}

const PrintedPicture &PictureInText::pictureOf(const QTextFormat &format) const
{
    return m_pictures.at(static_cast<std::size_t>(format.intProperty(whichPicture)));
}

QSizeF PictureInText::intrinsicSize(QTextDocument *document, int, const QTextFormat &format)
{
    const PrintedPicture &picture = pictureOf(format);
    const QPaintDevice *paper = document->documentLayout()->paintDevice();
    const double finer =
        paper == nullptr ? 1 : static_cast<double>(paper->logicalDpiX()) / picture.drawing.logicalDpiX();
    return picture.size * std::min(enlarged * finer, roomIn(*document) / picture.size.width());
}

void PictureInText::drawObject(QPainter *painter, const QRectF &room, QTextDocument *, int,
                               const QTextFormat &format)
{
    const PrintedPicture &picture = pictureOf(format);
    const double scale = room.width() / picture.size.width();
    painter->save();
    painter->translate(room.topLeft());
    painter->scale(scale, scale);
    painter->drawPicture(0, 0, picture.drawing);
    painter->restore();
}

} // namespace codewheel
