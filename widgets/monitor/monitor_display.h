// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>

namespace codewheel {

// What monitors show besides bits, hexadecimal and meaning; chosen by the user in their Show menu.
struct MonitorDisplay
{
    bool matrix = false; // bits in rows of 8
    bool bar = false;    // the position over its range
    bool decimal = true;
    bool signedDecimal = false;
    bool gray = false;
    bool binary = false;
    bool wholeWord = false; // numbers of all bits, not only D24..D0

    QJsonObject toJson() const;
    // Missing values keep the defaults above.
    static MonitorDisplay fromJson(const QJsonObject &json);

    friend bool operator==(const MonitorDisplay &, const MonitorDisplay &) = default;
};

} // namespace codewheel
