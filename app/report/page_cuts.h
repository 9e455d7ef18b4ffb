// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>

#include <vector>

class QTextDocument;

namespace codewheel {

// The part of a long document on one sheet. A sheet that begins within a table repeats its header.
struct PageCut
{
    qreal top = 0;
    qreal bottom = 0;
    QRectF header;
};

// Cuts it into sheets of this height: a table row, a picture or a line is cut only if it is higher than a
// sheet, a heading stays with what follows, and the last chapter, for signing, stays on one sheet.
std::vector<PageCut> pageCuts(const QTextDocument &document, qreal height);

} // namespace codewheel
