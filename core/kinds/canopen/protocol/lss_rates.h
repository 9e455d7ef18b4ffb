// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace codewheel::canopen {

// A rate in table 0 of CiA 305, where LSS names it by its place. Place 5 is reserved.
struct LssRate
{
    int rate = 0; // Bd
    int place = 0;

    friend bool operator==(const LssRate &, const LssRate &) = default;
};
inline constexpr std::array<LssRate, 8> lssRates{{{1'000'000, 0},
                                                  {800'000, 1},
                                                  {500'000, 2},
                                                  {250'000, 3},
                                                  {125'000, 4},
                                                  {50'000, 6},
                                                  {20'000, 7},
                                                  {10'000, 8}}};

// Null: LSS has no name for it.
constexpr const LssRate *lssRate(long long rate)
{
    for (const LssRate &one : lssRates)
        if (one.rate == rate)
            return &one;
    return nullptr;
}

} // namespace codewheel::canopen
