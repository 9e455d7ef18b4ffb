// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace codewheel {

// What a page of a bus is about, besides the jobs of encoders, and what may be lost if the bus is left now.
// In sentences.
struct WorkUnderWay
{
    QString what{};
    QString atStake{};
};

} // namespace codewheel
