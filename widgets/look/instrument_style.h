// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProxyStyle>

namespace codewheel {

// Fusion with our icons in Qt's dialogs, and with two user options: large controls and less motion. Made by
// applyAppearance(); the application owns it.
class InstrumentStyle final : public QProxyStyle
{
    Q_OBJECT

public:
    // Asked by controlFactor(): 1 with large controls.
    static constexpr auto largeControlsHint = static_cast<StyleHint>(SH_CustomBase + 1);

    InstrumentStyle(bool largeControls, bool lessMotion);

    int styleHint(StyleHint hint, const QStyleOption *option, const QWidget *widget,
                  QStyleHintReturn *returned) const override;
    int pixelMetric(PixelMetric metric, const QStyleOption *option, const QWidget *widget) const override;
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex *option, QPainter *painter,
                            const QWidget *widget) const override;
    void drawPrimitive(PrimitiveElement element, const QStyleOption *option, QPainter *painter,
                       const QWidget *widget) const override;
    void drawControl(ControlElement element, const QStyleOption *option, QPainter *painter,
                     const QWidget *widget) const override;
    QSize sizeFromContents(ContentsType type, const QStyleOption *option, const QSize &contents,
                           const QWidget *widget) const override;
    QIcon standardIcon(StandardPixmap which, const QStyleOption *option,
                       const QWidget *widget) const override;

private:
    bool m_largeControls;
    bool m_lessMotion;
};

} // namespace codewheel
