// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace codewheel {

// A serial port of this computer, as the list shows it.
struct PortRow
{
    QString name; // that it is opened by
    QString description;
    QString serialNumber; // of the adapter; empty: it has none

    friend bool operator==(const PortRow &, const PortRow &) = default;
};

} // namespace codewheel
