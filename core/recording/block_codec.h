// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "history/sample.h"

#include <QByteArray>

#include <optional>
#include <vector>

namespace codewheel {

// Samples of one value that are kept as one piece, oldest first, at least one.
struct RecordedBlock
{
    // Before this sample nothing was known, from `from` on.
    struct GapBefore
    {
        std::size_t index = 0;
        Instant from{};

        friend bool operator==(const GapBefore &, const GapBefore &) = default;
    };
    static constexpr std::size_t most = 4096; // samples

    std::vector<Sample> samples;
    std::vector<GapBefore> gaps{}; // by index

    Summary summary() const;
    bool hasGap() const { return !gaps.empty(); }

    friend bool operator==(const RecordedBlock &, const RecordedBlock &) = default;
};

// As bytes of a recording (docs/recording-files.md, "A block").
QByteArray packBlock(const RecordedBlock &block);
// Nothing: it was changed by something else than this program, or is of another version.
std::optional<RecordedBlock> unpackBlock(QByteArrayView bytes);

} // namespace codewheel
