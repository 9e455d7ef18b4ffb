// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/appearance.h"

#include "widgets/look/instrument_style.h"
#include "widgets/look/palettes.h"

#include <QApplication>
#include <QToolTip>

namespace codewheel {

Shade shadeFor(Scheme scheme, const QPalette &desktop)
{
    switch (scheme) {
    case Scheme::light:
        return Shade::light;
    case Scheme::dark:
        return Shade::dark;
    case Scheme::system:
        break;
    }
    return shadeOf(desktop);
}

void applyAppearance(QApplication &application, const Appearance &appearance)
{
    application.setStyle(new InstrumentStyle(appearance.largeControls, appearance.lessMotion));
    application.setPalette(QPalette()); // back to the desktop's own
    const QPalette palette = paletteOf(shadeFor(appearance.scheme, application.palette()));
    application.setPalette(palette);
    QToolTip::setPalette(palette);
}

double controlFactor(const QWidget &widget)
{
    return widget.style()->styleHint(InstrumentStyle::largeControlsHint, nullptr, &widget) != 0 ? 1.5 : 1.0;
}

} // namespace codewheel
