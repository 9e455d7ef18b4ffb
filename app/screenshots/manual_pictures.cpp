// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/screenshots/manual_pictures.h"

#include "app/screenshots/project_pictures.h"
#include "app/screenshots/report_picture.h"
#include "app/window/training_window.h"
#include "ring/bus_session.h"
#include "ring/word_channel.h"
#include "widgets/cams/cam_editor.h"
#include "widgets/cams/cam_sheet.h"
#include "widgets/look/appearance.h"
#include "widgets/monitor/monitor_area.h"
#include "widgets/parameters/wanted_values.h"
#include "widgets/sequence/sequence_view.h"
#include "widgets/structure/structure_view.h"
#include "widgets/wizard/parameter_wizard.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QTemporaryDir>
#include <QTextBrowser>

#include <functional>
#include <vector>

namespace codewheel {
namespace {

constexpr DeviceNumber fraba{1, 0};
constexpr DeviceNumber baumer{2, 0};
constexpr DeviceNumber rod{5, 0};
constexpr QSize usual(1280, 800);
constexpr QSize smallest(1024, 640);
constexpr QSize tall(1280, 1150);
constexpr QSize low(1280, 690);
constexpr int whileMilliseconds = 600; // until what was asked for is done

// What a picture shows of a window at work.
struct Picture
{
    QString name;
    QSize size;
    std::function<QWidget *(TrainingWindow &)> prepare; // answers what is to be seen
};

QDockWidget *dock(TrainingWindow &shown, const QString &name)
{
    auto *dock = shown.window().findChild<QDockWidget *>(name);
    dock->raise();
    shown.advance(1);
    return dock;
}

void send(TrainingWindow &shown, DeviceNumber number, Word word)
{
    WordChannel &channel = *shown.bus().channel(number);
    channel.stage(word);
    if (channel.write())
        shown.advance(33);
}

void readAll(TrainingWindow &shown)
{
    EncoderSession &encoder = *shown.bus().encoder(fraba);
    if (encoder.start(ReadParameters{encoder.device().readableValues()}))
        shown.advance(whileMilliseconds);
}

void want255(TrainingWindow &shown)
{
    auto *wanted = shown.window().findChild<WantedValues *>();
    wanted->set(fraba, Parameter::steps, 255);
    wanted->set(fraba, Parameter::revolutions, 1);
    wanted->set(fraba, Parameter::direction, 3);
    wanted->set(fraba, Parameter::preset, 0);
}

// FRABA manual 5.3, as words
const std::vector<Word> manualWords{0x0200'00FF, 0x0400'0001, 0x0600'0003,
                                    0x0800'0000, 0x8000'0000, 0x0000'0000};

void sendManualWords(TrainingWindow &shown)
{
    if (shown.bus().encoder(fraba)->start(SendWords{.words = manualWords}))
        shown.advance(whileMilliseconds);
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

void click(TrainingWindow &shown, const QString &button)
{
    if (auto *found = shown.window().findChild<QAbstractButton *>(button);
        found != nullptr && found->isEnabled())
        found->click();
    shown.advance(whileMilliseconds);
}

// The way through the wizard, as far as the page that is wanted.
QWidget *wizardAt(TrainingWindow &shown, ParameterWizard::Page page)
{
    shown.window().showWizard();
    auto *wizard = shown.window().findChild<ParameterWizard *>();
    want255(shown);
    while (wizard->page() < page) {
        if (wizard->page() == ParameterWizard::known)
            click(shown, QStringLiteral("readAll"));
        if (wizard->page() == ParameterWizard::handshake)
            while (wizard->isBusy())
                click(shown, QStringLiteral("nextStep"));
        click(shown, QStringLiteral("wizardNext"));
    }
    return wizard;
}

Picture wizardPicture(const QString &name, ParameterWizard::Page page)
{
    return {name, usual, [page](TrainingWindow &shown) { return wizardAt(shown, page); }};
}

QWidget *handshakeHalfWay(TrainingWindow &shown)
{
    QWidget *wizard = wizardAt(shown, ParameterWizard::handshake);
    click(shown, QStringLiteral("nextStep"));
    return wizard;
}

// The cam of FRABA manual 5.4.4 and some more, one of them through zero, and what the encoder has.
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
    shown.controls().turnTo(fraba, 7'654'321);
    if (shown.bus().encoder(fraba)->start(
            WriteCams{.programs = {there}, .onlyWhatDiffers = true, .afterwards = SwitchMode{Mode::cam, 1}}))
        shown.advance(4 * whileMilliseconds);
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

QWidget *rodAtWork(TrainingWindow &shown)
{
    EncoderSession &encoder = *shown.bus().encoder(rod);
    shown.window().findChild<StructureView *>()->choose(rod);
    encoder.tell(Parameter::rodLength, 500'000); // micrometres
    if (encoder.start(ReadParameters{{Parameter::direction, Parameter::measuringLength}}))
        shown.advance(whileMilliseconds);
    shown.controls().setMagnetSpeed(rod, 20);
    shown.advance(whileMilliseconds);
    return dock(shown, QStringLiteral("dialDock"));
}

void wantSomething(TrainingWindow &shown, DeviceNumber number, const ParameterValues &values)
{
    shown.project().editDevice(number, QString(), [&](ProjectDevice &device) { device.wanted = values; });
}

QWidget *transferAtWork(TrainingWindow &shown)
{
    readAll(shown);
    wantSomething(shown, fraba, {{Parameter::steps, 4096}, {Parameter::revolutions, 1}});
    wantSomething(shown, baumer, {{Parameter::steps, 4096}, {Parameter::coding, 6}});
    wantSomething(shown, rod, {{Parameter::measuringLength, 50'000}, {Parameter::direction, 1}});
    shown.window().actions().transfer->trigger();
    shown.advance(whileMilliseconds);
    return &shown.window();
}

QWidget *replacementAtWork(TrainingWindow &shown)
{
    wantSomething(shown, fraba, {{Parameter::steps, 4096}, {Parameter::revolutions, 1}});
    shown.controls().setPower(fraba, false);
    shown.advance(2 * whileMilliseconds + whileMilliseconds);
    shown.controls().setPower(fraba, true);
    shown.advance(whileMilliseconds);
    shown.window().actions().replaceEncoder->trigger();
    auto *next = shown.window().findChild<QAbstractButton *>(QStringLiteral("replaceNext"));
    next->click();
    next->click();
    shown.advance(33);
    return &shown.window();
}

std::vector<Picture> pictures()
{
    return {
        {QStringLiteral("window"), usual, wholeWindow},
        {QStringLiteral("window-small"), smallest, wholeWindow},
        {QStringLiteral("monitors"), usual, monitorsAtWork},
        {QStringLiteral("trace"), usual,
         [](TrainingWindow &shown) {
             sendManualWords(shown);
             return dock(shown, QStringLiteral("traceDock"));
         }},
        {QStringLiteral("sequence"), usual,
         [](TrainingWindow &shown) {
             WordList list;
             list.words = manualWords;
             shown.window().findChild<SequenceView *>()->setList(list);
             return dock(shown, QStringLiteral("sequenceDock"));
         }},
        wizardPicture(QStringLiteral("wizard-known"), ParameterWizard::known),
        wizardPicture(QStringLiteral("wizard-values"), ParameterWizard::values),
        wizardPicture(QStringLiteral("wizard-review"), ParameterWizard::review),
        {QStringLiteral("wizard-handshake"), usual, handshakeHalfWay},
        wizardPicture(QStringLiteral("wizard-report"), ParameterWizard::report),
        {QStringLiteral("parameters"), usual,
         [](TrainingWindow &shown) {
             readAll(shown);
             want255(shown);
             return dock(shown, QStringLiteral("parametersDock"));
         }},
        {QStringLiteral("dial"), usual,
         [](TrainingWindow &shown) {
             shown.controls().setSpeed(fraba, 60);
             readAll(shown);
             return dock(shown, QStringLiteral("dialDock"));
         }},
        {QStringLiteral("cams"), low, camsAtWork},
        {QStringLiteral("structure-editor"), usual, structureEditorAtWork},
        {QStringLiteral("structure-insert"), usual, insertionAtWork},
        {QStringLiteral("structure-small"), smallest, offlineWindow},
        {QStringLiteral("comparison"), usual, comparisonAtWork},
        {QStringLiteral("report"), usual,
         [](TrainingWindow &shown) {
             shown.project().editDevice(fraba, {}, [](ProjectDevice &device) {
                 device.station = QStringLiteral("Crane 1, hoist");
                 device.wanted = {
                     {Parameter::steps, 8192}, {Parameter::direction, 3}, {Parameter::preset, 1000}};
                 device.wantedCams = {exampleCams()};
             });
             readAll(shown);
             return reportOnPaper(shown);
         }},
        {QStringLiteral("transfer"), low, transferAtWork},
        {QStringLiteral("replace"), low, replacementAtWork},
        {QStringLiteral("dial-rod"), usual, rodAtWork},
        {QStringLiteral("device"), tall,
         [](TrainingWindow &shown) {
             QWidget *seen = dock(shown, QStringLiteral("deviceDock"));
             QCoreApplication::processEvents();
             // a long page is laid out bit by bit as time allows; the scroll bar tells how far
             shown.window().findChild<QTextBrowser *>(QStringLiteral("devicePage"))->document()->pageCount();
             return seen;
         }},
        {QStringLiteral("messages"), usual,
         [](TrainingWindow &shown) {
             readAll(shown);
             send(shown, baumer, 0x0400'4E20);
             send(shown, baumer, 0x8000'0000);
             return dock(shown, QStringLiteral("messagesDock"));
         }},
        {QStringLiteral("training"), usual,
         [](TrainingWindow &shown) {
             shown.controls().setSpeed(fraba, 60);
             shown.advance(whileMilliseconds);
             return dock(shown, QStringLiteral("trainingDock"));
         }},
        {QStringLiteral("training-rod"), usual,
         [](TrainingWindow &shown) {
             rodAtWork(shown);
             return dock(shown, QStringLiteral("trainingDock"));
         }},
        {QStringLiteral("parameters-rod"), usual,
         [](TrainingWindow &shown) {
             rodAtWork(shown);
             return dock(shown, QStringLiteral("parametersDock"));
         }},
    };
}

bool save(const Picture &picture, const QDir &folder, const QString &suffix)
{
    const QTemporaryDir settings; // each picture is of a first start
    TrainingWindow shown(settings.filePath(QStringLiteral("picture.ini")));
    shown.window().resize(picture.size);
    shown.window().show();
    shown.advance(99);
    QWidget *seen = picture.prepare(shown);
    QCoreApplication::processEvents();
    return seen->grab().save(folder.filePath(picture.name + suffix + QStringLiteral(".png")));
}

} // namespace

bool makeManualPictures(QApplication &application, const QDir &folder)
{
    QApplication::setCursorFlashTime(0); // a cursor is there or not, by chance
    bool saved = true;
    for (const Scheme scheme : {Scheme::light, Scheme::dark}) {
        applyAppearance(application, {.scheme = scheme, .largeControls = false, .lessMotion = true});
        const QString suffix = scheme == Scheme::dark ? QStringLiteral("-dark") : QString();
        for (const Picture &picture : pictures())
            saved = save(picture, folder, suffix) && saved;
    }
    return saved;
}

} // namespace codewheel
