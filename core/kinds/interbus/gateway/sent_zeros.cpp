// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/sent_zeros.h"

#include <utility>

namespace codewheel {

SentZeros ZerosRecord::told() const
{
    const std::scoped_lock lock(m_mutex);
    return m_told;
}

// Nobody knows of the first ones until there is an answer; of others it is told what came of those before.
void ZerosRecord::send(Instant now)
{
    const std::scoped_lock lock(m_mutex);
    m_before = m_told;
    m_told.mayHaveArrived = m_told.mayHaveArrived || !m_told.sentAt;
    m_told.sentAt = m_told.sentAt.value_or(now);
}

void ZerosRecord::acknowledged(Instant now)
{
    const std::scoped_lock lock(m_mutex);
    m_told.mayHaveArrived = true;
    m_told.refusedBy.clear();
    m_told.acknowledgedAt = m_told.acknowledgedAt.value_or(now);
}

void ZerosRecord::unanswered()
{
    const std::scoped_lock lock(m_mutex);
    m_told.mayHaveArrived = true;
}

void ZerosRecord::refused()
{
    const std::scoped_lock lock(m_mutex);
    m_told.mayHaveArrived = m_before.mayHaveArrived;
}

void ZerosRecord::refusedBy(std::vector<std::size_t> devices)
{
    const std::scoped_lock lock(m_mutex);
    m_told.mayHaveArrived = true;
    m_told.refusedBy = std::move(devices);
}

void ZerosRecord::notSent()
{
    const std::scoped_lock lock(m_mutex);
    m_told = m_before;
}

void ZerosRecord::readBack(Instant now)
{
    const std::scoped_lock lock(m_mutex);
    m_told.readBackAt = m_told.readBackAt.value_or(now);
}

} // namespace codewheel
