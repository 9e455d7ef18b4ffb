// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/eds/section_reader.h"

#include <map>
#include <vector>

namespace codewheel::canopen {

// The sections of one object.
struct ObjectSections
{
    const IniSection *main = nullptr; // [6004]; null: it has only subindexes
    std::map<std::uint8_t, const IniSection *> subs{};
    const IniSection *names = nullptr;  // [3004Name], of subindexes that have no section
    const IniSection *values = nullptr; // [3004Value], likewise
};

// Which sections a device file has, and what they are for. It refers to the text, which outlives it.
struct FileLayout
{
    using List = std::pair<const IniSection *, bool (*)(std::uint16_t index)>;

    std::map<std::uint16_t, ObjectSections> objects;
    std::vector<List> lists; // with which objects belong to each
    const IniSection *fileInfo = nullptr;
    const IniSection *deviceInfo = nullptr;
    std::vector<const IniSection *> commissioning; // written with one m, with two, or both

    static FileLayout of(const IniText &text, EdsNotes &notes);
};

// Compares the lists with the sections; these decide.
void checkLists(const FileLayout &layout, EdsNotes &notes);

} // namespace codewheel::canopen
