// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/sdo.h"
#include "vocabulary/message.h"

#include <array>
#include <cstdint>
#include <optional>

namespace codewheel::canopen {

// An object that tells an identifier of a node, and what it tells where another one is predefined for the
// number of the node. Some makes keep stored ones when they get another number.
struct KeptIdentifier
{
    SdoObject object{};
    std::uint32_t identifier = 0;
    std::uint32_t predefined = 0;

    QString name() const; // "1014h:0 (EMCY)"
    Message message() const;

    friend bool operator==(const KeptIdentifier &, const KeptIdentifier &) = default;
};

// SYNC, EMCY, and the requests and answers of SDO. A node may have none of them.
inline constexpr std::array identifierObjects{SdoObject{0x1005, 0}, SdoObject{0x1014, 0},
                                              SdoObject{0x1200, 1}, SdoObject{0x1200, 2}};

inline constexpr std::array identifierObjectsOfTpdos{SdoObject{0x1800, 1}, SdoObject{0x1801, 1},
                                                     SdoObject{0x1802, 1}, SdoObject{0x1803, 1}};

// Of these; of a TPDO only one that is predefined for another number counts.
// Empty: it is as predefined, or is switched off.
std::optional<KeptIdentifier> keptIdentifier(SdoObject object, std::uint32_t told, int node);

} // namespace codewheel::canopen
