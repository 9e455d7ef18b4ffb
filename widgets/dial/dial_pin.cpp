// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dial/dial_pin.h"

#include "widgets/dial/dial_head.h"
#include "widgets/dial/dial_panel.h"

namespace codewheel {

DialPin::DialPin(DialPanel &panel, const Buses &buses, StationOf stationOf)
    : QObject(&panel)
    , m_panel(panel)
    , m_buses(buses)
    , m_stationOf(std::move(stationOf))
{
    connect(&panel.head(), &DialHead::pinToggled, this, &DialPin::setPinned);
    connect(&buses, &Buses::changed, this, &DialPin::followBuses);
    show();
}

void DialPin::follow(const ShownEncoder &chosen)
{
    m_chosen = chosen;
    show();
}

std::optional<Place> DialPin::pinned() const
{
    return m_pin ? std::optional(m_pin->place) : std::nullopt;
}

void DialPin::pinForNow(Place place)
{
    if (m_buses.encoder(place) == nullptr)
        return;
    m_pin = {place, true};
    show();
}

std::optional<Place> DialPin::toKeep() const
{
    return m_pin && !m_pin->isForNow ? pinned() : std::nullopt;
}

void DialPin::restore(std::optional<Place> kept)
{
    m_pin = kept ? std::optional(Pin{*kept}) : std::nullopt;
    show();
}

void DialPin::setPinned(bool pinned)
{
    m_pin = pinned && m_chosen.isThere() ? std::optional(Pin{m_chosen.place()}) : std::nullopt;
    show();
}

void DialPin::followBuses()
{
    if (m_pin && m_pin->isForNow && m_buses.encoder(m_pin->place) == nullptr)
        m_pin.reset();
    show();
}

void DialPin::show()
{
    showHead();
    const bool isOffline = m_chosen.isThere() && m_chosen.session() == nullptr;
    EncoderSession *pinned = m_pin ? m_buses.encoder(m_pin->place) : nullptr;
    if (!m_pin && isOffline && m_buses.open(m_chosen.place().bus) != nullptr)
        m_panel.setAbsent(m_chosen.place());
    else if (!m_pin)
        m_panel.setEncoder(m_chosen.session(), isOffline ? std::optional(m_chosen.place()) : std::nullopt);
    else if (pinned == nullptr && m_buses.open(m_pin->place.bus) != nullptr)
        m_panel.setAway(m_pin->place);
    else
        m_panel.setEncoder(pinned, m_pin->place);
}

void DialPin::showHead()
{
    m_panel.head().setTitle(title());
    m_panel.head().setPinned(m_pin.has_value());
    Q_EMIT changed();
}

QString DialPin::title() const
{
    const ShownEncoder shown = m_pin ? ShownEncoder(m_buses.encoder(m_pin->place)) : m_chosen;
    if (shown.isThere())
        return calledInFull(shown.place(), m_stationOf(shown.place()), shown.device());
    return m_pin ? QStringLiteral("%1  %2").arg(m_pin->place.shown(), m_stationOf(m_pin->place)).trimmed()
                 : QString();
}

} // namespace codewheel
