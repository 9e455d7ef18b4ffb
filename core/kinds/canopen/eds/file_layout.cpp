// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/eds/file_layout.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <set>
#include <string>

namespace codewheel::canopen {
namespace {

constexpr std::size_t indexDigits = 4;

bool isMakersIndex(std::uint16_t index)
{
    return index >= 0x2000 && index < 0x6000;
}
bool isStandardIndex(std::uint16_t index)
{
    return !isMakersIndex(index);
}

// Sections that say nothing that is used here.
bool isSkipped(std::string_view name)
{
    constexpr std::array<std::string_view, 5> names{"dummyusage", "comments", "standarddatatypes",
                                                    "dynamicchannels", "toolinfos"};
    return std::ranges::find(names, name) != names.end();
}

// [SupportedModules], [M1ModuleInfo], [M1SubExt1027]
bool isOfModule(std::string_view name)
{
    return name == "supportedmodules" ||
           (name.size() > 2 && name[0] == 'm' && name[1] >= '0' && name[1] <= '9');
}

std::optional<std::uint8_t> subIn(std::string_view text)
{
    constexpr int hexadecimal = 16;
    std::uint8_t sub = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), sub, hexadecimal);
    const bool isWhole = !text.empty() && error == std::errc() && end == text.data() + text.size();
    return isWhole ? std::optional(sub) : std::nullopt;
}

class LayoutMaker
{
public:
    LayoutMaker(FileLayout &layout, EdsNotes &notes)
        : m_layout(layout)
        , m_notes(notes)
    {}

    void take(const IniSection &section)
    {
        if (!m_names.insert(section.name).second)
            return note(section, EdsFault::sectionTwice);
        if (takeHead(section) || takeOfObject(section) || isSkipped(section.name))
            return;
        note(section, isOfModule(section.name) ? EdsFault::ofModule : EdsFault::unknownSection);
    }

private:
    void note(const IniSection &section, EdsFault fault)
    {
        m_notes.add({section.line, section.written, fault});
    }

    bool takeHead(const IniSection &section)
    {
        const std::string_view name = section.name;
        if (name == "fileinfo")
            m_layout.fileInfo = &section;
        else if (name == "deviceinfo")
            m_layout.deviceInfo = &section;
        else if (name == "devicecomissioning" || name == "devicecommissioning")
            m_layout.commissioning.push_back(&section);
        else if (name == "mandatoryobjects" || name == "optionalobjects")
            m_layout.lists.emplace_back(&section, isStandardIndex);
        else if (name == "manufacturerobjects")
            m_layout.lists.emplace_back(&section, isMakersIndex);
        else
            return false;
        return true;
    }

    bool takeOfObject(const IniSection &section)
    {
        std::string_view name = section.name;
        if (name.starts_with("0x"))
            name.remove_prefix(2);
        const auto index = name.size() >= indexDigits ? indexIn(name.substr(0, indexDigits)) : std::nullopt;
        if (!index)
            return false;
        const std::string_view what = name.substr(indexDigits);
        if (what == "objectlinks")
            return true;
        if (what.starts_with("sub"))
            return takeSub(section, *index, what.substr(3));
        if (!what.empty() && what != "name" && what != "denotation" && what != "value")
            return false;
        ObjectSections &its = m_layout.objects[*index];
        (what.empty() ? its.main : what == "value" ? its.values : its.names) = &section;
        return true;
    }

    bool takeSub(const IniSection &section, std::uint16_t index, std::string_view digits)
    {
        const auto sub = subIn(digits);
        if (!sub)
            return false;
        if (!m_layout.objects[index].subs.emplace(*sub, &section).second)
            note(section, EdsFault::sectionTwice);
        return true;
    }

    FileLayout &m_layout;
    EdsNotes &m_notes;
    std::set<std::string> m_names;
};

QString shownIndex(std::uint16_t index)
{
    return QStringLiteral("%1h").arg(index, 4, 16, QLatin1Char('0')).toUpper().replace(u'H', u'h');
}

// Decimal where it has no 0x; some tools write hexadecimal all the same.
std::optional<std::uint16_t> listedIndex(std::string_view text, const FileLayout &layout)
{
    constexpr std::uint64_t largest = 0xFFFF;
    const ReadNumber number = readFileNumber(text);
    if (number.magnitude && *number.magnitude != 0 && *number.magnitude <= largest) {
        const auto index = static_cast<std::uint16_t>(*number.magnitude);
        if (number.isHexadecimal || layout.objects.contains(index))
            return index;
    }
    const auto asHexadecimal = indexIn(text);
    return asHexadecimal && layout.objects.contains(*asHexadecimal) ? asHexadecimal : std::nullopt;
}

class ListCheck
{
public:
    ListCheck(const FileLayout &layout, EdsNotes &notes)
        : m_layout(layout)
        , m_notes(notes)
    {}

    void check(const FileLayout::List &list)
    {
        const SectionReader reader(*list.first, m_notes);
        constexpr std::array known{"SupportedObjects"};
        reader.checkKeys(known, true);
        std::uint64_t count = 0;
        for (const IniEntry &entry : list.first->entries) {
            if (isSameKey(entry.key, known.front()) || entry.value.empty())
                continue;
            ++count;
            checkEntry(reader, entry, list.second);
        }
        const auto announced = reader.number(known.front());
        if (announced && *announced != count)
            reader.note(*list.first->find(known.front()), EdsFault::wrongCount,
                        {QString::number(*announced), QString::number(count)});
    }

    void checkOthers()
    {
        for (const auto &[index, sections] : m_layout.objects)
            if (sections.main != nullptr && !m_listed.contains(index))
                m_notes.add(
                    {sections.main->line, sections.main->written, EdsFault::inNoList, {shownIndex(index)}});
    }

private:
    void checkEntry(const SectionReader &reader, const IniEntry &entry, bool (*belongs)(std::uint16_t))
    {
        const auto index = listedIndex(entry.value, m_layout);
        if (!index)
            return reader.note(entry, EdsFault::notInList, {textOf(entry.value)});
        m_listed.insert(*index);
        if (!m_layout.objects.contains(*index))
            reader.note(entry, EdsFault::noSection, {shownIndex(*index)});
        else if (!belongs(*index))
            reader.note(entry, EdsFault::inWrongList, {shownIndex(*index)});
    }

    const FileLayout &m_layout;
    EdsNotes &m_notes;
    std::set<std::uint16_t> m_listed;
};

} // namespace

FileLayout FileLayout::of(const IniText &text, EdsNotes &notes)
{
    FileLayout layout;
    LayoutMaker maker(layout, notes);
    for (const IniSection &section : text.sections())
        maker.take(section);
    return layout;
}

void checkLists(const FileLayout &layout, EdsNotes &notes)
{
    if (layout.lists.empty())
        return notes.add({0, {}, EdsFault::noLists});
    ListCheck check(layout, notes);
    for (const FileLayout::List &list : layout.lists)
        check.check(list);
    check.checkOthers();
}

} // namespace codewheel::canopen
