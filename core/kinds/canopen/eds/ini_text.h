// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/eds/eds_fault.h"

#include <QByteArray>

#include <string_view>

namespace codewheel::canopen {

// A line KEY=VALUE of a device file, without the blanks around both.
struct IniEntry
{
    std::string_view key;
    std::string_view value;
    std::int64_t line = 0; // from 1
};

struct IniSection
{
    std::string name; // in lower case, without blanks: "1018sub1"
    QString written;  // as in the file
    std::int64_t line = 0;
    std::vector<IniEntry> entries{};

    // Whatever the case of its letters; the first one. Null: there is none.
    const IniEntry *find(std::string_view key) const;
};

// The bytes of a device file as sections: UTF-8 if they are valid, UTF-16 where its mark says so, otherwise
// Latin-1. Lines may end with CR, LF or both; comments begin with ; or #. Entries refer to the text that this
// object keeps.
class IniText
{
public:
    IniText(const QByteArray &bytes, EdsNotes &notes);
    Q_DISABLE_COPY_MOVE(IniText)

    const std::vector<IniSection> &sections() const { return m_sections; }

private:
    void readLine(std::string_view line, std::int64_t number, EdsNotes &notes);
    void readSection(std::string_view line, std::int64_t number, EdsNotes &notes);

    QByteArray m_text; // UTF-8
    std::vector<IniSection> m_sections;
};

std::string_view trimmed(std::string_view text);
bool isSameKey(std::string_view one, std::string_view other); // whatever the case
QString textOf(std::string_view utf8);

} // namespace codewheel::canopen
