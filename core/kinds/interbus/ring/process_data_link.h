// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/data_check.h"
#include "kinds/interbus/gateway/gateway_refusals.h"
#include "kinds/interbus/ring/ring_device.h"
#include "kinds/interbus/ring/told_ring.h"
#include "vocabulary/instant.h"
#include "vocabulary/refusal.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace codewheel {

class EncoderSession;
class MasterLink;
struct LinkFigures;

// The contract of a link to a ring: one exchange of all process data is one bus cycle, and the ring's clock.
// Blocking, bounded by the link's time-out; used by one thread, interrupt() by any. Words are in ring order,
// one 32-bit word per device and direction (0 if a device has none).
class ProcessDataLink
{
public:
    virtual ~ProcessDataLink() = default;

    // Connects and finds the participants. Writes nothing to the peer. After close(), also opens a lost link
    // again.
    virtual Result<RingStructure> open() = 0;
    virtual void close() = 0;
    // The OUT words currently on the peer, to show them on connecting. Refused with outNotReadBack: the peer
    // does not tell them, but works.
    virtual Result<std::vector<Word>> readBackOut() = 0;
    // One cycle: out goes out, in is what came in during the same cycle (not yet the answer to out).
    // Refused with outNotOurs, and nothing sent, if somebody else has changed OUT on the peer.
    virtual Result<void> exchange(std::span<const Word> out, std::span<Word> in) = 0;
    // One cycle in Watch. Where the ring goes on without us (a gateway), nothing is sent, and `out` becomes
    // what is on the peer. A ring that needs our words to go on gets them as they stand.
    virtual Result<void> watch(std::span<Word> out, std::span<Word> in) { return exchange(out, in); }
    // Somebody asks for words to this device: where the peer does not tell its OUT, it is written from now
    // on.
    virtual void claimOut(std::size_t /*device*/) {}
    // Whether exchange() writes the word of this device. What was neither read back nor asked for is not
    // written.
    virtual bool writesOut(std::size_t /*device*/) const { return true; }
    // What became of zeros that were sent.
    struct ZerosSent
    {
        std::optional<bool> areThere{}; // read back on the peer; empty: that cannot be said
        QString notZero{};              // what was read back instead, and where
    };
    // One cycle that sends 00000000 to all devices, whatever is there.
    virtual Result<ZerosSent> sendZeros(std::span<Word> in)
    {
        const std::vector<Word> zeros(in.size());
        return exchange(zeros, in).map([] { return ZerosSent(); });
    }
    // sendZeros(), or open(), comes next: until then nothing is begun that would keep it waiting, a call that
    // blocks ends after the transaction under way, with a refusal of kind `stopped`. A link that never blocks
    // may ignore it. Any thread.
    virtual void hurryToZeros() {}
    // Sends 00000000 to all devices though nothing is heard of the peer: it may hear us. Opens the link for
    // that, and closes it. Whether anything went out; it is not known whether it arrived.
    virtual bool sendZerosUnheard() { return false; }
    // Where the peer has the OUT of each device: "register 4"; none: that says nothing. Any thread.
    virtual std::vector<QString> outPlaces() const { return {}; }
    // Its watchdog has set its outputs to 0 since nobody wrote for a while: they are to be written again.
    virtual Result<void> acknowledgeWatchdog()
    {
        return refuse(RefusalKind::notSupported, GatewayRefusalId::watchdogNotSet);
    }
    // What the peer says of its ring; empty: nothing.
    virtual std::optional<ToldRing> toldRing() const { return std::nullopt; }
    // How old the word is that the last cycle gave for this device, at the end of the cycle. Empty: the cycle
    // gave none, and `in` has that of an earlier one.
    virtual std::optional<Instant> age(std::size_t /*device*/) const { return Instant{}; }
    // False: that has been so for too long.
    virtual bool isUpToDate(std::size_t /*device*/) const { return true; }
    // Statistics, newly made now and then; null: it keeps none.
    virtual std::shared_ptr<const LinkFigures> figures() const { return nullptr; }
    // Whether the device can have sent this word; empty: words always come as they were sent. Any thread.
    virtual std::optional<DataCheck> checkWord(std::size_t /*device*/, Word /*in*/,
                                               const EncoderSession & /*encoder*/) const
    {
        return std::nullopt;
    }
    // Any thread: the time on the ring's clock, which starts at 0 with the link and never goes back, whatever
    // is closed and opened again: real for a link to hardware, virtual for a simulated ring, where it passes
    // only in wait().
    virtual Instant now() const = 0;
    // Lets time pass, even on a closed link, no longer than until the next cycle is due.
    virtual void wait(Instant until) = 0;
    // Whether it is. A link with a pace of its own may be driven by turns that are shorter than its cycles.
    virtual bool isDue() const { return true; }
    // Whether each word given to exchange() goes out in that one bus cycle and in no other. A gateway that
    // runs the ring by itself repeats a word until it gets the next one.
    virtual bool boundsWordsToCycles() const = 0;
    // Whether its encoders are not real, and new with each start: what is written to them is not kept
    // (app/journal_files.h). What is written to those of a real link is.
    virtual bool isSimulated() const { return false; }
    // Whether open() finds the participants on the ring. A gateway has no ID cycle: they are what it was
    // told.
    virtual bool findsDevices() const { return true; }
    // Ends the current blocking call, or else the next one, early with a refusal of kind `stopped`: the cycle
    // is skipped, the link has not failed. A link that never blocks may ignore it. Any thread.
    virtual void interrupt() = 0;
    // The services of the ring's master; null if the link reaches only the process data. It lives as long as
    // the link, and is used by the thread that exchanges.
    virtual MasterLink *master() { return nullptr; }
};

// The words that are not 00000000, and where the peer has them: "1.0 20210001 (register 0), 3.0 40000000
// (register 4)". Empty: all are.
QString wordsNotZero(const ProcessDataLink &link, const RingStructure &ring, std::span<const Word> out);

} // namespace codewheel
