// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/sdo.h"
#include "kinds/canopen/simulator/abort_code.h"

#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace codewheel::canopen {

// An object of a simulated node, and what is in it.
struct SimulatedObject
{
    enum class Type : std::uint8_t { u8, u16, u32, i8, i16, i32, text };
    enum class Access : std::uint8_t { readOnly, writeOnly, readWrite };
    struct Range
    {
        std::int64_t low = 0;
        std::int64_t high = 0;
    };

    std::uint16_t index = 0;
    std::uint8_t sub = 0;
    Type type = Type::u32;
    Access access = Access::readOnly;
    std::int64_t value = 0;
    std::optional<Range> range{}; // empty: that of its type
    bool isMappable = false;      // into a PDO of the node
    std::string text{};

    std::size_t size() const; // octets
    std::vector<std::uint8_t> octets() const;
};

// The objects of a simulated node, and what reading and writing them is answered with.
class ObjectDictionary
{
public:
    // What is stored of a node: the objects that are not as delivered.
    using Kept = std::vector<SimulatedObject>;

    explicit ObjectDictionary(std::vector<SimulatedObject> objects);

    const SimulatedObject *find(SdoObject object) const;                  // null: there is none
    std::int64_t number(std::uint16_t index, std::uint8_t sub = 0) const; // 0: there is none
    std::uint32_t word(std::uint16_t index, std::uint8_t sub = 0) const;
    // By the node itself, whatever its access; one that it does not have is left out.
    void set(std::uint16_t index, std::uint8_t sub, std::int64_t value);

    tl::expected<std::vector<std::uint8_t>, AbortCode> read(SdoObject object) const;
    // What would be in it.
    tl::expected<SimulatedObject, AbortCode> written(SdoObject object, Octets octets) const;
    void take(const SimulatedObject &object);

    Kept kept(bool alsoAsDelivered) const;
    void load(const Kept &kept);
    // All but the area of communication, 1xxxh, as another has it.
    void takeProfile(const ObjectDictionary &other);

private:
    SimulatedObject *at(SdoObject object);

    std::vector<SimulatedObject> m_objects; // in order
    std::vector<SimulatedObject> m_factory;
};

} // namespace codewheel::canopen
