// SPDX-License-Identifier: GPL-3.0-or-later
// bench_frames MONITORS WIDTHxHEIGHT [trend]: the window at work with that many monitors, a bus at 1 ms in
// its own thread with eight devices whose words change, the dial, and the training line being polled; with
// `trend` also the trend, with the positions of all eight; then the same with an invisible window. Prints
// frames per second and the share of one core for both.
#include "app/window/buses/plant.h"
#include "app/window/kinds/interbus/ring_at_work.h"
#include "app/window/look/frame_clock.h"
#include "app/window/main_window.h"
#include "catalog/catalog.h"
#include "history/track.h"
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/simulator/training_bus.h"
#include "tests/bench/processor_time.h"
#include "widgets/messages/message_model.h"
#include "widgets/monitor/monitor_area.h"
#include "widgets/monitor/word_card.h"
#include "widgets/project/project_document.h"
#include "widgets/trend/trend_page.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QTemporaryDir>
#include <QTimer>

#include <cstdio>

namespace {

using namespace codewheel;
using namespace std::chrono_literals;

constexpr int movingWords = 8;
constexpr auto settling = 3s;
constexpr auto measured = 10s;

void letPass(std::chrono::milliseconds time)
{
    QEventLoop loop;
    QTimer::singleShot(time, Qt::PreciseTimer, &loop, &QEventLoop::quit);
    loop.exec();
}

// The processor time of the threads of window, bus and line together.
void measure(const char *what, RingSession &bus)
{
    letPass(settling);
    int frames = 0;
    const auto counting = QObject::connect(&bus, &RingSession::updated, [&frames] { ++frames; });
    const double usedBefore = bench::processorSeconds();
    QElapsedTimer clock;
    clock.start();
    letPass(measured);
    const double seconds = static_cast<double>(clock.nsecsElapsed()) * 1e-9;
    std::printf("%s: %.1f frames a second, %.1f %% of one core\n", what, frames / seconds,
                100 * (bench::processorSeconds() - usedBefore) / seconds);
    QObject::disconnect(counting);
}

// So that positions have a meaning and the disc turns.
void tell(EncoderSession &encoder)
{
    encoder.tell(Parameter::startUpMode, 1);
    encoder.tell(Parameter::steps, 8192);
    encoder.tell(Parameter::revolutions, 1);
    encoder.tell(Parameter::direction, 3);
}

// So short a time that its curves move with every frame.
void showTrend(MainWindow &window, const std::vector<Place> &places)
{
    for (const Place place : places)
        window.showInTrend({place, Channel::position, {}});
    TrendView &view = window.findChild<TrendPage *>()->view();
    view.zoom(std::chrono::duration<double>(settling) / std::chrono::duration<double>(SeenTime::usual));
}

} // namespace

int main(int argc, char **argv)
{
    QApplication application(argc, argv);
    const QStringList arguments = QApplication::arguments();
    const auto shown = static_cast<std::size_t>(arguments.value(1).toInt());
    const QStringList size = arguments.value(2).split(u'x');
    const QSize windowSize(size.value(0).toInt(), size.value(1).toInt());
    const bool hasTrend = arguments.value(3) == QLatin1String("trend");
    if (shown == 0 || shown > movingWords || windowSize.isEmpty()) {
        std::fprintf(stderr, "usage: bench_frames MONITORS WIDTHxHEIGHT [trend], with 1 to %d monitors\n",
                     movingWords);
        return 2;
    }
    const QTemporaryDir folder;
    const Catalog catalog = Catalog::builtIn();
    WindowSettings settings(folder.filePath(QStringLiteral("bench.ini")));
    MessageStore store({});
    MessageModel messages(store);
    ProjectDocument project;
    Plant plant(
        {.catalog = catalog,
         .project = project,
         .dataFolder = {},
         .clock = [] { return QDateTime::currentDateTime(); },
         .training = RingAtWork::MakeTraining{[](const Catalog &) { return makeMovingRing(movingWords); }}});
    plant.openTraining();
    RingSession &bus = *plant.first<RingAtWork>()->bus();
    MainWindow window(settings, project);
    window.attach(plant, messages);
    auto *monitors = window.findChild<MonitorArea *>();
    monitors->closeAll();
    const std::vector<Place> places = bus.places();
    for (const Place place : places)
        tell(*bus.encoder(place));
    for (std::size_t i = 0; i < shown; ++i)
        monitors->pin(places[i]);
    if (hasTrend)
        showTrend(window, places);
    window.resize(windowSize);
    window.show();
    plant.start();

    FrameClock frames;
    frames.setWindow(window);
    frames.start();

    std::printf("%zu monitors at %d x %d%s\n", shown, window.width(), window.height(),
                hasTrend ? ", and the trend of eight positions" : "");
    measure("at work", bus);
    window.hide();
    measure("at rest", bus);
    return 0;
}
