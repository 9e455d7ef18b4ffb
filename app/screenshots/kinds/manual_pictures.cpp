// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/screenshots/kinds/manual_pictures.h"

#include "app/screenshots/accessible_tree.h"
#include "app/screenshots/kinds/canopen/canopen_pictures.h"
#include "app/screenshots/kinds/esc/esc_line_pictures.h"
#include "app/screenshots/kinds/interbus/ring_pictures.h"
#include "app/screenshots/pictures.h"
#include "app/screenshots/scene.h"
#include "app/window/kinds/esc/esc_line_actions.h"
#include "app/window/kinds/interbus/ring_actions.h"
#include "bus/word_channel.h"
#include "kinds/interbus/ring/ring_session.h"
#include "widgets/cams/cam_editor.h"
#include "widgets/cams/cam_sheet.h"
#include "widgets/look/appearance.h"
#include "widgets/monitor/monitor_area.h"
#include "widgets/palette/command_palette.h"
#include "widgets/sequence/sequence_view.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTextBrowser>

#include <functional>

namespace codewheel {
namespace {

using namespace scene;

constexpr QSize smallest(1024, 640);
constexpr QSize tall(1280, 1150);
constexpr QSize low(1280, 690);

// FRABA manual 5.3, as words
const std::vector<Word> manualWords{0x0200'00FF, 0x0400'0001, 0x0600'0003,
                                    0x0800'0000, 0x8000'0000, 0x0000'0000};

void sendManualWords(TrainingWindow &shown)
{
    start(shown, fraba, SendWords{.words = manualWords});
}

QWidget *wholeWindow(TrainingWindow &shown)
{
    readAll(shown);
    want255(shown);
    sendManualWords(shown);
    shown.bus().channel(fraba)->stage(0x0200'00FF);
    shown.advance(whileMilliseconds);
    return &shown.window();
}

QWidget *monitorsAtWork(TrainingWindow &shown)
{
    send(shown, fraba, 0x0200'00FF);
    shown.bus().channel(fraba)->stage(0x0400'0001);
    shown.advance(whileMilliseconds);
    return shown.window().findChild<MonitorArea *>();
}

// The cam of FRABA manual 5.4.4 and a few more, one of them passing through zero, and what the encoder has.
CamProgram exampleCams()
{
    CamProgram program;
    program.cam = {
        Cam{0, 8'191, true},    Cam{6'000'000, 11'500'000, true}, Cam{12'000'000, 15'000'000, false},
        Cam{0x15, 0x213, true}, Cam{30'000'000, 3'000'000, true}, Cam{18'000'000, 26'000'000, true}};
    program.shift = 8;
    return program;
}

QWidget *camsAtWork(TrainingWindow &shown)
{
    readAll(shown);
    CamProgram there = exampleCams();
    there.cam.at(5) = {20'000'000, 26'000'000, true};
    shown.controls().turnTo(fraba.node, 7'654'321);
    start(shown, fraba,
          WriteCams{.programs = {there}, .onlyWhatDiffers = true, .afterwards = SwitchMode{Mode::cam, 1}},
          4 * whileMilliseconds);
    shown.window().showCams();
    CamProgram second = exampleCams();
    second.number = 2;
    second.cam.at(1) = {21'000'000, 2'000'000, true};
    auto *sheet = shown.window().findChild<CamSheet *>();
    sheet->document().setPrograms({exampleCams(), second}, {});
    sheet->setCurrent(5);
    shown.advance(whileMilliseconds);
    return shown.window().findChild<CamEditor *>();
}

QWidget *reportAtWork(TrainingWindow &shown)
{
    shown.project().editDevice(fraba, {}, [](ProjectDevice &device) {
        device.station = QStringLiteral("Crane 1, hoist");
        device.wanted = {{Parameter::steps, 8192}, {Parameter::direction, 3}, {Parameter::preset, 1000}};
        device.wantedCams = {exampleCams()};
    });
    readAll(shown);
    return reportOnPaper(shown);
}

QWidget *rodAtWork(TrainingWindow &shown)
{
    choose(shown, rod);
    start(shown, rod, ReadParameters{{Parameter::direction, Parameter::measuringLength}});
    shown.controls().setMagnetSpeed(rod.node, 20);
    shown.advance(whileMilliseconds);
    return dock(shown, "dialDock");
}

// Errors in one segment for some minutes, then the wire to the next device breaks.
QWidget *busFault(TrainingWindow &shown)
{
    constexpr int tenSeconds = 10'000;
    for (const int perThousand : {1, 3, 2, 0, 4, 7, 5, 12}) {
        shown.controls().setFault(TrainingFault::crcErrors, NodeId("3.0"), perThousand);
        shown.advance(tenSeconds);
    }
    choose(shown, {firstBus, NodeId("4.0")});
    shown.controls().setFault(TrainingFault::wireBreak, NodeId("4.0"), 1);
    shown.advance(whileMilliseconds);
    dock(shown, "messagesDock");
    return dock(shown, "masterDock");
}

QWidget *paletteAtWork(TrainingWindow &shown)
{
    readAll(shown);
    shown.window().actions().findCommand->trigger();
    auto *palette = shown.window().findChild<CommandPalette *>();
    palette->findChild<QLineEdit *>()->setText(QStringLiteral("fra"));
    while (!palette->isComplete())
        QCoreApplication::processEvents();
    return &shown.window();
}

// The question that comes before this function of the encoder.
Picture questionBefore(const char *name, const char *action)
{
    return pictureOfQuestion(name, [action](TrainingWindow &shown) {
        readAll(shown);
        shown.window().findChild<QAction *>(QLatin1String(action))->trigger();
    });
}

std::vector<Picture> views()
{
    return {
        pictureOf("window", wholeWindow),
        pictureOf("window-small", wholeWindow, smallest),
        pictureOf("monitors", monitorsAtWork),
        pictureOf("trace",
                  [](TrainingWindow &shown) {
                      sendManualWords(shown);
                      return dock(shown, "traceDock");
                  }),
        pictureOf("sequence",
                  [](TrainingWindow &shown) {
                      WordList list;
                      list.words = manualWords;
                      shown.window().findChild<SequenceView *>()->setList(list);
                      return dock(shown, "sequenceDock");
                  }),
        pictureOf("parameters",
                  [](TrainingWindow &shown) {
                      readAll(shown);
                      want255(shown);
                      return dock(shown, "parametersDock");
                  }),
        pictureOf("dial",
                  [](TrainingWindow &shown) {
                      shown.controls().setSpeed(fraba.node, 60);
                      readAll(shown);
                      return dock(shown, "dialDock");
                  }),
        pictureOf("palette", paletteAtWork, low),
        pictureOf("cams", camsAtWork, low),
        pictureOf("structure-editor", structureEditorAtWork),
        pictureOf("structure-insert", insertionAtWork),
        pictureOf("structure-small", offlineWindow, smallest),
        pictureOf("comparison", comparisonAtWork),
        pictureOf("report", reportAtWork),
        pictureOf("transfer", transferAtWork, low),
        pictureOf("replace", replacementAtWork, low),
        pictureOf("dial-rod", rodAtWork),
        pictureOf(
            "device",
            [](TrainingWindow &shown) {
                QWidget *seen = dock(shown, "deviceDock");
                QCoreApplication::processEvents();
                // A long page is laid out in idle time, which shows in its scroll bar.
                shown.window()
                    .findChild<QTextBrowser *>(QStringLiteral("devicePage"))
                    ->document()
                    ->pageCount();
                return seen;
            },
            tall),
        pictureOf("messages",
                  [](TrainingWindow &shown) {
                      readAll(shown);
                      send(shown, baumer, 0x0400'4E20);
                      send(shown, baumer, 0x8000'0000);
                      return dock(shown, "messagesDock");
                  }),
        pictureOf("master", busFault, tall),
        pictureOf("bus-fault",
                  [](TrainingWindow &shown) {
                      busFault(shown);
                      return &shown.window();
                  }),
        pictureOf(
            "start",
            [](TrainingWindow &shown) {
                shown.window().findChild<RingActions *>()->disconnectBus->trigger();
                shown.window().findChild<EscLineActions *>()->disconnectBus->trigger();
                shown.advance(whileMilliseconds);
                return &shown.window();
            },
            low),
        pictureOf(
            "why",
            [](TrainingWindow &shown) {
                busFault(shown);
                shown.window().actions().whyNoData->trigger();
                shown.advance(whileMilliseconds);
                return &shown.window();
            },
            low),
        pictureOf("training",
                  [](TrainingWindow &shown) {
                      shown.controls().setSpeed(fraba.node, 60);
                      shown.advance(whileMilliseconds);
                      return dock(shown, "trainingDock");
                  }),
        pictureOf("training-rod",
                  [](TrainingWindow &shown) {
                      rodAtWork(shown);
                      return dock(shown, "trainingDock");
                  }),
        pictureOf("parameters-rod",
                  [](TrainingWindow &shown) {
                      rodAtWork(shown);
                      return dock(shown, "parametersDock");
                  }),
        questionBefore("question-preset", "frabaPreset"),
        questionBefore("question-reset", "resetToDefault"),
    };
}

// A window for a picture, each after a first start.
class NewWindow
{
public:
    explicit NewWindow(QSize size)
        : shown(m_settings.filePath(QStringLiteral("picture.ini")), size)
    {
        shown.window().show();
        shown.advance(beforePicture);
    }

private:
    const QTemporaryDir m_settings;

public:
    TrainingWindow shown;
};

QPixmap take(const Picture &picture, QSize size, bool whole)
{
    NewWindow its(size);
    const QPixmap taken = picture.take(its.shown);
    return whole && !picture.isOfQuestion ? its.shown.window().grab() : taken;
}

// Light and dark, under different names.
bool inBothSchemes(QApplication &application, const std::function<bool(const QString &suffix)> &make)
{
    QApplication::setCursorFlashTime(0); // or a cursor would be there by chance
    bool saved = true;
    for (const Scheme scheme : {Scheme::light, Scheme::dark}) {
        applyAppearance(application, {.scheme = scheme, .largeControls = false, .lessMotion = true});
        saved = make(scheme == Scheme::dark ? QStringLiteral("-dark") : QString()) && saved;
    }
    return saved;
}

QString fileOf(const Picture &picture, const QString &suffix)
{
    return picture.name + suffix + QStringLiteral(".png");
}

} // namespace

std::vector<Picture> manualPictures()
{
    std::vector<Picture> pictures = views();
    for (const auto &more : {wizardPictures(), linePictures(), canopenPictures(), gatewayPictures(),
                             trendPictures(), recordingPictures(), offerPictures(), finderPictures()})
        pictures.insert(pictures.end(), more.begin(), more.end());
    return pictures;
}

bool makeManualPictures(QApplication &application, const QDir &folder)
{
    const std::vector<Picture> pictures = manualPictures();
    return inBothSchemes(application, [&](const QString &suffix) {
        bool saved = true;
        for (const Picture &picture : pictures)
            saved =
                take(picture, picture.window, false).save(folder.filePath(fileOf(picture, suffix))) && saved;
        return saved;
    });
}

bool makeReviewPictures(QApplication &application, const QDir &folder)
{
    const std::vector<Picture> pictures = manualPictures();
    return inBothSchemes(application, [&](const QString &suffix) {
        bool saved = true;
        for (const QSize size : {QSize(1024, 640), QSize(1280, 800), QSize(1920, 1080)}) {
            const QString name = QStringLiteral("%1x%2").arg(size.width()).arg(size.height());
            saved = folder.mkpath(name) && saved;
            for (const Picture &picture : pictures)
                saved = take(picture, size, true)
                            .save(QDir(folder.filePath(name)).filePath(fileOf(picture, suffix))) &&
                        saved;
        }
        return saved;
    });
}

bool makeAccessibleTrees(const QDir &folder)
{
    bool saved = true;
    for (const Picture &picture : manualPictures()) {
        NewWindow its(picture.window);
        QString tree;
        picture.show(its.shown, [&](QWidget &seen) {
            tree = accessibleTree(picture.isOfQuestion ? seen : *seen.window());
        });
        QFile file(folder.filePath(picture.name + QStringLiteral(".txt")));
        saved = file.open(QIODevice::WriteOnly) && file.write(tree.toUtf8()) > 0 && saved;
    }
    return saved;
}

} // namespace codewheel
