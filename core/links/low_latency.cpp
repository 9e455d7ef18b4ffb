// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/low_latency.h"

#include <cerrno>
#include <linux/serial.h>
#include <sys/ioctl.h>

namespace codewheel {

LowLatency askForLowLatency(int port)
{
    serial_struct serial = {};
    if (::ioctl(port, TIOCGSERIAL, &serial) != 0)
        return lowLatencyOf(errno, 0);
    serial.flags |= ASYNC_LOW_LATENCY;
    return lowLatencyOf(0, ::ioctl(port, TIOCSSERIAL, &serial) == 0 ? 0 : errno);
}

LowLatency lowLatencyOf(int gettingError, int settingError)
{
    if (gettingError == ENOTTY)
        return LowLatency::notApplicable;
    return gettingError == 0 && settingError == 0 ? LowLatency::granted : LowLatency::refused;
}

} // namespace codewheel
