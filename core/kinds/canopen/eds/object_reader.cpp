// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/eds/object_reader.h"

#include <algorithm>
#include <array>

namespace codewheel::canopen {
namespace {

constexpr int arrayType = 8;
constexpr std::uint64_t mostSubs = 254;

constexpr std::array objectKeys{
    "ParameterName", "ObjectType",    "DataType",  "AccessType", "PDOMapping",    "DefaultValue",
    "LowLimit",      "HighLimit",     "ObjFlags",  "SubNumber",  "CompactSubObj", "ParameterValue",
    "Denotation",    "ParameterRefd", "ParamRefd", "UploadFile", "DownloadFile",
};
constexpr std::array compactKeys{"NrOfEntries"};

bool isLower(const FileValue &one, const FileValue &other, std::optional<DataType> type)
{
    if (one.value.index() != other.value.index() || one.addsNode != other.addsNode)
        return false;
    if (type == DataType::u64 && one.number() != nullptr)
        return static_cast<std::uint64_t>(*one.number()) < static_cast<std::uint64_t>(*other.number());
    return one.value < other.value;
}

// An identifier of the predefined connection set for a node without a number: 180h, 200h, up to 500h.
bool isOfNoNode(SdoObject object, const std::optional<FileValue> &value)
{
    constexpr std::uint16_t commands = 0xFE00; // of 1400h.. and 1800h..
    const std::uint16_t kind = object.index & commands;
    if (object.sub != 1 || (kind != 0x1400 && kind != 0x1800))
        return false;
    if (!value || value->addsNode || value->number() == nullptr)
        return false;
    constexpr std::int64_t identifierBits = 0x7FF;
    constexpr std::int64_t nodeBits = 0x7F;
    const std::int64_t identifier = *value->number() & identifierBits;
    return (identifier & nodeBits) == 0 && identifier >= 0x180 && identifier <= 0x500;
}

// "3=..." of [3004Name] and [3004Value]
const IniEntry *listedEntry(const IniSection *section, std::uint64_t sub)
{
    return section != nullptr ? section->find(std::to_string(sub)) : nullptr;
}

// Subindex 0 of compact ones.
FileObject compactCount(const FileObject &like, std::uint64_t count)
{
    return {.object = {like.object.index, 0},
            .name = QStringLiteral("NrOfObjects"),
            .type = DataType::u8,
            .access = FileAccess::readOnly,
            .factory = FileValue{static_cast<std::int64_t>(count)},
            .line = like.line};
}

} // namespace

bool ObjectReader::read(std::uint16_t index, const ObjectSections &sections)
{
    if (sections.main != nullptr) {
        const SectionReader main(*sections.main, m_file.notes);
        main.checkKeys(objectKeys);
        readGroup(index, sections, main);
    } else if (!sections.subs.empty()) {
        const SectionReader first(*sections.subs.begin()->second, m_file.notes);
        first.noteSection(EdsFault::subAlone, {objectName({index, 0})});
        readSubs(index, sections);
    }
    return m_file.objects.size() <= mostObjects;
}

void ObjectReader::readGroup(std::uint16_t index, const ObjectSections &sections, const SectionReader &main)
{
    const int type = main.objectType();
    m_file.groups[index] = {main.text("ParameterName"), type};
    const auto compact = main.number("CompactSubObj").value_or(0);
    if (compact > 0)
        return addCompact(sections, main, objectIn({index, 0}, main), compact);
    if (sections.subs.empty()) {
        const bool hasValue = main.section().find("DataType") != nullptr;
        if (type >= arrayType && !hasValue)
            return main.noteSection(EdsFault::noSubs, {objectName({index, 0})});
        return add(objectIn({index, 0}, main));
    }
    const auto announced = main.number("SubNumber");
    if (announced && *announced != sections.subs.size())
        main.note(*main.section().find("SubNumber"), EdsFault::subsDiffer,
                  {QString::number(*announced), QString::number(sections.subs.size())});
    readSubs(index, sections);
}

void ObjectReader::readSubs(std::uint16_t index, const ObjectSections &sections)
{
    for (const auto &[sub, section] : sections.subs)
        addSub({index, sub}, *section);
}

// Subindexes without sections of their own: all like the object, but the first, which says how many there
// are.
void ObjectReader::addCompact(const ObjectSections &sections, const SectionReader &main,
                              const FileObject &like, std::uint64_t announced)
{
    if (announced > mostSubs)
        main.note(*main.section().find("CompactSubObj"), EdsFault::tooManySubs,
                  {QString::number(announced), QString::number(mostSubs)});
    const std::uint64_t count = std::min(announced, mostSubs);
    for (const IniSection *list : {sections.names, sections.values})
        if (list != nullptr)
            SectionReader(*list, m_file.notes).checkKeys(compactKeys, true);
    const std::uint64_t last =
        sections.subs.empty() ? count : std::max<std::uint64_t>(count, sections.subs.rbegin()->first);
    for (std::uint64_t number = 0; number <= last; ++number) {
        const auto sub = static_cast<std::uint8_t>(number);
        if (const auto own = sections.subs.find(sub); own != sections.subs.end())
            addSub({like.object.index, sub}, *own->second);
        else if (sub == 0)
            add(compactCount(like, count));
        else if (number <= count)
            add(compactSub(sections, like, sub));
    }
}

FileObject ObjectReader::compactSub(const ObjectSections &sections, const FileObject &like, std::uint8_t sub)
{
    FileObject object = like;
    object.object.sub = sub;
    const IniEntry *name = listedEntry(sections.names, sub);
    object.name = name != nullptr ? textOf(name->value) : like.name + QStringLiteral(" %1").arg(sub);
    if (sections.values != nullptr)
        object.value = SectionReader(*sections.values, m_file.notes).value(std::to_string(sub), object.type);
    return object;
}

void ObjectReader::addSub(SdoObject object, const IniSection &section)
{
    const SectionReader reader(section, m_file.notes);
    reader.checkKeys(objectKeys);
    add(objectIn(object, reader));
}

FileObject ObjectReader::objectIn(SdoObject object, const SectionReader &section)
{
    FileObject read{.object = object, .name = section.text("Denotation"), .line = section.section().line};
    if (read.name.isEmpty())
        read.name = section.text("ParameterName");
    if (read.name.isEmpty())
        read.name = objectName(object);
    read.type = section.dataType();
    read.access = section.access();
    read.isMapped = section.isMapped();
    read.factory = section.value("DefaultValue", read.type);
    read.value = section.value("ParameterValue", read.type);
    read.minimum = section.value("LowLimit", read.type);
    read.maximum = section.value("HighLimit", read.type);
    if (read.minimum && read.maximum && isLower(*read.maximum, *read.minimum, read.type)) {
        section.note(*section.section().find("LowLimit"), EdsFault::lowOverHigh);
        read.minimum.reset();
        read.maximum.reset();
    }
    for (const char *key : {"DefaultValue", "ParameterValue"})
        if (isOfNoNode(object, key == std::string_view("DefaultValue") ? read.factory : read.value)) {
            const IniEntry *written = section.section().find(key);
            section.note(*written, EdsFault::nodeMissing, {textOf(written->value)});
            read.lacksNode = true;
        }
    return read;
}

} // namespace codewheel::canopen
