// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/instant.h"
#include "encoder/refusal.h"
#include "line/line_settings.h"

#include <QByteArray>

namespace codewheel {

// The contract of a link to a serial line: bytes out, bytes in, and the line's clock. Blocking, bounded by
// the deadline given; used by one thread, interrupt() by any. It knows nothing of what the bytes mean.
class ByteLink
{
public:
    virtual ~ByteLink() = default;

    // Opens the line with these settings. Sends nothing. What lay in the receive buffer from before is
    // dropped.
    virtual Result<void> open(const LineSettings &settings) = 0;
    virtual void close() = 0;
    // Another baud rate from now on; what was received before stays to be read.
    virtual Result<void> setBaudRate(int baudRate) = 0;

    // The time on the line's clock, which begins at 0 with open(): real for a port, virtual for a simulated
    // line.
    virtual Instant now() const = 0;
    // Hands the bytes to the line, and returns when they were accepted, which is before they are all on the
    // wire.
    virtual Result<void> write(const QByteArray &bytes) = 0;
    // What came in, as soon as there is something; empty once `until` has passed or interrupt() was called.
    // On return now() is the time at which the last of the bytes came in, as well as the link can tell.
    virtual Result<QByteArray> read(Instant until) = 0;
    // As the user knows it: "/dev/ttyUSB0", "simulated line".
    virtual QString name() const = 0;
    // Whether what answers is none of this world, and new with each start.
    virtual bool isSimulated() const { return false; }
    // Ends the read under way, or else the next one, early and empty. Any thread.
    virtual void interrupt() = 0;
};

} // namespace codewheel
