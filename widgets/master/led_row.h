// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/place.h"
#include "ring/device_leds.h"

#include <QWidget>

#include <array>
#include <optional>

namespace codewheel {

class RingSession;
class RoleLabel;

// The LEDs on the housing of a device as they have to be: each with its name and "on", "off" or "blinking".
// A look at the housing tells whether they are. Hidden where the device has none of these. Stands in the
// device panel.
class LedRow : public QWidget
{
    Q_OBJECT

public:
    // The ring outlives it.
    explicit LedRow(const RingSession &ring, QWidget *parent = nullptr);

    void setPlace(std::optional<Place> place); // of this ring; nothing: hidden

private:
    void refresh();
    void showLeds(const DeviceLeds &leds);

    const RingSession &m_ring;
    std::optional<Place> m_place;
    std::array<RoleLabel *, 4> m_leds{}; // UL, RC, BA, RBDA
    std::optional<DeviceLeds> m_shown;
};

} // namespace codewheel
