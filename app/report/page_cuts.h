// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>

#include <vector>

class QTextDocument;

namespace codewheel {

// What of a long document stands on one sheet. A sheet that begins within a table has its header once more.
struct PageCut
{
    qreal top = 0;
    qreal bottom = 0;
    QRectF header;
};

// Cuts it into sheets of this height: a row of a table, a picture or a line is cut only where it is higher
// than a sheet, a heading stands with what follows, and the last chapter, to be signed, on one sheet.
std::vector<PageCut> pageCuts(const QTextDocument &document, qreal height);

} // namespace codewheel
