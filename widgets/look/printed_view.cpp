// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/printed_view.h"

#include "widgets/look/palettes.h"

#include <QAbstractItemView>
#include <QPainter>

namespace codewheel {

PrintedPicture drawnOnPaper(QWidget &view, QSize size)
{
    QPalette paper = paletteOf(Shade::light);
    for (const QPalette::ColorRole ground : {QPalette::Window, QPalette::Base, QPalette::AlternateBase})
        paper.setColor(ground, Qt::white);
    view.setPalette(paper);
    view.resize(size);
    PrintedPicture picture{.drawing = QPicture(), .size = size};
    QPainter painter(&picture.drawing);
    view.render(&painter, {}, {}, QWidget::DrawChildren);
    return picture;
}

} // namespace codewheel
