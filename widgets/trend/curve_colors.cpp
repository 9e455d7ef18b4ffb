// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/trend/curve_colors.h"

#include "widgets/look/roles.h"

#include <array>

namespace codewheel {

QColor curveColor(std::size_t index, const QPalette &palette)
{
    static constexpr std::array<QRgb, 6> onLight{0xFF0072B2, 0xFF882255, 0xFF6B6100,
                                                 0xFF332288, 0xFF117A8B, 0xFF8C4A10};
    static constexpr std::array<QRgb, 6> onDark{0xFF56B4E9, 0xFFE68FC0, 0xFFDDCC77,
                                                0xFFA99CF0, 0xFF6FD3D0, 0xFFDDA36A};
    const auto &colors = shadeOf(palette) == Shade::light ? onLight : onDark;
    return QColor::fromRgb(colors[index % colors.size()]);
}

} // namespace codewheel
