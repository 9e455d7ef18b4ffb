// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/palettes.h"

namespace codewheel {

namespace {

struct Grounds
{
    QRgb window, base, alternate, button, light, midlight, mid, dark, shadow;
    QRgb text, placeholder, disabled, highlight, highlighted, link, visited, tip;
};

constexpr Grounds lightGrounds{
    .window = 0xFFF3F4F5,
    .base = 0xFFFFFFFF,
    .alternate = 0xFFF7F8F9,
    .button = 0xFFEDEEF0,
    .light = 0xFFFFFFFF,
    .midlight = 0xFFE3E5E8,
    .mid = 0xFFC4C8CC,
    .dark = 0xFFA3A8AE,
    .shadow = 0xFF6B7076,
    .text = 0xFF1A1D21,
    .placeholder = 0xFF646B73,
    .disabled = 0xFF8A9097,
    .highlight = 0xFF0A6AA6,
    .highlighted = 0xFFFFFFFF,
    .link = 0xFF0A5F95,
    .visited = 0xFF5F4B8B,
    .tip = 0xFFFFFFFF,
};

constexpr Grounds darkGrounds{
    .window = 0xFF1F2327,
    .base = 0xFF171A1D,
    .alternate = 0xFF1C2023,
    .button = 0xFF2A2F34,
    .light = 0xFF3D444B,
    .midlight = 0xFF343A40,
    .mid = 0xFF3A4047,
    .dark = 0xFF121517,
    .shadow = 0xFF090B0C,
    .text = 0xFFE6E9EC,
    .placeholder = 0xFF9AA2AA,
    .disabled = 0xFF757D85,
    .highlight = 0xFF2A76AA,
    .highlighted = 0xFFFFFFFF,
    .link = 0xFF6FBDEB,
    .visited = 0xFFB7A5E0,
    .tip = 0xFF2A2F34,
};

} // namespace

QPalette paletteOf(Shade shade)
{
    const Grounds &ground = shade == Shade::light ? lightGrounds : darkGrounds;
    QPalette palette;
    const auto set = [&palette](QPalette::ColorRole role, QRgb color) {
        palette.setColor(QPalette::All, role, QColor::fromRgb(color));
    };
    set(QPalette::Window, ground.window);
    set(QPalette::Base, ground.base);
    set(QPalette::AlternateBase, ground.alternate);
    set(QPalette::Button, ground.button);
    set(QPalette::Light, ground.light);
    set(QPalette::Midlight, ground.midlight);
    set(QPalette::Mid, ground.mid);
    set(QPalette::Dark, ground.dark);
    set(QPalette::Shadow, ground.shadow);
    for (const auto role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
        set(role, ground.text);
        palette.setColor(QPalette::Disabled, role, QColor::fromRgb(ground.disabled));
    }
    set(QPalette::BrightText, ground.highlighted);
    set(QPalette::PlaceholderText, ground.placeholder);
    set(QPalette::Highlight, ground.highlight);
    set(QPalette::HighlightedText, ground.highlighted);
    palette.setColor(QPalette::Disabled, QPalette::Highlight, QColor::fromRgb(ground.mid));
    palette.setColor(QPalette::Disabled, QPalette::HighlightedText, QColor::fromRgb(ground.text));
    set(QPalette::Link, ground.link);
    set(QPalette::LinkVisited, ground.visited);
    set(QPalette::ToolTipBase, ground.tip);
    return palette;
}

} // namespace codewheel
