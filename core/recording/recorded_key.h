// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "history/shown_channels.h"

#include <QtGlobal>

namespace codewheel {

// Which channel of a recording, in any connection to it.
struct RecordedKey
{
    qint64 device = 0; // RecordingReader::Device::id
    Channel channel = Channel::position;

    friend bool operator==(const RecordedKey &, const RecordedKey &) = default;
    // clang-tidy 14 takes the 0 in a defaulted <=> for a null pointer.
    friend std::strong_ordering operator<=>(const RecordedKey &,
                                            const RecordedKey &) = default; // NOLINT(modernize-use-nullptr)
};

} // namespace codewheel
