// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "serial/serial_settings.h"
#include "vocabulary/instant.h"
#include "vocabulary/refusal.h"

#include <QByteArray>

namespace codewheel {

// Whether an adapter hands over bytes at once. Many collect them for up to 16 ms unless told not to, which
// halves the rate of position requests.
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

    // Opens the line with these settings, one that is open anew. Sends nothing. What was left in the receive
    // buffer is dropped. Once opened, it is only ever opened again at the same adapter: portOfOther if the
    // one there is not known to be the same.
    virtual Result<void> open(const SerialSettings &settings) = 0;
    virtual void close() = 0;
    // Another baud rate from now on; what was received before remains to be read.
    virtual Result<void> setBaudRate(int baudRate) = 0;

    // The adapter that open() refused is the right one.
    virtual void takeOtherAdapter() {}
    // As currently open. Any thread.
    virtual LowLatency lowLatency() const { return LowLatency::notApplicable; }

    // The time on the line's clock, which starts at 0 with the link and never goes back, whatever is closed
    // and opened again: real for a port, virtual for a simulated line.
    virtual Instant now() const = 0;
    // Lets time pass, even on a closed line; interrupt() ends it early.
    virtual void wait(Instant until) = 0;
    // Hands the bytes to the line, and returns once they are accepted, which is before they are all on the
    // wire.
    virtual Result<void> write(const QByteArray &bytes) = 0;
    // What came in, as soon as there is something; empty once `until` has passed or interrupt() was called.
    // On return now() is the time at which the last byte came in, as well as the link can tell.
    virtual Result<QByteArray> read(Instant until) = 0;
    // As known to the user: "/dev/ttyUSB0", "simulated line". Any thread.
    virtual QString name() const = 0;
    // Whether what answers is not real, and new with each start.
    virtual bool isSimulated() const { return false; }
    // Ends the current read or wait, or else the next one, early and empty; ends opening, where it blocks,
    // with a refusal of kind `stopped`. Any thread.
    virtual void interrupt() = 0;
};

} // namespace codewheel
