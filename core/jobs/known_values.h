// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/event.h"

#include <map>

namespace codewheel {

// The values an encoder is known to have, and what has changed since somebody last asked. Used by whatever
// learns from the words that pass.
class KnownValues
{
public:
    // Replaces all that is known, e.g. after the user told something. Not reported as a change.
    void set(const std::vector<Known> &known);
    // A value that is what it was is kept as it was, unless that is said.
    void learn(Known known);
    void forget(Parameter parameter);
    // By a step that stores all that is in force. Where nobody saw its answer, it may have been.
    void haveBeenStored();
    void mayHaveBeenStored();
    void countEepromWrite();

    std::optional<Known> known(Parameter parameter) const;
    // Its number.
    std::optional<std::int64_t> value(Parameter parameter) const;
    ParameterValues values() const;
    int eepromWrites() const { return m_eepromWrites; }

    bool haveChanged() const { return m_changed; } // since the last call of takeChanges()
    // What changed since the last call; empty if nothing did.
    std::optional<KnowledgeChanged> takeChanges();

private:
    void setKept(Kept kept, bool (*isMeant)(const Known &));

    std::map<Parameter, Known> m_known;
    KnowledgeChanged m_changes;
    bool m_changed = false;
    int m_eepromWrites = 0;
};

} // namespace codewheel
