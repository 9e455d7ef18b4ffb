// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/eds/standard_objects.h"

#include <QCoreApplication>

#include <algorithm>
#include <span>

namespace codewheel::canopen {
namespace {

constexpr std::uint8_t mostMappedObjects = 8; // one an octet

// Objects alike: of indexes that follow one another (PDOs, cams), or of subindexes (mappings, identifiers).
struct StandardRow
{
    std::uint16_t index;
    std::uint8_t sub;
    DataType type;
    FileAccess access;
    const char *name; // %1: which of them
    int indexes = 1;
    int subs = 1;
    bool isMapped = false;

    bool covers(SdoObject object) const
    {
        return object.index >= index && object.index < index + indexes && object.sub >= sub &&
               object.sub < sub + subs;
    }
    int numberOf(SdoObject object) const
    {
        return indexes > 1 ? object.index - index + 1 : object.sub - sub + 1;
    }
};

constexpr StandardRow mappedRow(std::uint16_t index, std::uint8_t sub, DataType type, const char *name)
{
    return {index, sub, type, FileAccess::readOnly, name, 1, 1, true};
}

struct StandardTexts
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::StandardObjects)

public:
    static std::span<const StandardRow> rows()
    {
        using enum DataType;
        using enum FileAccess;
        static constexpr StandardRow all[] = {
            {0x1000, 0, u32, readOnly, QT_TR_NOOP("Device type")},
            {0x1001, 0, u8, readOnly, QT_TR_NOOP("Error register")},
            {0x1003, 0, u8, readAndWrite, QT_TR_NOOP("Number of errors kept")},
            {0x1003, 1, u32, readOnly, QT_TR_NOOP("Error %1, the newest first"), 1, 4},
            {0x1005, 0, u32, readAndWrite, QT_TR_NOOP("Identifier of SYNC")},
            {0x1008, 0, text, constant, QT_TR_NOOP("Device name")},
            {0x1009, 0, text, constant, QT_TR_NOOP("Hardware version")},
            {0x100A, 0, text, constant, QT_TR_NOOP("Software version")},
            {0x100C, 0, u16, readAndWrite, QT_TR_NOOP("Guard time, in ms")},
            {0x100D, 0, u8, readAndWrite, QT_TR_NOOP("Life time factor")},
            {0x1010, 1, u32, readAndWrite, QT_TR_NOOP("Store all parameters")},
            {0x1011, 1, u32, readAndWrite, QT_TR_NOOP("Restore all defaults")},
            {0x1014, 0, u32, readAndWrite, QT_TR_NOOP("Identifier of EMCY")},
            {0x1017, 0, u16, readAndWrite, QT_TR_NOOP("Heartbeat time, in ms")},
            {0x1018, 1, u32, readOnly, QT_TR_NOOP("Vendor")},
            {0x1018, 2, u32, readOnly, QT_TR_NOOP("Product")},
            {0x1018, 3, u32, readOnly, QT_TR_NOOP("Revision")},
            {0x1018, 4, u32, readOnly, QT_TR_NOOP("Serial number")},
            {0x1200, 1, u32, readOnly, QT_TR_NOOP("Identifier of SDO requests")},
            {0x1200, 2, u32, readOnly, QT_TR_NOOP("Identifier of SDO answers")},
            {0x1800, 1, u32, readAndWrite, QT_TR_NOOP("Identifier of TPDO%1"), 2},
            {0x1800, 2, u8, readAndWrite, QT_TR_NOOP("Transmission type of TPDO%1"), 2},
            {0x1800, 3, u16, readAndWrite, QT_TR_NOOP("Inhibit time of TPDO%1, in 0.1 ms"), 2},
            {0x1800, 5, u16, readAndWrite, QT_TR_NOOP("Event timer of TPDO%1, in ms"), 2},
            {0x1A00, 0, u8, readAndWrite, QT_TR_NOOP("Number of objects in TPDO%1"), 2},
            {0x1A00, 1, u32, readAndWrite, QT_TR_NOOP("Object %1 in TPDO1"), 1, mostMappedObjects},
            {0x1A01, 1, u32, readAndWrite, QT_TR_NOOP("Object %1 in TPDO2"), 1, mostMappedObjects},
            {0x6000, 0, u16, readAndWrite, QT_TR_NOOP("Operating parameters")},
            {0x6001, 0, u32, readAndWrite, QT_TR_NOOP("Measuring units per revolution")},
            {0x6002, 0, u32, readAndWrite, QT_TR_NOOP("Total measuring range")},
            {0x6003, 0, u32, readAndWrite, QT_TR_NOOP("Preset")},
            mappedRow(0x6004, 0, u32, QT_TR_NOOP("Position")),
            {0x6005, 1, u32, readAndWrite, QT_TR_NOOP("Step of the position")},
            {0x6005, 2, u32, readAndWrite, QT_TR_NOOP("Step of the speed")},
            mappedRow(0x6030, 1, i16, QT_TR_NOOP("Speed")),
            mappedRow(0x6040, 1, i16, QT_TR_NOOP("Acceleration")),
            mappedRow(0x6050, 1, i16, QT_TR_NOOP("Jerk")),
            {0x6200, 0, u16, readAndWrite, QT_TR_NOOP("Cyclic timer, in ms")},
            mappedRow(0x6300, 1, u8, QT_TR_NOOP("Cams: state")),
            {0x6301, 1, u8, readAndWrite, QT_TR_NOOP("Cams: enabled")},
            {0x6302, 1, u8, readAndWrite, QT_TR_NOOP("Cams: polarity")},
            {0x6310, 1, i32, readAndWrite, QT_TR_NOOP("Low limit of cam %1"), 8},
            {0x6320, 1, i32, readAndWrite, QT_TR_NOOP("High limit of cam %1"), 8},
            {0x6330, 1, u16, readAndWrite, QT_TR_NOOP("Hysteresis of cam %1"), 8},
            mappedRow(0x6400, 1, u8, QT_TR_NOOP("Work area: state")),
            {0x6401, 1, i32, readAndWrite, QT_TR_NOOP("Work area: low limit")},
            {0x6402, 1, i32, readAndWrite, QT_TR_NOOP("Work area: high limit")},
            {0x6500, 0, u16, readOnly, QT_TR_NOOP("Operating status")},
            {0x6501, 0, u32, readOnly, QT_TR_NOOP("Single-turn resolution")},
            {0x6502, 0, u16, readOnly, QT_TR_NOOP("Distinguishable revolutions")},
            mappedRow(0x6503, 0, u16, QT_TR_NOOP("Alarms")),
            {0x6504, 0, u16, readOnly, QT_TR_NOOP("Supported alarms")},
            mappedRow(0x6505, 0, u16, QT_TR_NOOP("Warnings")),
            {0x6506, 0, u16, readOnly, QT_TR_NOOP("Supported warnings")},
            {0x6507, 0, u32, readOnly, QT_TR_NOOP("Version of profile and software")},
            {0x6508, 0, u32, readOnly, QT_TR_NOOP("Operating time, in 0.1 h")},
            {0x6509, 0, i32, readOnly, QT_TR_NOOP("Offset")},
            {0x650A, 1, i32, readOnly, QT_TR_NOOP("Offset of the maker")},
            {0x650A, 2, i32, readOnly, QT_TR_NOOP("Lowest position")},
            {0x650A, 3, i32, readOnly, QT_TR_NOOP("Highest position")},
            {0x650B, 0, u32, readOnly, QT_TR_NOOP("Serial number of the encoder")},
        };
        return all;
    }
};

