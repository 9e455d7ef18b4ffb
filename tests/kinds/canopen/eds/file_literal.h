// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/eds/device_file_reader.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace codewheel::canopen {

// A file that is read; a test fails if it is refused.
inline DeviceFile fileOf(const QByteArray &bytes)
{
    auto file = readDeviceFile(bytes);
    EXPECT_TRUE(file) << (file ? std::string() : file.error().text().toStdString());
    return file ? *std::move(file) : DeviceFile();
}

// With lists for one object, 6004h, and what stands in its section.
inline QByteArray fileWith(const QByteArray &lines)
{
    return "[OptionalObjects]\nSupportedObjects=1\n1=0x6004\n[6004]\nParameterName=Position\n" + lines;
}

// "4 DataType 27": line, key and number of the fault of each note.
struct NoteRow
{
    std::int64_t line;
    std::string key;
    EdsFault fault;

    friend bool operator==(const NoteRow &, const NoteRow &) = default;
    friend void PrintTo(const NoteRow &row, std::ostream *out)
    {
        *out << row.line << ' ' << row.key << ' ' << static_cast<int>(row.fault);
    }
};

inline std::vector<NoteRow> rowsOf(const std::vector<EdsNote> &notes)
{
    std::vector<NoteRow> rows;
    for (const EdsNote &note : notes)
        rows.push_back({note.line, note.key.toStdString(), note.fault});
    return rows;
}

inline std::vector<NoteRow> notesOf(const DeviceFile &file)
{
    return rowsOf(file.notes.kept());
}

} // namespace codewheel::canopen
