// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_log_fault.h"

#include "vocabulary/enumeration_rows.h"

#include <QCoreApplication>

#include <array>

namespace codewheel {
namespace {

struct CanLogFaultRow
{
    CanLogFault fault;
    const char *text;
};

constexpr std::array canLogFaultRows{
    CanLogFaultRow{CanLogFault::notOfALog, QT_TRANSLATE_NOOP("CanLog", "This is no line of a CAN log.")},
    CanLogFaultRow{CanLogFault::badTime, QT_TRANSLATE_NOOP("CanLog", "Its time cannot be read.")},
    CanLogFaultRow{CanLogFault::badIdentifier,
                   QT_TRANSLATE_NOOP("CanLog", "Its identifier is none: 11 bits have up to 7FF, written with "
                                               "three digits, 29 bits up to 1FFFFFFF.")},
    CanLogFaultRow{CanLogFault::badData, QT_TRANSLATE_NOOP("CanLog", "Its data cannot be read.")},
    CanLogFaultRow{CanLogFault::wrongLength,
                   QT_TRANSLATE_NOOP("CanLog", "It has more or fewer bytes than it says, or more than 8.")},
    CanLogFaultRow{CanLogFault::tooLong, QT_TRANSLATE_NOOP("CanLog", "It is too long for a CAN log.")},
    CanLogFaultRow{CanLogFault::canFd,
                   QT_TRANSLATE_NOOP("CanLog", "A CAN FD frame: it is counted, and not read.")},
    CanLogFaultRow{CanLogFault::canXl, QT_TRANSLATE_NOOP("CanLog", "A CAN XL frame: it is not read.")},
    CanLogFaultRow{CanLogFault::badDirection,
                   QT_TRANSLATE_NOOP("CanLog", "It looks like a frame, but its direction is not known.")},
    CanLogFaultRow{CanLogFault::badDate,
                   QT_TRANSLATE_NOOP("CanLog", "Its date cannot be read: the log counts as one without it.")},
    CanLogFaultRow{CanLogFault::otherTime,
                   QT_TRANSLATE_NOOP("CanLog", "Its time is of another kind than the "
                                               "log's: its frame is kept without it.")},
};
static_assert(areInOrder(canLogFaultRows, &CanLogFaultRow::fault, CanLogFault::otherTime));

} // namespace

QString canLogFaultText(CanLogFault fault)
{
    return QCoreApplication::translate("CanLog", canLogFaultRows[static_cast<std::size_t>(fault)].text);
}

} // namespace codewheel
