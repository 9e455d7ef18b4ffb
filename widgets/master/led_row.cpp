// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/master/led_row.h"

#include "widgets/look/grid.h"
#include "widgets/look/role_label.h"

#include <QHBoxLayout>

namespace codewheel {

LedRow::LedRow(QWidget *parent)
    : QWidget(parent)
{
    setObjectName(QStringLiteral("leds"));
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins({});
    row->setSpacing(grid::groupGap);
    const std::array tips{tr("UL, supply: the device has its voltage"),
                          tr("RC, remote bus check: the incoming bus is in order"),
                          tr("BA, bus active: on while data cycles run, blinking while they do not"),
                          tr("RBDA, remote bus disabled: the outgoing bus is switched off")};
    for (std::size_t i = 0; i < m_leds.size(); ++i) {
        m_leds[i] = new RoleLabel(this);
        m_leds[i]->setToolTip(tips[i]);
        row->addWidget(m_leds[i]);
    }
    row->addStretch(1);
}

void LedRow::showLeds(const DeviceLeds &leds)
{
    if (m_shown == leds)
        return;
    m_shown = leds;
    const std::array states{leds.ul, leds.rc, leds.ba, leds.rbda};
    const std::array names{QStringLiteral("UL"), QStringLiteral("RC"), QStringLiteral("BA"),
                           QStringLiteral("RBDA")};
    for (std::size_t i = 0; i < m_leds.size(); ++i) {
        const bool isFault = i == 3;
        const Role lit = isFault ? Role::fault : Role::running;
        const Role role = states[i] == LedLight::off        ? Role::inactive
                          : states[i] == LedLight::blinking ? Role::attention
                                                            : lit;
        m_leds[i]->setState(role, names[i] + u' ' + ledLightName(states[i]));
    }
    setAccessibleName(tr("LEDs: %1").arg(ledText(leds)));
}

} // namespace codewheel
