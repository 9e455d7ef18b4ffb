// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/roles.h"

#include <QCoreApplication>

namespace codewheel {

namespace {

// The hues are those of Okabe and Ito, which colour-blind people can tell apart, made darker or lighter until
// they stand out from the background. Attention and fault also differ in lightness.
struct Shades
{
    QRgb light;
    QRgb onLight; // for digits on a fill of it
    QRgb dark;
    QRgb onDark;
};

constexpr QRgb white = 0xFFFFFFFF;
constexpr QRgb ink = 0xFF0B0E11;

constexpr Shades shadesOf(Role role)
{
    switch (role) {
    case Role::running:
        return {0xFF00805C, white, 0xFF2BC499, ink}; // from #009E73
    case Role::attention:
        return {0xFFB87200, ink, 0xFFF0B23C, ink}; // from #E69F00
    case Role::fault:
        return {0xFFB53A00, white, 0xFFFF8147, ink}; // from #D55E00
    case Role::setBit:
        return {0xFF0072B2, white, 0xFF58B0E6, ink}; // from #0072B2
    case Role::inactive:
        break;
    }
    return {0xFF697078, white, 0xFF8F98A1, ink};
}

} // namespace

Shade shadeOf(const QPalette &palette)
{
    return palette.color(QPalette::Active, QPalette::Window).lightness() < 128 ? Shade::dark : Shade::light;
}

QColor roleColor(Role role, const QPalette &palette)
{
    const Shades shades = shadesOf(role);
    return QColor::fromRgb(shadeOf(palette) == Shade::light ? shades.light : shades.dark);
}

QColor textOn(Role role, const QPalette &palette)
{
    const Shades shades = shadesOf(role);
    return QColor::fromRgb(shadeOf(palette) == Shade::light ? shades.onLight : shades.onDark);
}

QString roleWord(Role role)
{
    switch (role) {
    case Role::running:
        return QCoreApplication::translate("Role", "Running");
    case Role::attention:
        return QCoreApplication::translate("Role", "Attention");
    case Role::fault:
        return QCoreApplication::translate("Role", "Fault");
    case Role::setBit:
        return QCoreApplication::translate("Role", "Set");
    case Role::inactive:
        break;
    }
    return QCoreApplication::translate("Role", "Inactive");
}

Icon roleIcon(Role role)
{
    switch (role) {
    case Role::running:
        return Icon::running;
    case Role::attention:
        return Icon::attention;
    case Role::fault:
        return Icon::fault;
    case Role::setBit:
        return Icon::setBit;
    case Role::inactive:
        break;
    }
    return Icon::inactive;
}

} // namespace codewheel
