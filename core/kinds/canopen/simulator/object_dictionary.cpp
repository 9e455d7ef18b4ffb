// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/simulator/object_dictionary.h"

#include <algorithm>

namespace codewheel::canopen {
namespace {

constexpr std::size_t longestText = 32;
constexpr std::uint16_t profileBegin = 0x2000;
constexpr std::uint16_t offsetObject = 0x6509; // kept although it cannot be written

std::uint32_t keyOf(const SdoObject &object)
{
    return std::uint32_t{object.index} << 8 | object.sub;
}

std::uint32_t placeOf(const SimulatedObject &object)
{
    return keyOf({object.index, object.sub});
}

bool isSigned(SimulatedObject::Type type)
{
    using enum SimulatedObject::Type;
    return type == i8 || type == i16 || type == i32;
}

std::int64_t numberFrom(Octets octets, SimulatedObject::Type type)
{
    const std::int64_t number = numberOf(octets);
    const std::int64_t beyond = std::int64_t{1} << 8 * octets.size();
    return isSigned(type) && number >= beyond / 2 ? number - beyond : number;
}

bool isKept(const SimulatedObject &object)
{
    return object.access == SimulatedObject::Access::readWrite || object.index == offsetObject;
}

} // namespace

std::size_t SimulatedObject::size() const
{
    switch (type) {
    case Type::u8:
    case Type::i8:
        return 1;
    case Type::u16:
    case Type::i16:
        return 2;
    case Type::u32:
    case Type::i32:
        return 4;
    case Type::text:
        break;
    }
    return text.size();
}

std::vector<std::uint8_t> SimulatedObject::octets() const
{
    if (type == Type::text)
        return {text.begin(), text.end()};
    std::vector<std::uint8_t> octets;
    for (std::size_t i = 0; i < size(); ++i)
        octets.push_back(static_cast<std::uint8_t>(value >> 8 * i));
    return octets;
}

ObjectDictionary::ObjectDictionary(std::vector<SimulatedObject> objects)
    : m_objects(std::move(objects))
{
    std::ranges::sort(m_objects, {}, placeOf);
    m_factory = m_objects;
}

const SimulatedObject *ObjectDictionary::find(SdoObject object) const
{
    const auto found = std::ranges::lower_bound(m_objects, keyOf(object), {}, placeOf);
    return found != m_objects.end() && placeOf(*found) == keyOf(object) ? &*found : nullptr;
}

SimulatedObject *ObjectDictionary::at(SdoObject object)
{
    const SimulatedObject *found = find(object);
    return found == nullptr ? nullptr : &m_objects[static_cast<std::size_t>(found - m_objects.data())];
}

std::int64_t ObjectDictionary::number(std::uint16_t index, std::uint8_t sub) const
{
    const SimulatedObject *object = find({index, sub});
    return object == nullptr ? 0 : object->value;
}

std::uint32_t ObjectDictionary::word(std::uint16_t index, std::uint8_t sub) const
{
    return static_cast<std::uint32_t>(number(index, sub));
}

void ObjectDictionary::set(std::uint16_t index, std::uint8_t sub, std::int64_t value)
{
    if (SimulatedObject *object = at({index, sub}))
        object->value = value;
}

tl::expected<std::vector<std::uint8_t>, AbortCode> ObjectDictionary::read(SdoObject object) const
{
    const SimulatedObject *found = find(object);
    if (found == nullptr)
        return tl::unexpected(find({object.index, 0}) == nullptr ? AbortCode::noObject
                                                                 : AbortCode::noSubindex);
    if (found->access == SimulatedObject::Access::writeOnly)
        return tl::unexpected(AbortCode::writeOnly);
    return found->octets();
}

tl::expected<SimulatedObject, AbortCode> ObjectDictionary::written(SdoObject object, Octets octets) const
{
    const SimulatedObject *found = find(object);
    if (found == nullptr)
        return tl::unexpected(find({object.index, 0}) == nullptr ? AbortCode::noObject
                                                                 : AbortCode::noSubindex);
    if (found->access == SimulatedObject::Access::readOnly)
        return tl::unexpected(AbortCode::readOnly);
    SimulatedObject with = *found;
    if (found->type == SimulatedObject::Type::text) {
        if (octets.size() > longestText)
            return tl::unexpected(AbortCode::tooLong);
        with.text.assign(octets.begin(), octets.end());
        return with;
    }
    if (octets.size() != found->size())
        return tl::unexpected(AbortCode::wrongLength);
    with.value = numberFrom(octets, found->type);
    if (found->range && with.value > found->range->high)
        return tl::unexpected(AbortCode::tooHigh);
    if (found->range && with.value < found->range->low)
        return tl::unexpected(AbortCode::tooLow);
    return with;
}

void ObjectDictionary::take(const SimulatedObject &object)
{
    if (SimulatedObject *own = at({object.index, object.sub})) {
        own->value = object.value;
        own->text = object.text;
    }
}

ObjectDictionary::Kept ObjectDictionary::kept(bool alsoAsDelivered) const
{
    Kept kept;
    for (std::size_t i = 0; i < m_objects.size(); ++i) {
        const SimulatedObject &now = m_objects[i];
        const bool isAsDelivered = now.value == m_factory[i].value && now.text == m_factory[i].text;
        if (isKept(now) && (alsoAsDelivered || !isAsDelivered))
            kept.push_back(now);
    }
    return kept;
}

void ObjectDictionary::load(const Kept &kept)
{
    for (const SimulatedObject &object : kept)
        take(object);
}

void ObjectDictionary::takeProfile(const ObjectDictionary &other)
{
    for (const SimulatedObject &object : other.m_objects)
        if (object.index >= profileBegin)
            take(object);
}

} // namespace codewheel::canopen
