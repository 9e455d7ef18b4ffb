// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>

namespace codewheel {

// What a state means to whoever looks at it: views have a colour, an icon and a word for each.
enum class Role : std::uint8_t { running, attention, fault, setBit, inactive };

// How a state is shown, the same for buses, masters and devices.
struct StateWord
{
    Role role = Role::inactive;
    QString word; // in the user's language

    friend bool operator==(const StateWord &, const StateWord &) = default;
};

} // namespace codewheel
