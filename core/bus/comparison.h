// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>
#include <optional>
#include <vector>

namespace codewheel {

// How one line of a configured bus compares to the connected one.
enum class ComparisonKind : std::uint8_t {
    same,
    differs,    // another device is in its place
    missing,    // configured, not connected
    additional, // connected, not configured
    moved,      // connected at another place
};

// Indices among the devices of the two: `configured` is missing only for additional, `connected` only for
// missing.
struct ComparisonLine
{
    ComparisonKind kind = ComparisonKind::same;
    std::optional<std::size_t> configured;
    std::optional<std::size_t> connected;

    friend bool operator==(const ComparisonLine &, const ComparisonLine &) = default;
};
using Comparison = std::vector<ComparisonLine>; // in the order of the bus

int differences(const Comparison &comparison); // lines that are not the same
inline bool areSame(const Comparison &comparison)
{
    return differences(comparison) == 0;
}

// "same", "missing", in the user's language; and for programs, the same in every language.
QString comparisonKindName(ComparisonKind kind);
QString comparisonKindKey(ComparisonKind kind);

} // namespace codewheel
