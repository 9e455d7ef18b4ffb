// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "kinds/canopen/protocol/object_value.h"
#include "kinds/canopen/protocol/sdo.h"

#include <optional>
#include <vector>

namespace codewheel {

// The object that a parameter is, or a bit of.
struct CanopenReach
{
    canopen::SdoObject object{};
    canopen::ObjectType type = canopen::ObjectType::u32;
    std::optional<unsigned> bit{}; // empty: all of it

    // What it has in the object's value.
    Value in(const Value &whole) const { return bit ? Value(whole.number() >> *bit & 1) : whole; }

    friend bool operator==(const CanopenReach &, const CanopenReach &) = default;
};

// Null: it is reached in another way, or not at all.
inline const CanopenReach *canopenReach(const ParameterDescription &parameter)
{
    return parameter.reach.as<CanopenReach>();
}

// A rate, and the number that stands for it.
struct NumberedRate
{
    int rate = 0; // Bd
    int number = 0;

    friend bool operator==(const NumberedRate &, const NumberedRate &) = default;
};

// What a description says of an encoder on CANopen beyond its parameters.
struct CanopenDevice
{
    bool isLinear = false;
    std::optional<std::uint32_t> vendor{};   // as 1018h:1 tells it; empty: of any make
    std::optional<std::uint32_t> product{};  // 1018h:2
    std::optional<std::uint32_t> revision{}; // 1018h:3
    std::optional<canopen::SdoObject>
        nodeNumber{}; // a maker's object, an u8, in force after storing and reset
    std::optional<canopen::SdoObject> rateObject{}; // likewise
    std::vector<NumberedRate> rates{}; // of the rateObject; without one, of LSS: more than CiA 305 has

    friend bool operator==(const CanopenDevice &, const CanopenDevice &) = default;
};

inline CanopenDevice canopenDevice(const DeviceDescription &device)
{
    const auto *its = device.ofKind.as<CanopenDevice>();
    return its != nullptr ? *its : CanopenDevice();
}

// What an object of this index means is the maker's business.
inline bool isMakers(canopen::SdoObject object)
{
    return object.index >= 0x2000 && object.index < 0x6000;
}

// Writing it does something else than giving a value, or may leave a device that answers no more: program
// control (1F50h on), restoring, storing, identifiers of SDO, position.
inline bool isNoValue(canopen::SdoObject object)
{
    const std::uint16_t index = object.index;
    return index == 0x1010 || index == 0x1011 || index == 0x1200 || index == 0x1280 || index == 0x6003 ||
           index == 0x6010 || (index >= 0x1F00 && index < 0x2000);
}

} // namespace codewheel
