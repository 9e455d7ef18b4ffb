// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"
#include "kinds/canopen/driver/cia406_driver.h"

#include <deque>
#include <map>
#include <string>
#include <vector>

namespace codewheel::canopen {

// A driver with a dictionary of octets instead of a node, in virtual time. What it is asked is logged as
// "6001:0" for a read, "6001:0 88 13 00 00" for a write, "NMT 80" for a command.
class DriverBench
{
public:
    enum class Fate : std::uint8_t {
        lost,       // the request never arrived
        unanswered, // it was executed, and its answer never arrived
        notSent,
    };

    explicit DriverBench(QStringView device = u"canopen-406-multi-turn");
    explicit DriverBench(const DeviceDescription &described);

    const DeviceDescription device;
    Cia406Driver driver;

    std::map<std::string, std::vector<std::uint8_t>>
        has;                                      // "6001:0"; what is not in it, the node does not have
    std::map<std::string, std::uint32_t> refuses; // writes of these, with this abort code
    bool refusesWhileRunning = false;             // 08000022h
    bool isRunning = false;
    bool ignoresPresets = false; // accepts them
    bool bootsAfterReset = true;
    std::optional<std::uint8_t> showsAfterStart = 0x05; // by its heartbeat

    // The next request with this text meets this fate.
    void next(const std::string &text, Fate fate) { m_next[text].push_back(fate); }

    // Of the requests that are not polled, the one with this number in the log, from 0.
    std::optional<std::pair<std::size_t, Fate>> fateOfJobRequest;

    Instant now{};
    void run(Instant duration);
    void settle(); // until it knows what it wants to know, and its state; clears the log
    Result<void> begin(const Job &job, Pace pace = Pace::byItself);
    // Runs the job to its end; by hand, or where it gets no further, as far as it gets.
    const Outcome &finish(const Job &job, Pace pace = Pace::byItself);
    const Outcome &finish();
    // One request and its answer, or the time until the next one, but not beyond `end`.
    void step(Instant end = Instant::max());
    void hear(std::uint32_t id, const std::vector<std::uint8_t> &data);

    std::vector<std::string> log;
    std::vector<std::string> jobLog() const; // without what is polled
    std::optional<Outcome> outcome;
    Progress progress;
    std::vector<Message> messages;
    std::map<Parameter, Known> known;
    std::vector<KnownCams> cams;
    int eepromWrites = 0;
    int countOf(MessageCode id) const;
    std::optional<std::int64_t> value(Parameter parameter) const;
    std::optional<Kept> kept(Parameter parameter) const;
    std::optional<RefusalCode> refusal() const; // of the outcome

private:
    SdoOutcome answerTo(const SdoRequest &request, const std::string &text);
    SdoOutcome answerTo(const NmtRequest &request);
    std::optional<Fate> fateOf(const std::string &text);
    SdoOutcome execute(const SdoRequest &request, const std::string &object);
    void collect();

    std::map<std::string, std::deque<Fate>> m_next;
    JobId m_job = 0;
};

} // namespace codewheel::canopen
