// SPDX-License-Identifier: GPL-3.0-or-later
// Opening and saving a project of 512 devices, including as many K3 encoders as a ring can have, each with
// values and two cam programs wanted and stored.
#include "kinds/interbus/ring/numbering.h"
#include "kinds/interbus/ring/ring_rules.h"
#include "kinds/interbus/words/device_number.h"
#include "project/project_file.h"

#include <QElapsedTimer>
#include <QFileInfo>
#include <QTemporaryDir>

#include <algorithm>
#include <cstdio>
#include <vector>

namespace {

using namespace codewheel;

constexpr int rounds = 25;
constexpr int encoders = 128; // 256 words each way

ProjectDevice encoder(const QDateTime &at)
{
    ProjectDevice device;
    device.participant = RingDevice{{}, 0x0237, 2, 2, QStringLiteral("fraba-ocd-ib")};
    device.station = QStringLiteral("Crane 1, hoist");
    device.group = QStringLiteral("Crane 1");
    device.label = {4096, 8192, QStringLiteral("20417")};
    for (const Parameter parameter :
         {Parameter::steps, Parameter::revolutions, Parameter::direction, Parameter::preset}) {
        device.wanted.push_back({parameter, 8192});
        device.stored.push_back({parameter, 8192, Evidence::read, at});
    }
    for (const unsigned number : {1U, 2U}) {
        device.wantedCams.push_back({.number = number});
        device.storedCams.push_back({{.number = number}, Evidence::read, at});
    }
    return device;
}

ProjectDevice digitalInput()
{
    ProjectDevice device;
    device.participant = RingDevice{{}, 0x00BE, 0, 0, {}};
    device.station = QStringLiteral("Limit switches");
    return device;
}

Project largeProject()
{
    const QDateTime at(QDate(2026, 3, 1), QTime(14, 2), Qt::UTC);
    Project project;
    DeviceNumber number;
    for (int n = 0; n < ring_limit::devices; ++n) {
        project.devices.push_back(n % 4 == 0 ? encoder(at) : digitalInput());
        number = nextNumber(number, n % 4 > 1);
        project.devices.back().participant.number = number.node();
    }
    static_assert(ring_limit::devices / 4 == encoders);
    return project;
}

// The median of several, in ms.
double median(auto work)
{
    std::vector<double> times;
    for (int round = 0; round < rounds; ++round) {
        QElapsedTimer clock;
        clock.start();
        work(round);
        times.push_back(static_cast<double>(clock.nsecsElapsed()) * 1e-6);
    }
    std::ranges::sort(times);
    return times[times.size() / 2];
}

} // namespace

int main()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("large.codewheel"));
    Project project = largeProject();
    bool isSound = true;
    const double saved = median([&](int round) {
        project.title = QString::number(round);
        isSound = saveProject(project, path).has_value() && isSound;
    });
    const double opened = median([&](int) { isSound = loadProject(path) == project && isSound; });
    std::printf("%d devices, %.1f MB: opened in %.1f ms, saved in %.1f ms\n", ring_limit::devices,
                static_cast<double>(QFileInfo(path).size()) * 1e-6, opened, saved);
    return isSound ? 0 : 1;
}
