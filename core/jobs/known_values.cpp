// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/known_values.h"

#include <utility>

namespace codewheel {

void KnownValues::set(const std::vector<Known> &known)
{
    m_known.clear();
    for (const Known &one : known)
        m_known[one.parameter] = one;
}

void KnownValues::learn(Known known)
{
    const auto before = m_known.find(known.parameter);
    if (known.kept == Kept::byItself && before != m_known.end() && before->second.value == known.value)
        known.kept = before->second.kept;
    m_known[known.parameter] = known;
    std::erase(m_changes.noLongerKnown, known.parameter);
    std::erase_if(m_changes.known, [&](const Known &other) { return other.parameter == known.parameter; });
    m_changes.known.push_back(known);
    m_changed = true;
}

void KnownValues::forget(Parameter parameter)
{
    if (m_known.erase(parameter) == 0)
        return;
    std::erase_if(m_changes.known, [&](const Known &other) { return other.parameter == parameter; });
    m_changes.noLongerKnown.push_back(parameter);
    m_changed = true;
}

void KnownValues::setKept(Kept kept, bool (*isMeant)(const Known &))
{
    for (const auto &[parameter, one] : m_known)
        if (Known known = one; isMeant(known)) {
            known.kept = kept;
            learn(known); // replaces the value of a key that is there
        }
}

void KnownValues::haveBeenStored()
{
    setKept(Kept::stored, [](const Known &) { return true; });
}

void KnownValues::mayHaveBeenStored()
{
    setKept(Kept::notKnown, [](const Known &known) { return known.kept == Kept::untilPowerOff; });
}

void KnownValues::countEepromWrite()
{
    ++m_eepromWrites;
    ++m_changes.eepromWrites;
    m_changed = true;
}

std::optional<Known> KnownValues::known(Parameter parameter) const
{
    const auto found = m_known.find(parameter);
    return found == m_known.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::int64_t> KnownValues::value(Parameter parameter) const
{
    const auto found = m_known.find(parameter);
    return found == m_known.end() ? std::nullopt : found->second.value.asNumber();
}

ParameterValues KnownValues::values() const
{
    ParameterValues all;
    for (const auto &[parameter, known] : m_known)
        all.push_back({parameter, known.value});
    return all;
}

std::optional<KnowledgeChanged> KnownValues::takeChanges()
{
    if (!m_changed)
        return std::nullopt;
    m_changed = false;
    return std::exchange(m_changes, {});
}

} // namespace codewheel
