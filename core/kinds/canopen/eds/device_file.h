// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/eds/file_value.h"
#include "kinds/canopen/protocol/sdo.h"

#include <map>
#include <vector>

namespace codewheel::canopen {

enum class FileAccess : std::uint8_t { readOnly, writeOnly, readAndWrite, constant };
QString fileAccessKey(FileAccess access); // "ro"

// An object with a value of its own: a variable, or a subindex.
struct FileObject
{
    SdoObject object{};
    QString name{};                 // "6004:0" where the file has none
    std::optional<DataType> type{}; // empty here and below: the file does not say
    std::optional<FileAccess> access{};
    std::optional<FileValue> factory{}; // DefaultValue
    std::optional<FileValue> minimum{};
    std::optional<FileValue> maximum{};
    std::optional<FileValue> value{}; // ParameterValue
    bool isMapped = false;            // it may be in a PDO
    bool lacksNode = false;           // an identifier of a PDO without the number of its node
    std::int64_t line = 0;            // of its section

    // Set, or else from the maker.
    const std::optional<FileValue> &valueOrFactory() const { return value ? value : factory; }
    bool canBeWritten() const
    {
        return !lacksNode && (access == FileAccess::writeOnly || access == FileAccess::readAndWrite);
    }
};

// What a section for an object with subindexes says of it.
struct FileGroup
{
    QString name;
    int objectType = 0; // of CiA 301: 7 variable, 8 array, 9 record
};

// Who a device is. Empty: the file does not say; 0 says nothing.
struct FileIdentity
{
    QString vendorName{};
    QString productName{};
    QString orderCode{};
    std::optional<std::uint32_t> vendor{};
    std::optional<std::uint32_t> product{};
    std::optional<std::uint32_t> revision{};
};

struct Commissioning
{
    std::optional<int> node{};
    std::optional<int> rate{}; // in Bd
    QString nodeName{};

    friend bool operator==(const Commissioning &, const Commissioning &) = default;
};

// An electronic data sheet (CiA 306), or the configuration of one device, which has values as well.
struct DeviceFile
{
    std::vector<FileObject> objects; // by index and subindex
    std::map<std::uint16_t, FileGroup> groups;
    FileIdentity identity;
    std::vector<std::pair<QString, QString>> deviceInfo; // all of it, as it is written
    Commissioning commissioning;
    EdsNotes notes;
    std::vector<EdsNote> refused; // what is not guessed: node and rate
    QString fileVersion{};        // as it is written
    QString fileRevision{};

    const FileObject *find(SdoObject object) const;
};

inline std::pair<std::uint16_t, std::uint8_t> orderOf(SdoObject object)
{
    return {object.index, object.sub};
}

QString objectName(SdoObject object); // "6004:0", as it is typed

} // namespace codewheel::canopen
