// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_frame.h"
#include "vocabulary/refusal.h"

#include <QString>

#include <vector>

namespace codewheel {

// What a controller says of the bus (ISO 11898-1, fault confinement).
enum class CanState : std::uint8_t {
    active,
    warning, // a counter is at 96 or above
    passive, // at 128 or above
    busOff,  // it takes part no more until it is opened again
    notKnown,
};

struct CanStatus
{
    CanState state = CanState::notKnown;
    std::optional<int> transmitErrors{}; // the counters; empty: not told
    std::optional<int> receiveErrors{};
    std::optional<int> rate{};         // Bd; empty: not told
    std::optional<bool> listensOnly{}; // it acknowledges nothing; empty: not told

    friend bool operator==(const CanStatus &, const CanStatus &) = default;
};

enum class CanUse : std::uint8_t {
    watch,   // no frame goes out, nor an acknowledgement if the adapter can do without
    operate, // frames may be sent
};

// What became of a frame that send() has taken.
enum class CanFate : std::uint8_t {
    done,     // on the bus, and acknowledged by somebody there
    refused,  // not sent
    notKnown, // the adapter does not say
};

// What has happened since the last call.
struct CanNews
{
    std::vector<CanFrame> frames; // received, error frames among them; their time is that of the link's clock
    std::vector<CanFate> fates;   // of what was sent, in that order
};

// The contract of a link to a CAN bus: frames out, frames in, and its clock. Blocking, bounded by the
// deadline given; used by one thread, interrupt() by any. It knows nothing of what the frames mean.
class CanLink
{
public:
    virtual ~CanLink() = default;

    // Opens the bus for this use, one that is open anew, and then clears bus off. Sends no frame. What was
    // left to be received is dropped. Refused with canWatchNotSure: the adapter cannot be kept, or is not
    // known to be kept, from acknowledging frames; it is opened so only after takeUnsureWatch().
    virtual Result<void> open(CanUse use) = 0;
    virtual void close() = 0;
    // The user agrees that watching may acknowledge frames.
    virtual void takeUnsureWatch() {}

    // The time on the bus's clock, which starts at 0 with the link and never goes back, whatever is closed
    // and opened again: real for an adapter, virtual for a simulated bus.
    virtual Instant now() const = 0;
    // Lets time pass, even on a closed bus; interrupt() ends it early.
    virtual void wait(Instant until) = 0;
    // What came in and what became of what was sent, as soon as there is any of it; empty once `until` has
    // passed or interrupt() was called. Refused where the adapter is gone.
    virtual Result<CanNews> receive(Instant until) = 0;
    // Hands a frame to the adapter. False: its queue is full, to be tried again after receive(). Its fate
    // follows.
    virtual Result<bool> send(const CanFrame &frame) = 0;
    // As last told by the adapter.
    virtual CanStatus status() const = 0;
    // What is to be said of an open link, though it is no reason against it: its rate may be another.
    virtual std::optional<Refusal> remark() const { return std::nullopt; }
    // As known to the user: "can0", "/dev/ttyACM0", "simulated bus". Any thread.
    virtual QString name() const = 0;
    // Whether what answers is not real, and new with each start.
    virtual bool isSimulated() const { return false; }
    // Ends the current receive or wait, or else the next one, early; ends opening, where it blocks, with a
    // refusal of kind `stopped`: open() goes on with it then, and close() gives it up. Any thread.
    virtual void interrupt() = 0;
};

} // namespace codewheel
