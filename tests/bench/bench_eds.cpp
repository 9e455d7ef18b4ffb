// SPDX-License-Identifier: GPL-3.0-or-later
// Reading an EDS of 1300 objects.
#include "kinds/canopen/eds/device_file_reader.h"

#include <QElapsedTimer>

#include <algorithm>
#include <cstdio>
#include <vector>

namespace {

using namespace codewheel;

constexpr int rounds = 25;
constexpr int indices = 130;
constexpr int subindices = 10; // of each

QByteArray largeFile()
{
    QByteArray list;
    QByteArray sections;
    for (int i = 0; i < indices; ++i) {
        const QByteArray index = QByteArray::number(0x2000 + i, 16);
        list += QByteArray::number(i + 1) + "=0x" + index + "\r\n";
        sections += '[' + index + "]\r\nParameterName=Table\r\nObjectType=0x9\r\nSubNumber=10\r\n\r\n";
        for (int sub = 0; sub < subindices; ++sub)
            sections += '[' + index + "sub" + QByteArray::number(sub, 16) +
                        "]\r\nParameterName=Value of the table\r\nObjectType=0x7\r\nDataType=0x0007\r\n"
                        "AccessType=rw\r\nDefaultValue=0x00000010\r\nLowLimit=0\r\nHighLimit=0xFFFFFFFF\r\n"
                        "PDOMapping=0\r\n\r\n";
    }
    return "[ManufacturerObjects]\r\nSupportedObjects=" + QByteArray::number(indices) + "\r\n" + list +
           sections;
}

} // namespace

int main()
{
    const QByteArray bytes = largeFile();
    std::vector<double> times;
    for (int round = 0; round < rounds; ++round) {
        QElapsedTimer timer;
        timer.start();
        const auto file = canopen::readDeviceFile(bytes);
        times.push_back(static_cast<double>(timer.nsecsElapsed()) / 1e6);
        if (!file || file->objects.size() != std::size_t{indices} * subindices)
            return 1;
    }
    std::ranges::sort(times);
    std::printf("%d objects, %lld kB: read in %.1f ms, at most %.1f ms\n", indices * subindices,
                static_cast<long long>(bytes.size() / 1024), times[rounds / 2], times.back());
    return 0;
}
