// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

// An EDS with as many objects as the largest encoders have.
namespace codewheel::bench {

inline constexpr int largeEdsIndices = 130;
inline constexpr int largeEdsSubindices = 10; // of each

inline constexpr int largeEdsObjects = largeEdsIndices * largeEdsSubindices;

inline QByteArray largeEds()
{
    QByteArray list;
    QByteArray sections;
    for (int i = 0; i < largeEdsIndices; ++i) {
        const QByteArray index = QByteArray::number(0x2000 + i, 16);
        list += QByteArray::number(i + 1) + "=0x" + index + "\r\n";
        sections += '[' + index + "]\r\nParameterName=Table\r\nObjectType=0x9\r\nSubNumber=10\r\n\r\n";
        for (int sub = 0; sub < largeEdsSubindices; ++sub)
            sections += '[' + index + "sub" + QByteArray::number(sub, 16) +
                        "]\r\nParameterName=Value of the table\r\nObjectType=0x7\r\nDataType=0x0007\r\n"
                        "AccessType=rw\r\nDefaultValue=0x00000010\r\nLowLimit=0\r\nHighLimit=0xFFFFFFFF\r\n"
                        "PDOMapping=0\r\n\r\n";
    }
    return "[ManufacturerObjects]\r\nSupportedObjects=" + QByteArray::number(largeEdsIndices) + "\r\n" +
           list + sections;
}

} // namespace codewheel::bench
