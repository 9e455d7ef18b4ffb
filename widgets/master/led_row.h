// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ring/device_leds.h"

#include <QWidget>

#include <array>
#include <optional>

namespace codewheel {

class RoleLabel;

// The LEDs on the housing of a device as they have to be: each with its name and "on", "off" or "blinking".
// Used by the device panel.
class LedRow : public QWidget
{
    Q_OBJECT

public:
    explicit LedRow(QWidget *parent = nullptr);

    void showLeds(const DeviceLeds &leds);

private:
    std::array<RoleLabel *, 4> m_leds{}; // UL, RC, BA, RBDA
    std::optional<DeviceLeds> m_shown;
};

} // namespace codewheel
