// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/lss_client.h"

namespace codewheel::canopen {

// Selects one device by LSS, so that what is written next reaches it and nobody else, and reads back which
// one it is. Until everybody is sent back to operation it is in configuration. A state machine without I/O.
class LssSelection
{
public:
    enum class By : std::uint8_t {
        identity, // that is given
        fastScan, // a device without a number, which is looked for
        alone,    // whoever is there
    };
    enum class Trouble : std::uint8_t {
        notSent,
        nobody,  // answers
        lost,    // a device without a number answers, but not to the end of the search
        notTold, // it was selected, and does not tell identity and number
        isOther, // not the one that is given
        several, // answer
    };

    // `identity`: that the device must have.
    explicit LssSelection(By by, const std::optional<NodeIdentity> &identity = {});

    std::optional<LssRequest> next() const; // empty: it has ended
    void take(const LssOutcome &outcome);   // of that

    const std::optional<Trouble> &trouble() const { return m_trouble; }
    bool isSelected() const { return m_step == Step::end && !m_trouble; }
    const NodeIdentity &identity() const { return m_identity; } // of the selected one
    std::optional<int> node() const { return m_node; }          // likewise; empty: it has none

private:
    enum class Step : std::uint8_t { operateAll, select, identity, node, end };

    void stop(Trouble trouble);
    void takeSelected(const LssOutcome &outcome);
    void takeTold(const LssOutcome &outcome);
    void compare();

    By m_by;
    Step m_step = Step::operateAll;
    std::optional<NodeIdentity> m_wanted; // as given, or as the search has found it
    NodeIdentity m_identity{};
    std::optional<int> m_node{};
    int m_extraAnswers = 0;
    std::optional<Trouble> m_trouble{};
};

} // namespace codewheel::canopen
