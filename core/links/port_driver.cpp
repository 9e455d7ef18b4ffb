// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/port_driver.h"

// The kernel's own header: <termios.h>, which cannot be included beside it, has no rates of one's own.
#include <asm/termbits.h>
#include <cerrno>
#include <linux/serial.h>
#include <sys/ioctl.h>

namespace codewheel {

bool setLineRate(int port, int baudRate)
{
    constexpr int tolerance = 50; // 1/50: a character is still read right
    termios2 settings = {};
    if (::ioctl(port, TCGETS2, &settings) != 0)
        return false;
    if (static_cast<int>(settings.c_ospeed) == baudRate)
        return true; // by a constant, which every driver knows
    settings.c_cflag = (settings.c_cflag & ~static_cast<tcflag_t>(CBAUD)) | BOTHER;
    settings.c_ispeed = static_cast<speed_t>(baudRate);
    settings.c_ospeed = static_cast<speed_t>(baudRate);
    if (::ioctl(port, TCSETS2, &settings) != 0 || ::ioctl(port, TCGETS2, &settings) != 0)
        return false;
    const int difference = static_cast<int>(settings.c_ospeed) - baudRate;
    return difference <= baudRate / tolerance && -difference <= baudRate / tolerance;
}

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
