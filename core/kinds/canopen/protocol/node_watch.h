// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/emcy.h"
#include "kinds/canopen/protocol/nmt.h"
#include "kinds/canopen/protocol/sdo.h"

#include <deque>
#include <vector>

namespace codewheel::canopen {

enum class Heartbeat : std::uint8_t {
    notHeard, // since the node has booted
    heard,    // with a time that is not known
    present,
    late, // by half of the time
    lost, // three times the time
};

// What one node shows by its frames, asked by nobody: NMT state, heartbeat, boot-up, EMCY, and whether two
// nodes have its number. Every frame on the bus goes through take(), with those that we send.
class NodeWatch
{
public:
    static constexpr std::size_t mostErrors = 64; // that are kept

    explicit NodeWatch(int node);
    // The link was lost: what the node does now is not known.
    void forget();

    int node() const { return m_node; }
    // As read from the node. Predefined until then.
    void setTpdos(std::vector<std::uint32_t> identifiers) { m_tpdos = std::move(identifiers); }
    // Object 1017h; 0: it has no heartbeat, empty: not known.
    void setProducerTime(std::optional<Instant> time, Instant now);
    const std::optional<Instant> &producerTime() const { return m_producerTime; }
    // While it stores or restores, a node may be silent.
    void setMayBeSilent(bool may, Instant now);

    void take(const CanFrame &frame, Instant now);

    // As the node has shown; empty: not known, as after a boot-up, behind which some start by themselves, or
    // after a command.
    std::optional<NmtState> state() const { return m_state; }
    // The last command to it, until the node shows its state.
    std::optional<NmtCommand> command() const { return m_command; }
    // That in which this command sends it; empty: in none, or it has shown its own since.
    std::optional<NmtState> commandedState() const;
    // It has reported, and neither shown its state nor been commanded since.
    bool hasBooted() const;
    // When the last PDO came; empty: none has since it was last otherwise than operational.
    const std::optional<Instant> &pdoAt() const { return m_pdoAt; }
    // It was last known as stopped, by what it told or by a command, and has shown nothing else since: it
    // answers nothing, and is there all the same.
    bool isStopped() const { return m_isStopped; }
    Heartbeat heartbeat(Instant now) const;
    // When the heartbeat will be late or lost, if none comes.
    std::optional<Instant> wakesAt(Instant now) const;
    int bootUps() const { return m_bootUps; }
    // Those behind which there was no reset: its supply was off.
    int unaskedBootUps() const { return m_unaskedBootUps; }
    // A command that the link has taken, and may tell only later that it has gone out.
    void mayBeReset(const NmtRequest &request, Instant at);

    const std::deque<Emcy> &errors() const { return m_errors; }      // that came, the last one at the end
    const std::vector<Emcy> &standing() const { return m_standing; } // that did not go yet

    // What one node alone does not do.
    int secondAnswers() const { return m_secondAnswers; } // more SDO answers than requests
    bool isDoubled() const; // its number, by answers, by heartbeats or by boot-ups

private:
    void takeCommand(const CanFrame &frame, Instant at);
    void takeErrorControl(const CanFrame &frame, Instant now);
    void takeBootUp(Instant at);
    bool isAskedFor(Instant bootUpAt) const;
    void isAtWork(Instant at);
    void takeBeat(const NodeState &told, std::optional<Instant> at, Instant now);
    void compareBeats(Instant at);
    void compareStates(NmtState state, Instant at);
    void takeTpdo(Instant at);
    void takeEmcy(const Emcy &emcy);
    void takeSdo(const CanFrame &frame, Instant at);
    void takeSdoAnswer(const CanFrame &frame, Instant at);
    void forgetUnanswered(Instant now);
    void hasAnswered(Instant askedAt);
    bool isSupervised() const { return m_producerTime.value_or(Instant()) > Instant() && !m_isGuarded; }

    struct Asked
    {
        std::optional<SdoObject> object; // empty: for a segment
        Instant at;
    };

    int m_node;
    std::vector<std::uint32_t> m_tpdos;
    std::optional<Instant> m_producerTime{};
    bool m_mayBeSilent = false;

    std::optional<NmtState> m_state{};
    std::optional<NmtCommand> m_command{};
    Instant m_commandAt{};
    bool m_isStopped = false;
    std::optional<Instant> m_pdoAt{};
    std::optional<Instant> m_countsFrom{}; // the last heartbeat, or the end of a silence
    std::deque<Instant> m_beats{};
    bool m_hasTooManyBeats = false;
    std::deque<std::pair<NmtState, Instant>> m_statesTold{}; // since the last command
    bool m_hasTwoStates = false;
    int m_bootUps = 0;
    int m_unaskedBootUps = 0;
    bool m_isResetUnderWay = false;      // until it reports
    std::optional<Instant> m_resetAt{};  // of any node: one whose number is new reports under another one
    std::optional<Instant> m_bootedAt{}; // since the last command
    bool m_hasTwoBootUps = false;
    bool m_isGuarded = false; // by another master
    std::deque<Emcy> m_errors{};
    std::vector<Emcy> m_standing{};
    std::deque<Asked> m_asked{}; // by SDO, not answered yet
    Instant m_answeredAt{};
    bool m_isAskingHeard = false; // requests, as well as answers
    bool m_isInBlocks = false;
    std::optional<SdoFrame> m_lastAnswer{}; // unless its object was asked for again
    int m_firstInARow = 0;
    int m_secondAnswers = 0;
    int m_secondInARow = 0;
    bool m_hasOtherAnswer = false; // than the first one to the same request
};

} // namespace codewheel::canopen
