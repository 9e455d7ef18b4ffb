// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/lss_rates.h"
#include "kinds/canopen/protocol/lss_selection.h"
#include "kinds/canopen/setup/identity_reading.h"

namespace codewheel::canopen {

// Which device gets which number and rate, and how.
struct NodeSetupWish
{
    enum class Way : std::uint8_t {
        lss,             // selected by its identity
        lssWithoutStore, // likewise, stored by 1010h:1 as some makes want it; of one that has a number
        object,          // that its description names, stored by 1010h:1
    };

    Way way = Way::lss;
    NodeIdentity identity{};         // as it was read before
    std::optional<int> nodeBefore{}; // empty: it has none
    std::optional<int> node{};       // that it gets; empty: it stays
    std::optional<LssRate> rate{};   // likewise; by LSS only
    SdoObject nodeObject{};          // by object, an u8

    bool changesNode() const { return node && node != nodeBefore; }
    int nodeAfter() const { return node.value_or(nodeBefore.value_or(0)); }
    // Whether it is seen at once, after a reset: with another rate it is not at this one any more.
    bool isResetAfterwards() const { return nodeBefore && !rate; }

    friend bool operator==(const NodeSetupWish &, const NodeSetupWish &) = default;
};

// Gives a device its number and rate, stores both, and resets it. Before anything is written nobody may
// answer at the new number, and the device that is about to take it has to be the one that is meant.
class NodeSetup final : public NodeTask
{
public:
    enum class Step : std::uint8_t {
        free,     // nobody has the new number
        identity, // by object: of the node
        select,   // by LSS
        node,
        rate,
        store,
        leave, // the configuration of LSS
        reset,
    };
    enum class Trouble : std::uint8_t {
        numberTaken,
        numberStopped, // by a node that answers nothing, and may be there
        identityNotTold,
        isOther, // the one that answers is not the one that was read
        nobody,  // takes part in LSS
        several, // do
        refused, // with a code of LSS, or of SDO
        readBackOther,
        noAnswer, // to a write: whether it was carried out is not known
        notSent,
        cancelled,
    };
    enum class StepState : std::uint8_t { planned, now, done, failed, leftOut };
    // What became of one of the things that are written.
    enum class Fate : std::uint8_t { notTried, notDone, done, notKnown };

    explicit NodeSetup(const NodeSetupWish &wish);

    std::optional<Request> next(const CanopenSnapshot &bus) override;
    void answered(const LssOutcome &outcome) override;
    void answered(const SdoOutcome &outcome) override;
    void sent(CanFate fate) override;
    bool isEnded() const override { return m_at == m_steps.size(); }
    void cancel() override { m_isCancelled = true; }

    const NodeSetupWish &wish() const { return m_wish; }
    const std::vector<Step> &steps() const { return m_steps; }
    StepState stateOf(std::size_t step) const;
    const std::optional<Trouble> &trouble() const { return m_trouble; }
    std::uint8_t code() const { return m_code; }               // refused by LSS
    std::uint8_t codeOfMaker() const { return m_codeOfMaker; } // likewise
    std::uint32_t abortCode() const { return m_abortCode; }    // refused by SDO; 0: it was LSS
    Fate node() const { return m_node; }
    Fate rate() const { return m_rate; }
    Fate store() const { return m_store; }
    bool isReset() const { return m_isReset; }
    // It is not known to have left the configuration of LSS.
    bool mayStayInConfiguration() const { return m_mayStay; }
    // Nothing was written, and nothing is in doubt.
    bool isUntouched() const
    {
        return (m_node == Fate::notTried || m_node == Fate::notDone) &&
               (m_rate == Fate::notTried || m_rate == Fate::notDone) &&
               (m_store == Fate::notTried || m_store == Fate::notDone);
    }

private:
    Step step() const { return m_steps[m_at]; }
    std::optional<Request> requestOf(Step step, const CanopenSnapshot &bus);
    Request writeOf(Step step) const;
    Fate &fateOf(Step step) { return step == Step::node ? m_node : step == Step::rate ? m_rate : m_store; }
    void done();
    void fail(Trouble trouble);
    void takeSelection(const LssOutcome &outcome);
    void takeIdentity(const SdoOutcome &outcome);
    void takeWritten(LssOutcome::Kind kind);
    void takeNodeObject(const SdoOutcome &outcome);
    void takeReadBack(const SdoOutcome &outcome);
    void takeStored(const SdoOutcome &outcome);

    NodeSetupWish m_wish;
    std::vector<Step> m_steps;
    std::size_t m_at = 0;
    bool m_isAsked = false;
    bool m_isReadBack = false; // the object is, now
    bool m_isCancelled = false;
    LssSelection m_selection;
    IdentityReading m_identity;
    std::optional<Trouble> m_trouble{};
    std::optional<std::size_t> m_failedAt{};
    bool m_hasLeft = false; // the configuration of LSS, or has tried to
    std::uint8_t m_code = 0;
    std::uint8_t m_codeOfMaker = 0;
    std::uint32_t m_abortCode = 0;
    Fate m_node = Fate::notTried;
    Fate m_rate = Fate::notTried;
    Fate m_store = Fate::notTried;
    bool m_isReset = false;
    bool m_mayStay = false;
};

} // namespace codewheel::canopen
