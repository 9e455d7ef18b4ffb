// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/line/line_row_text.h"

#include "widgets/look/fonts.h"

#include <QFontMetrics>

namespace codewheel {
namespace {

using RowKind = esc::LineRow::Kind;

constexpr char16_t escapePicture = 0x241B;

} // namespace

ControlCharacters shownControls()
{
    static const bool hasPictures = QFontMetrics(numberFont()).inFont(QChar(escapePicture));
    return hasPictures ? ControlCharacters::pictures : ControlCharacters::numbers;
}

QIcon rowKindIcon(RowKind kind)
{
    switch (kind) {
    case RowKind::sent:
        return lineIcon(Icon::next);
    case RowKind::answer:
        return lineIcon(Icon::back);
    case RowKind::echo:
        return lineIcon(Icon::refresh, Role::inactive);
    case RowKind::garbage:
        return lineIcon(Icon::fault, Role::fault);
    case RowKind::late:
        break;
    }
    return lineIcon(Icon::attention, Role::attention);
}

} // namespace codewheel
