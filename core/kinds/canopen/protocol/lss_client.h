// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_link.h"
#include "kinds/canopen/protocol/lss.h"
#include "kinds/canopen/protocol/node_identity.h"

namespace codewheel::canopen {

struct LssRequest
{
    enum class Kind : std::uint8_t {
        configureAll, // everybody takes part: who else is there is not known
        operateAll,   // one without a number takes its new one
        select,       // the device with this identity
        inquireIdentity,
        inquireNode,
        setNode,
        setRate,  // a place in table 0 of CiA 305; place 5 means something only where the description says so
        activate, // the rate, after that many milliseconds, and silence for as long again
        store,
        fastScan, // finds a device without a number, and selects it
    };

    Kind kind = Kind::operateAll;
    NodeIdentity identity{}; // select
    int number = 0;          // setNode, setRate, activate; store: of the node, for the account of its EEPROM

    friend bool operator==(const LssRequest &, const LssRequest &) = default;
};

struct LssOutcome
{
    enum class Kind : std::uint8_t {
        done,
        refused,  // with a code
        noAnswer, // of a fast scan: there is none, or it was lost
        notSent,
    };

    Kind kind = Kind::noAnswer;
    std::uint8_t code = 0;        // 1: out of range, not supported; 2: storing failed; FFh: the maker's
    std::uint8_t codeOfMaker = 0; // with FFh
    NodeIdentity identity{};      // inquireIdentity, fastScan
    std::optional<int> node{};    // inquireNode; empty: it has none
    int extraAnswers = 0;         // since the outcome before: more than one device takes part
    bool isIncomplete = false;    // a fast scan that was answered, but not to its end

    friend bool operator==(const LssOutcome &, const LssOutcome &) = default;
};

struct LssTimes
{
    Instant answer = std::chrono::milliseconds(500);
    Instant store = std::chrono::seconds(5);
    Instant fastScan = std::chrono::milliseconds(100); // silence is an answer; 50 to 200 ms
    Instant pause = std::chrono::milliseconds(10);     // after what nobody answers

    friend bool operator==(const LssTimes &, const LssTimes &) = default;
};

// One LSS service at a time, with whoever listens (CiA 305). Nothing that writes is repeated. A fast scan is
// done once more, and more slowly, if it loses the device: an answer that was late or lost has counted as 1.
// A state machine without I/O.
class LssClient
{
public:
    explicit LssClient(const LssTimes &times = {});

    bool isBusy() const { return m_isBusy; }
    void begin(const LssRequest &request, Instant now); // while it is not busy
    // To be sent now, given once; acts on time-outs.
    std::optional<CanFrame> next(Instant now);
    // How many frames next() has given: the number of the last one.
    std::uint64_t given() const { return m_given; }
    // Of the frame with this number. Of one of an earlier request it says nothing that is waited for.
    void fate(std::uint64_t number, CanFate fate, Instant now);
    // Whether it is an LSS answer. Those that nobody waits for are counted.
    bool take(const CanFrame &frame, Instant now);
    std::optional<LssOutcome> takeOutcome() { return std::exchange(m_outcome, std::nullopt); }
    std::optional<Instant> wakesAt() const { return m_isBusy ? std::optional(m_dueAt) : std::nullopt; }
    void cancel() { m_isBusy = false; }

    // In one fast scan, of at most mostSteps.
    int step() const { return m_step; }
    static constexpr int mostSteps = 133;

private:
    LssFrame frameNow() const;
    LssFrame scanFrame() const;
    bool isAnswered() const;
    Instant timeOut() const;
    void silent(Instant now);
    void answered(const LssFrame &answer, Instant now);
    void scanned(bool isAnswered, Instant now);
    void lostInScan(Instant now);
    void goOn(int steps, Instant now);
    void end(LssOutcome::Kind kind);

    LssTimes m_times;
    LssRequest m_request{};
    bool m_isBusy = false;
    bool m_isWaiting = false;
    bool m_isScannedAgain = false;
    int m_step = 0; // frames done
    std::uint64_t m_given = 0;
    std::uint64_t m_givenBefore = 0; // this request
    Instant m_sentAt{};
    Instant m_dueAt{};
    LssOutcome m_result{}; // so far
    std::optional<LssOutcome> m_outcome{};
    int m_extraAnswers = 0;
};

} // namespace codewheel::canopen
