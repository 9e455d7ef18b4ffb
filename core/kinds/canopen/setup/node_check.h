// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/setup/identity_reading.h"

namespace codewheel::canopen {

// How often a node has reported.
struct BootUps
{
    int all = 0;
    int unasked = 0; // by a reset

    static BootUps of(const CanopenSnapshot &bus, int node);
};

// Looks for a device at the number it should have, once it was reset or was without supply; if nobody
// answers there, at the number it had before.
class NodeCheck final : public NodeTask
{
public:
    struct Wanted
    {
        int node = 0;
        NodeIdentity identity{};
        std::optional<int> nodeBefore{};
        BootUps before{}; // its supply was to be switched, heard of `node`
    };
    enum class Result : std::uint8_t {
        found,
        isOther, // another device answers there
        notTold, // whoever answers there does not tell its identity
        doubled, // two answer there
        atOldNumber,
        silent,
        notSent,
    };

    explicit NodeCheck(const Wanted &wanted);

    std::optional<Request> next(const CanopenSnapshot &bus) override;
    using NodeTask::answered;
    void answered(const SdoOutcome &outcome) override;
    bool isEnded() const override { return m_result.has_value(); }
    void cancel() override { m_result = Result::notSent; }

    const Wanted &wanted() const { return m_wanted; }
    const std::optional<Result> &result() const { return m_result; } // empty: it goes on
    bool wasWithoutSupply() const { return m_wasWithoutSupply; }     // it has reported, asked by nobody
    bool wasOnlyReset() const { return m_wasReset && !m_wasWithoutSupply; }

private:
    void takeAtNew(IdentityReading::Result result);
    bool hasOld() const { return m_wanted.nodeBefore && *m_wanted.nodeBefore != m_wanted.node; }

    Wanted m_wanted;
    IdentityReading m_reading;
    bool m_isAtOld = false;
    bool m_isAsked = false;
    Instant m_now{};
    std::optional<Instant> m_until{}; // it is waited for
    Instant m_dueAt{};                // it is asked again
    bool m_wasWithoutSupply = false;
    bool m_wasReset = false;
    bool m_isDoubled = false;
    std::optional<Result> m_result{};
};

} // namespace codewheel::canopen
