// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/kinds/canopen/canopen_access.h"
#include "kinds/canopen/protocol/object_value.h"

namespace codewheel {

// The node typed as PLACE, and the bus of the call that it is on. Refused for a place on another kind of bus.
struct NodeMeant
{
    CanopenAccess *bus = nullptr;
    Place place{};
    int node() const { return CanopenAddress::of(place.node).node; }
};
Checked<NodeMeant> nodeMeant(const Call &call, const QString &typed);
// The CAN bus of the call, which --bus names if there are several.
Checked<CanopenAccess *> canBusMeant(const Call &call);

// An object as typed, and what it is to become.
struct ObjectArgument
{
    canopen::SdoObject object{};
    std::optional<QString> value{}; // empty: none was given
    std::optional<canopen::ObjectType> type{};
    const ParameterDescription *parameter = nullptr; // that it is as a whole; null: none is described
};

// "6004", "1018:4", "1010:1=save": index in hexadecimal, subindex in decimal, or in hexadecimal as "Ah"; with
// --type. `device`: whose description may tell its name and type; null: not known.
Checked<ObjectArgument> objectArgument(const Call &call, const QString &typed,
                                       const DeviceDescription *device);
// The octets of its value; `width` is that of the object, 0: not known.
Checked<std::vector<std::uint8_t>> octetsFor(const ObjectArgument &argument, std::size_t width);

// "00001388h, 5000 (88 13 00 00)"
QString objectValueText(const ObjectArgument &argument, std::span<const std::uint8_t> octets,
                        bool isSizeTold);
QJsonObject objectValueJson(const ObjectArgument &argument, std::span<const std::uint8_t> octets,
                            bool isSizeTold);
QJsonObject objectJson(const ObjectArgument &argument);

} // namespace codewheel
