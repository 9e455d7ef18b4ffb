// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/screenshots/pictures.h"
#include "app/screenshots/scene.h"
#include "app/window/buses/plant.h"
#include "app/window/recording/recordings.h"
#include "recording/recorded_device.h"
#include "recording/recording_writer.h"
#include "widgets/look/inline_message.h"
#include "widgets/trend/trend_page.h"

#include <QFile>
#include <QTemporaryDir>

#include <cmath>

namespace codewheel {
namespace {

using namespace scene;
using namespace std::chrono_literals;

constexpr QSize forCurves(1280, 860);

// They are read while the pictures are taken.
QString inFolder(const QString &name)
{
    static const QTemporaryDir folder;
    return folder.filePath(name);
}

// What the ring shows while its shaft turns at these speeds, each for five seconds.
void record(TrainingWindow &shown, const QString &file, const std::vector<double> &speeds)
{
    RecordingPlan plan;
    plan.settings.file = file;
    QFile::remove(file);
    (void)shown.plant().recording().begin(plan);
    for (const double speed : speeds) {
        shown.controls().setSpeed(baumer.node, speed);
        shown.advance(5'000);
    }
    shown.plant().recording().end();
    shown.window().findChild<InlineMessage *>(QStringLiteral("notice"))->withdraw();
    shown.window().openRecording(file);
    shown.advance(100);
}

const Recordings::Open &opened(TrainingWindow &shown, std::size_t index)
{
    return shown.plant().recordings().all().at(index);
}

Place inRecording(TrainingWindow &shown, std::size_t index)
{
    return *opened(shown, index).shown(baumer);
}

QWidget *replayAtWork(TrainingWindow &shown)
{
    readAll(shown, baumer);
    record(shown, inFolder(QStringLiteral("night.cwrec")), {10, 30, 20});
    choose(shown, inRecording(shown, 0));
    opened(shown, 0).playback->jumpTo(opened(shown, 0).playback->span().from + 8s);
    shown.advance(100);
    return &shown.window();
}

// A shaft with these speeds in rpm, each for five seconds, from then on; written at once, whatever else the
// computer does.
void write(TrainingWindow &shown, const QString &file, Instant begin, const std::vector<double> &speeds)
{
    constexpr int valuesEach = 500;
    constexpr double stepsPerTurn = 8'192;
    QFile::remove(file);
    const auto writer = RecordingWriter::begin({.file = file, .begun = begin});
    if (!writer)
        return;
    const EncoderSession &encoder = *shown.buses().encoder(baumer);
    (*writer)->add(RecordedDescription{baumer, begin, toJson(recordedDevice(encoder))});
    RecordedValues values{baumer, {}};
    double position = 1'000'000;
    for (const double speed : speeds)
        for (int i = 0; i < valuesEach; ++i, position += speed * stepsPerTurn / 60 / 100)
            values.values.push_back({.at = begin + 10ms * values.values.size(),
                                     .position = std::llround(position),
                                     .stepsPerSecond = speed * stepsPerTurn / 60});
    (*writer)->add(values);
    (void)(*writer)->end();
    shown.window().openRecording(file);
    shown.advance(100);
}

// Two nights on top of each other: in the second one the shaft slips.
QWidget *recordingsCompared(TrainingWindow &shown)
{
    constexpr Instant evening = 1'772'488'800s; // 2 March 2026, 22:00 UTC
    readAll(shown, baumer);
    write(shown, inFolder(QStringLiteral("monday.cwrec")), evening, {10, 30, 30, 30, 10});
    write(shown, inFolder(QStringLiteral("tuesday.cwrec")), evening + 24h, {10, 30, 27, 30, 10});
    shown.window().showTrend();
    TrendPage &page = *shown.window().findChild<TrendPage *>();
    for (const std::size_t index : {0U, 1U}) {
        page.showTrack({inRecording(shown, index), Channel::speed, {}});
        page.showTrack({inRecording(shown, index), Channel::position, {}});
        page.tracks().setUnit(2 * index + 1, TrackUnit::turns);
    }
    page.tracks().move(2, 1);
    page.tracks().shareAxis(1, true);
    page.tracks().shareAxis(3, true);
    const Archive &monday = *opened(shown, 0).archive;
    Archive &tuesday = *opened(shown, 1).archive;
    tuesday.setShift(monday.span()->from - tuesday.span()->from);
    page.view().showAll();
    page.view().setCursor(0, evening + 12s);
    shown.advance(100);
    page.bringUpToDate();
    return &page;
}

} // namespace

std::vector<Picture> recordingPictures()
{
    return {pictureOf("replay", replayAtWork, forCurves),
            pictureOf("trend-recordings", recordingsCompared, forCurves)};
}

} // namespace codewheel
