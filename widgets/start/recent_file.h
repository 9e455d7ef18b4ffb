// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace codewheel {

// A file that was open before, and whether it can be opened now, as far as is known.
struct RecentFile
{
    enum class State : std::uint8_t { unknown, there, missing, notReadable, silent };

    QString path;
    State state = State::unknown;

    bool canBeOpened() const { return state == State::unknown || state == State::there; }

    friend bool operator==(const RecentFile &, const RecentFile &) = default;
};

} // namespace codewheel
