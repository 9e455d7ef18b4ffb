// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/parameter.h"
#include "widgets/palette/palette_source.h"

#include <functional>

namespace codewheel {

class DeviceChoice;

// The parameters of the chosen encoder, for the command palette. Nothing is written: one is only shown.
class PaletteParameters : public PaletteSource
{
public:
    // The choice outlives it.
    PaletteParameters(const DeviceChoice &choice, std::function<void(Parameter)> show);

    void begin() override;
    std::vector<PaletteEntry> next() override;

private:
    const DeviceChoice &m_choice;
    const std::function<void(Parameter)> m_show;
    bool m_isGiven = false;
};

} // namespace codewheel
