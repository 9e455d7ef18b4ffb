// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/palette/palette_kind.h"

#include "widgets/look/icons.h"
#include "widgets/palette/palette_model.h"

namespace codewheel {

QString kindWord(PaletteEntry::Kind kind)
{
    switch (kind) {
    case PaletteEntry::Kind::action:
        return PaletteModel::tr("Action");
    case PaletteEntry::Kind::device:
        return PaletteModel::tr("Device");
    case PaletteEntry::Kind::parameter:
        return PaletteModel::tr("Parameter");
    case PaletteEntry::Kind::message:
        return PaletteModel::tr("Message");
    case PaletteEntry::Kind::manual:
        break;
    }
    return PaletteModel::tr("Manual");
}

QString whatReturnDoes(const PaletteEntry &entry)
{
    switch (entry.kind) {
    case PaletteEntry::Kind::action:
        return entry.does;
    case PaletteEntry::Kind::device:
        return PaletteModel::tr("shows it in the bus structure and its monitor");
    case PaletteEntry::Kind::parameter:
        return PaletteModel::tr("shows it among the parameters, sends nothing");
    case PaletteEntry::Kind::message:
        return PaletteModel::tr("shows it among the messages");
    case PaletteEntry::Kind::manual:
        break;
    }
    return PaletteModel::tr("opens the manual there");
}

QIcon kindIcon(PaletteEntry::Kind kind)
{
    switch (kind) {
    case PaletteEntry::Kind::action:
        return lineIcon(Icon::next);
    case PaletteEntry::Kind::device:
        return lineIcon(Icon::encoder);
    case PaletteEntry::Kind::parameter:
        return lineIcon(Icon::parameters);
    case PaletteEntry::Kind::message:
        return lineIcon(Icon::messages);
    case PaletteEntry::Kind::manual:
        break;
    }
    return lineIcon(Icon::question);
}

} // namespace codewheel
