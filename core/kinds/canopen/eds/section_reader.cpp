// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/eds/section_reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <unordered_set>

namespace codewheel::canopen {
namespace {

constexpr int variableType = 7;

struct AccessRow
{
    std::string_view written;
    FileAccess access;
};
constexpr std::array accessRows{
    AccessRow{"ro", FileAccess::readOnly},      AccessRow{"r", FileAccess::readOnly},
    AccessRow{"wo", FileAccess::writeOnly},     AccessRow{"w", FileAccess::writeOnly},
    AccessRow{"rw", FileAccess::readAndWrite},  AccessRow{"rww", FileAccess::readAndWrite},
    AccessRow{"rwr", FileAccess::readAndWrite}, AccessRow{"rww", FileAccess::readAndWrite},
    AccessRow{"const", FileAccess::constant},
};

// CiA 301, table 42: 0 null, 2 domain, 5 and 6 definitions of types, 7 variable, 8 array, 9 record.
constexpr std::array<std::uint64_t, 7> objectTypeNumbers{0, 2, 5, 6, 7, 8, 9};

bool isNumberKey(std::string_view key)
{
    return !key.empty() && key.find_first_not_of("0123456789") == std::string_view::npos;
}

std::string lowerCase(std::string_view key)
{
    std::string text(key);
    for (char &letter : text)
        if (letter >= 'A' && letter <= 'Z')
            letter = static_cast<char>(letter - 'A' + 'a');
    return text;
}

} // namespace

const IniEntry *SectionReader::entry(std::string_view key) const
{
    const IniEntry *found = m_section.find(key);
    return found != nullptr && !found->value.empty() ? found : nullptr;
}

// Of a value that is no text.
std::string_view SectionReader::withoutComment(const IniEntry &entry) const
{
    const std::size_t comment = entry.value.find_first_of(";#");
    if (comment == std::string_view::npos)
        return entry.value;
    note(entry, EdsFault::commentBehind);
    return trimmed(entry.value.substr(0, comment));
}

void SectionReader::note(const IniEntry &entry, EdsFault fault, QStringList parts) const
{
    m_notes.add({entry.line, textOf(entry.key), fault, std::move(parts)});
}

void SectionReader::noteSection(EdsFault fault, QStringList parts) const
{
    m_notes.add({m_section.line, m_section.written, fault, std::move(parts)});
}

QString SectionReader::text(std::string_view key) const
{
    const IniEntry *found = entry(key);
    const auto read = found != nullptr ? readFileValue(found->value, DataType::text) : ReadValue();
    return read.value ? std::get<QString>(read.value->value) : QString();
}

std::optional<std::uint64_t> SectionReader::number(std::string_view key) const
{
    const IniEntry *found = entry(key);
    if (found == nullptr)
        return std::nullopt;
    const std::string_view written = withoutComment(*found);
    const ReadNumber read = readFileNumber(written);
    if (!read.magnitude || (read.isNegative && *read.magnitude != 0)) {
        if (!written.empty())
            note(*found, EdsFault::notANumber, {textOf(written)});
        return std::nullopt;
    }
    if (read.fault)
        note(*found, *read.fault, {QString::number(*read.magnitude)});
    return read.magnitude;
}

std::optional<FileValue> SectionReader::value(std::string_view key, std::optional<DataType> type) const
{
    const IniEntry *found = entry(key);
    if (found == nullptr)
        return std::nullopt;
    const bool isText = !type || factsOf(*type).form == DataTypeFacts::Form::text;
    ReadValue read = readFileValue(isText ? found->value : withoutComment(*found), type);
    if (read.fault)
        note(*found, *read.fault, read.parts);
    return std::move(read.value);
}

std::optional<DataType> SectionReader::dataType() const
{
    const auto written = number("DataType");
    if (!written)
        return std::nullopt;
    constexpr std::uint64_t largest = 0xFFFF;
    const auto type = *written <= largest ? dataTypeOf(static_cast<std::int64_t>(*written)) : std::nullopt;
    if (!type)
        note(*entry("DataType"), EdsFault::unknownType, {textOf(entry("DataType")->value)});
    return type;
}

int SectionReader::objectType() const
{
    const auto type = number("ObjectType");
    if (!type)
        return variableType;
    if (std::ranges::find(objectTypeNumbers, *type) != objectTypeNumbers.end())
        return static_cast<int>(*type);
    note(*entry("ObjectType"), EdsFault::unknownObjectType, {textOf(entry("ObjectType")->value)});
    return variableType;
}

std::optional<FileAccess> SectionReader::access() const
{
    const IniEntry *found = entry("AccessType");
    if (found == nullptr)
        return std::nullopt;
    const std::string_view written = withoutComment(*found);
    const auto row = std::ranges::find_if(
        accessRows, [written](const AccessRow &each) { return isSameKey(each.written, written); });
    if (row != accessRows.end())
        return row->access;
    note(*found, EdsFault::unknownAccess, {textOf(written)});
    return std::nullopt;
}

bool SectionReader::isMapped() const
{
    const auto mapped = number("PDOMapping");
    if (mapped && *mapped > 1)
        note(*entry("PDOMapping"), EdsFault::unknownMapping, {textOf(entry("PDOMapping")->value)});
    return mapped == 1U;
}

void SectionReader::checkKeys(std::span<const char *const> known, bool takesNumbers) const
{
    std::unordered_set<std::string> keys;
    for (const IniEntry &each : m_section.entries) {
        const bool isKnown =
            (takesNumbers && isNumberKey(each.key)) ||
            std::ranges::any_of(known, [&](const char *key) { return isSameKey(each.key, key); });
        if (!keys.insert(lowerCase(each.key)).second)
            note(each, EdsFault::keyTwice);
        else if (!isKnown)
            note(each, EdsFault::unknownKey);
    }
}

std::optional<std::uint16_t> indexIn(std::string_view text)
{
    if (text.size() > 2 && text[0] == '0' && (text[1] == 'x' || text[1] == 'X'))
        text.remove_prefix(2);
    constexpr int hexadecimal = 16;
    std::uint16_t index = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index, hexadecimal);
    const bool isWhole = !text.empty() && error == std::errc() && end == text.data() + text.size();
    return isWhole && index != 0 ? std::optional(index) : std::nullopt;
}

} // namespace codewheel::canopen
