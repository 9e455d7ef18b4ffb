// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/pdo_mapping.h"

#include <algorithm>

namespace codewheel::canopen {
namespace {

enum SettingsSub : std::uint8_t { identifierSub = 1, typeSub = 2, inhibitSub = 3, eventTimerSub = 5 };

constexpr std::uint32_t offBit = 0x8000'0000;
constexpr std::uint32_t extendedBit = 0x2000'0000;
constexpr int longestEntry = 64;
constexpr int bitsOfOctet = 8;

PdoEntry entryOf(std::uint32_t told, int firstBit)
{
    return {.object = {.index = static_cast<std::uint16_t>(told >> 16),
                       .sub = static_cast<std::uint8_t>(told >> bitsOfOctet)},
            .bits = static_cast<int>(told & 0xFF),
            .firstBit = firstBit};
}

// All data as one number: the first bit of the PDO is the lowest one.
std::uint64_t bitsOf(Octets data, const PdoEntry &entry)
{
    std::uint64_t all = 0;
    for (auto octet = data.rbegin(); octet != data.rend(); ++octet)
        all = all << bitsOfOctet | *octet;
    all >>= entry.firstBit;
    return entry.bits == longestEntry ? all : all & ((std::uint64_t{1} << entry.bits) - 1);
}

std::int64_t withSign(std::uint64_t raw, int bits)
{
    const int unused = longestEntry - bits;
    return static_cast<std::int64_t>(raw << unused) >> unused;
}

bool fits(const PdoEntry &entry, const PdoType &type)
{
    return entry.bits > 0 && entry.firstBit + entry.bits <= longestEntry &&
           (entry.isDummy() || type.bits.value_or(entry.bits) == entry.bits);
}

} // namespace

PdoMapping::PdoMapping(int number)
    : m_number(number)
{
    lookForMissing();
}

SdoObject PdoMapping::settingsObject(int sub) const
{
    return {static_cast<std::uint16_t>(0x1800 + m_number - 1), static_cast<std::uint8_t>(sub)};
}

SdoObject PdoMapping::mappingObject(int sub) const
{
    return {static_cast<std::uint16_t>(0x1A00 + m_number - 1), static_cast<std::uint8_t>(sub)};
}

void PdoMapping::lookForMissing()
{
    m_missing.clear();
    const auto want = [&](const SdoObject &object) {
        if (told(object) == nullptr)
            m_missing.push_back(object);
    };
    for (const int sub : {identifierSub, typeSub, inhibitSub, eventTimerSub})
        want(settingsObject(sub));
    for (int sub = 0; sub <= count(); ++sub)
        want(mappingObject(sub));
}

bool PdoMapping::take(const SdoObject &object, Octets value)
{
    if (object.index != settingsObject(0).index && object.index != mappingObject(0).index)
        return false;
    std::erase_if(m_told, [&](const Told &each) { return each.object == object; });
    const Octets octets = value.first(std::min(value.size(), sizeof(std::uint32_t)));
    m_told.push_back({object, octets.empty() ? std::nullopt : std::optional(numberOf(octets))});
    m_identifier = number(settingsObject(identifierSub));
    place();
    lookForMissing();
    return true;
}

std::optional<std::uint32_t> PdoMapping::number(const SdoObject &object) const
{
    const Told *found = told(object);
    return found == nullptr ? std::nullopt : found->number;
}

// More than can be mapped stands for a PDO of another kind (FEh, FFh: multiplexed).
int PdoMapping::count() const
{
    const auto entries = static_cast<int>(number(mappingObject(0)).value_or(0) & 0xFF);
    return entries <= mostEntries ? entries : 0;
}

void PdoMapping::place()
{
    m_entries.clear();
    m_hasAllEntries = false;
    int firstBit = 0;
    for (int sub = 1; sub <= count(); ++sub) {
        const auto entry = number(mappingObject(sub));
        if (!entry)
            return;
        m_entries.push_back(entryOf(*entry, firstBit));
        firstBit += m_entries.back().bits;
    }
    m_hasAllEntries = !m_entries.empty();
}

bool PdoMapping::holds(const SdoObject &object) const
{
    return std::ranges::find(m_entries, object, &PdoEntry::object) != m_entries.end();
}

bool PdoMapping::isOff() const
{
    return (m_identifier.value_or(offBit) & offBit) != 0;
}

bool PdoMapping::isExtended() const
{
    return (m_identifier.value_or(0) & extendedBit) != 0;
}

std::uint32_t PdoMapping::identifier() const
{
    return m_identifier.value_or(0) & (isExtended() ? largestExtendedId : largestStandardId);
}

std::optional<int> PdoMapping::type() const
{
    const auto type = number(settingsObject(typeSub));
    return type ? std::optional(static_cast<int>(*type & 0xFF)) : std::nullopt;
}

std::optional<Instant> PdoMapping::inhibitTime() const
{
    const auto time = number(settingsObject(inhibitSub));
    return time ? std::optional(Instant(100) * (*time & 0xFFFF)) : std::nullopt;
}

std::optional<Instant> PdoMapping::eventTimer() const
{
    const auto time = number(settingsObject(eventTimerSub));
    return time ? std::optional<Instant>(std::chrono::milliseconds(*time & 0xFFFF)) : std::nullopt;
}

bool PdoMapping::isOf(const CanFrame &frame) const
{
    return !isOff() && frame.id == identifier() && frame.isExtended == isExtended() && !frame.isRemote &&
           !frame.isError;
}

std::vector<PdoValue> PdoMapping::values(const CanFrame &frame,
                                         const std::function<PdoType(const SdoObject &)> &typeOf) const
{
    std::vector<PdoValue> values;
    const Octets data = frame.data();
    if (!m_hasAllEntries ||
        m_entries.back().firstBit + m_entries.back().bits > static_cast<int>(data.size()) * bitsOfOctet)
        return values;
    for (const PdoEntry &entry : m_entries) {
        const PdoType type = entry.isDummy() ? PdoType() : typeOf(entry.object);
        if (!fits(entry, type))
            return values;
        const std::uint64_t raw = bitsOf(data, entry);
        if (!entry.isDummy())
            values.push_back({entry.object, entry.bits, raw,
                              type.isSigned ? withSign(raw, entry.bits) : static_cast<std::int64_t>(raw)});
    }
    return values;
}

std::optional<PdoTerms> termsOf(std::span<const PdoMapping> pdos, const SdoObject &object)
{
    if (!std::ranges::all_of(pdos, &PdoMapping::isRead))
        return std::nullopt;
    auto found = std::ranges::find_if(pdos, [&](const PdoMapping &pdo) { return pdo.holds(object); });
    const bool holdsIt = found != pdos.end();
    if (!holdsIt)
        found = std::ranges::find_if(pdos, &PdoMapping::isThere);
    if (found == pdos.end())
        return std::nullopt;
    return PdoTerms{.number = found->number(),
                    .identifier = found->identifier(),
                    .isOff = found->isOff(),
                    .type = found->type(),
                    .eventTimer = found->eventTimer(),
                    .inhibitTime = found->inhibitTime(),
                    .holdsIt = holdsIt};
}

} // namespace codewheel::canopen
