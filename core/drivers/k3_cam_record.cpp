// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/k3_cam_record.h"

#include <algorithm>

namespace codewheel {

bool K3CamRecord::tell(unsigned program, CamField field, std::int64_t data)
{
    if (m_reading.number != program || m_told.all()) {
        m_reading = {.number = program, .cam = {}, .shift = 0};
        m_told.reset();
    }
    setValue(m_reading, field, data);
    m_told.set(indexOf(field));
    if (!m_told.all())
        return false;
    read.push_back(m_reading);
    if (!taken.contains(program))
        before[program] = m_reading;
    return true;
}

void K3CamRecord::take(unsigned program, CamField field)
{
    taken[program].set(indexOf(field));
    isPending = true;
}

bool K3CamRecord::canRestore() const
{
    return std::ranges::all_of(taken, [this](const auto &one) { return before.contains(one.first); });
}

} // namespace codewheel
