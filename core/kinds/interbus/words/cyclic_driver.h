// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/event.h"

namespace codewheel {

// How one kind of cyclic device is driven: a state machine from words to jobs and back. Does no I/O and asks
// no clock; the same object runs under the simulator, a gateway, a table of words in a test and a fuzzer. Bus
// thread only.
class CyclicDriver
{
public:
    virtual ~CyclicDriver() = default;

    virtual const Reading &reading() const = 0;
    virtual bool busy() const = 0;

    // What is known of the encoder from elsewhere (told, or known from earlier), so that positions can be
    // decoded.
    virtual void setKnown(const std::vector<Known> &known) = 0;

    // It was out of sight, and may be another one by now: nothing is known of it, not even its mode. No job
    // is running.
    virtual void forget() { setKnown({}); }

    // The link may show a word of which one half is that of the word before.
    virtual void expectTornWords() {}

    // Accepts the job or says why not; nothing is sent before the next cycle. `in` and `out` are the words of
    // the last one.
    virtual Result<void> begin(JobId id, const Job &job, Pace pace, Word in, Word out, Instant now) = 0;
    virtual void proceed() = 0; // Pace::byHand: send the next word
    virtual void cancel(OnCancel how, Instant now) = 0;
    // ALARM STOP, bus stopped, link lost: the job ends where it is, and its outcome says what is in doubt
    // then.
    virtual void stop(const Refusal &why, Instant now) = 0;

    // Whether what comes into OUT from now on is of others, since this program sends nothing: they spend
    // their own EEPROM writes.
    virtual void setOthersWrite(bool /*on*/) {}

    // What stands in OUT may not be seen to leave it for long: the bus is being stopped. No job is running.
    virtual void leaveStanding() {}

    // The link is lost, and no job is running: nobody sees any more what becomes of `out`, which is in OUT or
    // on its way there. What it may change, or words before it, is not known from now on, and reported as in
    // doubt.
    virtual void loseSight(Word /*out*/) {}

    // Once per bus cycle: `in` came in while `out` was on the bus. Returns what OUT shall be in the next
    // cycle: `out` itself unless a job wants something else.
    virtual Word cycle(Word in, Word out, Instant now) = 0;

    // `out` has gone out, and what came in meanwhile cannot be believed: instead of cycle().
    virtual void wait(Word /*out*/) {}

    // False: the encoder acts on this word anew in every cycle, so it must not stay in OUT.
    virtual bool mayStand(Word /*out*/) const { return true; }

    // What happened since the last call, oldest first.
    virtual std::vector<Event> takeEvents() = 0;
};

} // namespace codewheel
