// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace codewheel {

// How a simulated ring is to be offered to others: where, and what they may do.
struct OfferWish
{
    static constexpr int mostSeats = 64;
    static constexpr int lastPort = 65'535;

    QString address = QStringLiteral("127.0.0.1"); // of this computer; "0.0.0.0": all it has
    int port = 1'502;                              // 0: one that the system chooses
    bool hasSeats = false;                         // each its own ring; false: one ring for all
    int seats = 12;
    bool readOnly = false;

    friend bool operator==(const OfferWish &, const OfferWish &) = default;
};

// Whether programs on other computers reach it there.
bool reachesOthers(const QString &address);

} // namespace codewheel
