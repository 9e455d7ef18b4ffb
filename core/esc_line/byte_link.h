// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/instant.h"
#include "encoder/refusal.h"
#include "esc_line/serial_settings.h"

#include <QByteArray>

namespace codewheel {

// Whether an adapter hands over bytes at once. Many collect them for up to 16 ms unless they are asked not
// to, which halves the rate of position requests.
enum class LowLatency : std::uint8_t {
    granted,
    refused,
    notAsked,
    notApplicable, // no adapter: a pseudo terminal
};

// The contract of a link to a serial line: bytes out, bytes in, and the line's clock. Blocking, bounded by
// the deadline given; used by one thread, interrupt() by any. It knows nothing of what the bytes mean.
class ByteLink
{
public:
    virtual ~ByteLink() = default;

    // Opens the line with these settings. Sends nothing. What lay in the receive buffer from before is
    // dropped. Once it was open it is opened at the same adapter and at no other: portOfOther where there is
    // one that is not known to be the same.
    virtual Result<void> open(const SerialSettings &settings) = 0;
    virtual void close() = 0;
    // Another baud rate from now on; what was received before stays to be read.
    virtual Result<void> setBaudRate(int baudRate) = 0;

    // The adapter that open() refused is meant.
    virtual void takeOtherAdapter() {}
    // As it is open now. Any thread.
    virtual LowLatency lowLatency() const { return LowLatency::notApplicable; }

    // The time on the line's clock, which begins at 0 with the link and never goes back, whatever is closed
    // and opened again: real for a port, virtual for a simulated line.
    virtual Instant now() const = 0;
    // Lets time pass, on a closed line too; interrupt() ends it early.
    virtual void wait(Instant until) = 0;
    // Hands the bytes to the line, and returns when they were accepted, which is before they are all on the
    // wire.
    virtual Result<void> write(const QByteArray &bytes) = 0;
    // What came in, as soon as there is something; empty once `until` has passed or interrupt() was called.
    // On return now() is the time at which the last of the bytes came in, as well as the link can tell.
    virtual Result<QByteArray> read(Instant until) = 0;
    // As the user knows it: "/dev/ttyUSB0", "simulated line". Any thread.
    virtual QString name() const = 0;
    // Whether what answers is none of this world, and new with each start.
    virtual bool isSimulated() const { return false; }
    // Ends the read or wait under way, or else the next one, early and empty; opening, where it blocks, with
    // a refusal of kind `stopped`. Any thread.
    virtual void interrupt() = 0;
};

} // namespace codewheel
