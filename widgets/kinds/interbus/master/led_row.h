// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/device_leds.h"
#include "vocabulary/place.h"

#include <QWidget>

#include <array>
#include <optional>

namespace codewheel {

class RingSession;
class RoleLabel;

// The state that the LEDs on a device's housing should have: each with its name and "on", "off" or
// "blinking", to compare with the housing. Hidden for devices without these LEDs. Part of the device panel.
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
    void showUnknown();

    const RingSession &m_ring;
    std::optional<Place> m_place;
    std::array<RoleLabel *, 4> m_leds{}; // UL, RC, BA, RBDA
    std::optional<DeviceLeds> m_shown;
};

} // namespace codewheel
