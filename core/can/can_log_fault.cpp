// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_log_fault.h"

#include "vocabulary/enumeration_rows.h"

#include <QCoreApplication>

#include <array>

namespace codewheel {
namespace {

constexpr auto canLogFaultRows = std::to_array<TextOf<CanLogFault>>({
    {CanLogFault::notOfALog, QT_TRANSLATE_NOOP("CanLog", "This is no line of a CAN log.")},
    {CanLogFault::badTime, QT_TRANSLATE_NOOP("CanLog", "Its time cannot be read.")},
    {CanLogFault::badIdentifier,
     QT_TRANSLATE_NOOP("CanLog", "Its identifier is none: 11 bits have up to 7FF, written with "
                                 "three digits, 29 bits up to 1FFFFFFF.")},
    {CanLogFault::badData, QT_TRANSLATE_NOOP("CanLog", "Its data cannot be read.")},
    {CanLogFault::wrongLength,
     QT_TRANSLATE_NOOP("CanLog", "It has more or fewer bytes than it says, or more than 8.")},
    {CanLogFault::tooLong, QT_TRANSLATE_NOOP("CanLog", "It is too long for a CAN log.")},
    {CanLogFault::canFd, QT_TRANSLATE_NOOP("CanLog", "A CAN FD frame: it is counted, and not read.")},
    {CanLogFault::canXl, QT_TRANSLATE_NOOP("CanLog", "A CAN XL frame: it is not read.")},
    {CanLogFault::badDirection,
     QT_TRANSLATE_NOOP("CanLog", "It looks like a frame, but its direction is not known.")},
    {CanLogFault::badDate,
     QT_TRANSLATE_NOOP("CanLog", "Its date cannot be read: the log counts as one without it.")},
    {CanLogFault::otherTime, QT_TRANSLATE_NOOP("CanLog", "Its time is of another kind than the "
                                                         "log's: its frame is kept without it.")},
});
static_assert(areInOrder(canLogFaultRows, &TextOf<CanLogFault>::id, CanLogFault::otherTime));

} // namespace

QString canLogFaultText(CanLogFault fault)
{
    return QCoreApplication::translate("CanLog", rowOf(canLogFaultRows, fault).text);
}

} // namespace codewheel
