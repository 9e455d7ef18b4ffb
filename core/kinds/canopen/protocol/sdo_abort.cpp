// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/sdo_abort.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace codewheel::canopen {
namespace {

struct SdoAbort
{
    std::uint32_t code;
    const char *text;
};

constexpr std::array sdoAborts{
    SdoAbort{0x0503'0000, QT_TRANSLATE_NOOP("CanopenSdoAbort", "The toggle bit did not change.")},
    SdoAbort{0x0504'0000, QT_TRANSLATE_NOOP("CanopenSdoAbort", "The transfer timed out.")},
    SdoAbort{0x0504'0001, QT_TRANSLATE_NOOP("CanopenSdoAbort", "The command is not known.")},
    SdoAbort{0x0504'0002, QT_TRANSLATE_NOOP("CanopenSdoAbort", "The block size is not allowed.")},
    SdoAbort{0x0504'0003, QT_TRANSLATE_NOOP("CanopenSdoAbort", "The number of a block is wrong.")},
    SdoAbort{0x0504'0004, QT_TRANSLATE_NOOP("CanopenSdoAbort", "The check sum is wrong.")},
    SdoAbort{0x0504'0005, QT_TRANSLATE_NOOP("CanopenSdoAbort", "There is not enough memory.")},
    SdoAbort{0x0601'0000, QT_TRANSLATE_NOOP("CanopenSdoAbort", "The object cannot be accessed like this.")},
    SdoAbort{0x0601'0001, QT_TRANSLATE_NOOP("CanopenSdoAbort", "The object can only be written.")},
    SdoAbort{0x0601'0002, QT_TRANSLATE_NOOP("CanopenSdoAbort", "The object can only be read.")},
    SdoAbort{0x0602'0000, QT_TRANSLATE_NOOP("CanopenSdoAbort", "There is no such object.")},
    SdoAbort{0x0604'0041, QT_TRANSLATE_NOOP("CanopenSdoAbort", "The object cannot be mapped into a PDO.")},
    SdoAbort{0x0604'0042, QT_TRANSLATE_NOOP("CanopenSdoAbort", "The PDO would become too long.")},
    SdoAbort{0x0604'0043, QT_TRANSLATE_NOOP("CanopenSdoAbort", "The parameters do not fit each other.")},
    SdoAbort{0x0604'0047, QT_TRANSLATE_NOOP("CanopenSdoAbort", "The device is at odds with itself.")},
    SdoAbort{0x0606'0000, QT_TRANSLATE_NOOP("CanopenSdoAbort", "The hardware of the device failed.")},
    SdoAbort{0x0607'0010, QT_TRANSLATE_NOOP("CanopenSdoAbort", "Type or length of the value is wrong.")},
    SdoAbort{0x0607'0012, QT_TRANSLATE_NOOP("CanopenSdoAbort", "The value is too long.")},
    SdoAbort{0x0607'0013, QT_TRANSLATE_NOOP("CanopenSdoAbort", "The value is too short.")},
    SdoAbort{0x0609'0011, QT_TRANSLATE_NOOP("CanopenSdoAbort", "There is no such subindex.")},
    SdoAbort{0x0609'0030, QT_TRANSLATE_NOOP("CanopenSdoAbort", "The value is out of range.")},
    SdoAbort{0x0609'0031, QT_TRANSLATE_NOOP("CanopenSdoAbort", "The value is too high.")},
    SdoAbort{0x0609'0032, QT_TRANSLATE_NOOP("CanopenSdoAbort", "The value is too low.")},
    SdoAbort{0x0609'0036, QT_TRANSLATE_NOOP("CanopenSdoAbort", "The maximum is below the minimum.")},
    SdoAbort{0x060A'0023, QT_TRANSLATE_NOOP("CanopenSdoAbort", "A resource is not available.")},
    SdoAbort{0x0800'0000, QT_TRANSLATE_NOOP("CanopenSdoAbort", "The device reports an error.")},
    SdoAbort{0x0800'0020, QT_TRANSLATE_NOOP("CanopenSdoAbort", "The value cannot be transferred or stored.")},
    SdoAbort{0x0800'0021,
             QT_TRANSLATE_NOOP("CanopenSdoAbort",
                               "The value cannot be transferred or stored: the device is operated locally.")},
    SdoAbort{
        0x0800'0022,
        QT_TRANSLATE_NOOP("CanopenSdoAbort",
                          "The value cannot be transferred or stored in the present state of the device.")},
    SdoAbort{0x0800'0023,
             QT_TRANSLATE_NOOP("CanopenSdoAbort", "The object dictionary is missing or could not be made.")},
    SdoAbort{0x0800'0024, QT_TRANSLATE_NOOP("CanopenSdoAbort", "There are no data.")},
};

} // namespace

QString sdoAbortText(std::uint32_t code)
{
    const auto found = std::ranges::find(sdoAborts, code, &SdoAbort::code);
    return found == sdoAborts.end() ? QString() : QCoreApplication::translate("CanopenSdoAbort", found->text);
}

bool isMissing(const SdoOutcome &outcome)
{
    constexpr std::uint32_t noObject = 0x0602'0000;
    constexpr std::uint32_t noSubindex = 0x0609'0011;
    return outcome.kind == SdoOutcome::Kind::aborted &&
           (outcome.abortCode == noObject || outcome.abortCode == noSubindex);
}

} // namespace codewheel::canopen
