// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/eds/device_file.h"
#include "kinds/canopen/eds/ini_text.h"

#include <span>

namespace codewheel::canopen {

// Reads the keys of one section. What is otherwise than expected goes to the notes.
class SectionReader
{
public:
    SectionReader(const IniSection &section, EdsNotes &notes)
        : m_section(section)
        , m_notes(notes)
    {}

    const IniSection &section() const { return m_section; }
    QString text(std::string_view key) const; // without quotes; empty: there is none
    // Empty: there is none, or it cannot be read.
    std::optional<std::uint64_t> number(std::string_view key) const;
    std::optional<FileValue> value(std::string_view key, std::optional<DataType> type) const;
    std::optional<DataType> dataType() const;
    int objectType() const; // 7, a variable, if nothing is said
    std::optional<FileAccess> access() const;
    bool isMapped() const;

    // What is neither among these nor a number, if `takesNumbers`; what is here twice.
    void checkKeys(std::span<const char *const> known, bool takesNumbers = false) const;
    void note(const IniEntry &entry, EdsFault fault, QStringList parts = {}) const;
    void noteSection(EdsFault fault, QStringList parts = {}) const;

private:
    const IniEntry *entry(std::string_view key) const; // null: there is none, or it is blank
    std::string_view withoutComment(const IniEntry &entry) const;

    const IniSection &m_section;
    EdsNotes &m_notes;
};

// "1018", "0x1018"; of a section's name or a list.
std::optional<std::uint16_t> indexIn(std::string_view text);

} // namespace codewheel::canopen
