// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"
#include "kinds/esc/driver/esc_driver.h"

#include <deque>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace codewheel {

// A driver with a made-up encoder that follows the manual's two tables, in virtual time. Its next answers can
// be given as they are on the wire, so that tests can be compared with the manual.
class EscBench
{
public:
    enum class Fate : std::uint8_t {
        lost,       // the request never arrived
        unanswered, // it was executed, and its answer never arrived
    };

    explicit EscBench(EscSettings settings = {}, EscLineAddress address = {3},
                      QStringView device = u"kuebler-esc-rs485");

    EscDriver driver;

    // The encoder's values by the letters that read them: "D" -> "2000". May be changed at any time.
    std::map<std::string, std::string> has;
    EscLineAddress address{3};
    int baudRate = 19200;
    bool isOn = true;
    bool readsAddressAsDecimal = false;
    std::function<std::uint32_t(Instant)> position; // instead of has["P"]

    // The next requests with these letters get this answer, or this fate, whatever the encoder has.
    void answerNext(const std::string &letters, const std::string &answer);
    void next(const std::string &letters, Fate fate);
    void always(const std::string &letters, Fate fate) { m_always[letters] = fate; }

    Instant now{};
    void run(Instant duration);
    void settle(); // until first contact and identification are over; clears the log
    // Runs the job to its end. By hand: as far as it gets.
    const Outcome &finish(const Job &job, Pace pace = Pace::byItself);
    Result<void> begin(const Job &job, Pace pace = Pace::byItself);
    void step(); // one request and its answer, or the time until the next one
    void runUntil(const std::function<bool()> &isReached);
    // Answers everything before the first request with this command, which has gone out on return.
    esc::Request goOnTo(esc::Command command);

    std::vector<std::string> log;      // all requests, between ESC and CR LF
    std::vector<Instant> times;        // when they were sent
    std::vector<std::string> jobLog(); // without P, E and A
    int count(const std::string &letters) const;

    std::optional<Outcome> outcome;
    Progress progress;
    std::vector<Message> messages;
    std::map<Parameter, Known> known;
    int eepromWrites = 0;
    int countOf(MessageCode id) const;
    std::optional<std::int64_t> value(Parameter parameter) const;

private:
    esc::ExchangeResult exchange(const esc::Request &request);
    esc::ExchangeResult answerTo(const esc::Request &request);
    std::string execute(const esc::Request &request);
    void collect();

    std::map<std::string, std::deque<std::variant<std::string, Fate>>> m_next;
    std::map<std::string, Fate> m_always;
    JobId m_job = 0;
};

std::string lettersOf(const std::string &line);

} // namespace codewheel
