// SPDX-License-Identifier: GPL-3.0-or-later
#include "replay/recorded_rows.h"

#include "kinds/buses.h"

namespace codewheel {

std::unique_ptr<RecordedRows> recordedRows(std::span<const Profile> profiles, bool hasWords)
{
    for (const QString &kind : busKindKeys())
        for (const Profile profile : profiles)
            if (auto rows = busKind(kind)->recordedRows(profile))
                return rows;
    return rowsWithoutProfile(hasWords);
}

} // namespace codewheel
