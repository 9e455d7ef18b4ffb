// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/line/line_row_text.h"

#include "widgets/look/fonts.h"

#include <QFontMetrics>

namespace codewheel {
namespace {

using Kind = esc::LineRow::Kind;

constexpr char16_t escapePicture = 0x241B;

} // namespace

ControlCharacters shownControls()
{
    static const bool hasPictures = QFontMetrics(numberFont()).inFont(QChar(escapePicture));
    return hasPictures ? ControlCharacters::pictures : ControlCharacters::numbers;
}

QIcon rowKindIcon(Kind kind)
{
    switch (kind) {
    case Kind::sent:
        return lineIcon(Icon::next);
    case Kind::answer:
        return lineIcon(Icon::back);
    case Kind::echo:
        return lineIcon(Icon::refresh, Role::inactive);
    case Kind::garbage:
        return lineIcon(Icon::fault, Role::fault);
    case Kind::late:
        break;
    }
    return lineIcon(Icon::attention, Role::attention);
}

} // namespace codewheel
