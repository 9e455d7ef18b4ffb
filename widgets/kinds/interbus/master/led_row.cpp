// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/interbus/master/led_row.h"

#include "kinds/interbus/ring/ring_session.h"
#include "vocabulary/freshness_text.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"
#include "widgets/look/role_label.h"

#include <QHBoxLayout>

#include <algorithm>

namespace codewheel {
namespace {

const std::array ledNames{QStringLiteral("UL"), QStringLiteral("RC"), QStringLiteral("BA"),
                          QStringLiteral("RBDA")};

} // namespace

LedRow::LedRow(const RingSession &ring, QWidget *parent)
    : QWidget(parent)
    , m_ring(ring)
{
    setObjectName(QStringLiteral("leds"));
    auto *row = layOut<QHBoxLayout>(this, grid::groupGap);
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
    connect(&ring, &RingSession::updated, this, &LedRow::refresh);
    connect(&ring, &RingSession::stateChanged, this, &LedRow::refresh);
    refresh();
}

void LedRow::setPlace(std::optional<Place> place)
{
    m_place = place;
    refresh();
}

void LedRow::refresh()
{
    const Snapshot &latest = m_ring.latest();
    const RingStructure &structure = m_ring.structure();
    const auto device =
        m_place ? std::ranges::find(structure, m_place->node, &RingDevice::number) : structure.end();
    const auto index = static_cast<std::size_t>(device - structure.begin());
    const bool isShown =
        m_ring.isOpen() && index < latest.devices.size() && hasRemoteBusLeds(m_ring.encoder(device->number));
    setVisible(isShown);
    if (isShown && !latest.connected)
        showUnknown();
    else if (isShown)
        showLeds(ledsOf(latest.state, latest.devices[index].inRing));
}

void LedRow::showLeds(const DeviceLeds &leds)
{
    if (m_shown == leds)
        return;
    m_shown = leds;
    const std::array states{leds.ul, leds.rc, leds.ba, leds.rbda};
    for (std::size_t i = 0; i < m_leds.size(); ++i) {
        const bool isFault = i == 3;
        const Role lit = isFault ? Role::fault : Role::running;
        const Role role = states[i] == LedLight::off        ? Role::inactive
                          : states[i] == LedLight::blinking ? Role::attention
                                                            : lit;
        m_leds[i]->setState(role, ledNames[i] + u' ' + ledLightName(states[i]));
    }
    setAccessibleName(tr("LEDs: %1").arg(ledText(leds)));
}

// What the master would say nobody hears while the link is lost.
void LedRow::showUnknown()
{
    m_shown.reset();
    for (std::size_t i = 0; i < m_leds.size(); ++i)
        m_leds[i]->setState(Role::inactive, ledNames[i] + QStringLiteral(" \u2013"));
    setAccessibleName(tr("LEDs: not known. %1", "why").arg(freshnessText(Freshness::Reason::linkLost)));
}

} // namespace codewheel