QString nameWithNumber(const QString &name, int number)
{
    return name.contains(QLatin1String("%1")) ? name.arg(number) : name;
}

FileObject standardRowObject(const StandardRow &row, SdoObject object)
{
    return {.object = object,
            .name = nameWithNumber(QString::fromLatin1(row.name), row.numberOf(object)),
            .type = row.type,
            .access = row.access,
            .isMapped = row.isMapped};
}

} // namespace

DeviceFile standardObjects()
{
    DeviceFile file;
    for (const StandardRow &row : StandardTexts::rows())
        for (int index = 0; index < row.indexes; ++index)
            for (int sub = 0; sub < row.subs; ++sub)
                file.objects.push_back(standardRowObject(row, {static_cast<std::uint16_t>(row.index + index),
                                                               static_cast<std::uint8_t>(row.sub + sub)}));
    std::ranges::sort(file.objects, {}, [](const FileObject &each) { return orderOf(each.object); });
    return file;
}

QString standardObjectName(SdoObject object)
{
    const auto rows = StandardTexts::rows();
    const auto row = std::ranges::find_if(rows, [&](const StandardRow &each) { return each.covers(object); });
    return row == rows.end() ? QString()
                             : nameWithNumber(StandardTexts::tr(row->name), row->numberOf(object));
}

} // namespace codewheel::canopen
