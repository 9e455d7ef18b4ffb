// SPDX-License-Identifier: GPL-3.0-or-later
// The window at work: bus at 1 ms in a thread of its own, both encoders turning, four monitors (eight words
// with hex and meaning) and the dial. Prints pictures a second and the share of one core.
#include "app/window/main_window.h"
#include "app/window/program.h"
#include "ring/bus_session.h"
#include "widgets/monitor/monitor_area.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTimer>

#include <cstdio>
#include <ctime>

namespace {

using namespace codewheel;

constexpr int settleMilliseconds = 2'000;
constexpr int measuredMilliseconds = 10'000;

double processorSeconds()
{
    timespec used{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
    return static_cast<double>(used.tv_sec) + static_cast<double>(used.tv_nsec) * 1e-9;
}

void fillWindow(Program &program)
{
    auto *monitors = program.window()->findChild<MonitorArea *>();
    for (const DeviceNumber number : {DeviceNumber{1, 0}, DeviceNumber{2, 0}})
        for (const MonitorKind kind : {MonitorKind::in32, MonitorKind::out32})
            monitors->openMonitor(number, kind);
    program.training().controls->setSpeed({1, 0}, 600);
    program.training().controls->setSpeed({2, 0}, 1'000);
}

} // namespace

int main(int argc, char **argv)
{
    QApplication application(argc, argv);
    const QTemporaryDir folder;
    Program program(application, folder.filePath(QStringLiteral("bench.ini")));
    program.openWindow();
    program.window()->resize(1600, 1000);
    program.window()->show();

    double usedBefore = 0;
    int pictures = 0;
    QElapsedTimer clock;
    QTimer::singleShot(settleMilliseconds / 2, &application, [&] { fillWindow(program); });
    QTimer::singleShot(settleMilliseconds, &application, [&] {
        QObject::connect(program.training().bus.get(), &BusSession::updated, &application,
                         [&] { ++pictures; });
        usedBefore = processorSeconds();
        clock.start();
        QTimer::singleShot(measuredMilliseconds, Qt::PreciseTimer, &application, [&] {
            const double seconds = static_cast<double>(clock.nsecsElapsed()) * 1e-9;
            const double used = processorSeconds() - usedBefore;
            std::printf("%.1f pictures a second, %.1f %% of one core, %llu late cycles\n", pictures / seconds,
                        100 * used / seconds,
                        static_cast<unsigned long long>(program.training().bus->latest().lateCycles));
            QCoreApplication::exit();
        });
    });
    return QApplication::exec();
}
