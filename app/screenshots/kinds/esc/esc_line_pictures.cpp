// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/screenshots/kinds/esc/esc_line_pictures.h"

#include "app/screenshots/scene.h"
#include "catalog/device_description.h"
#include "kinds/esc/protocol/esc_request.h"
#include "widgets/connect/connect_page.h"
#include "widgets/kinds/esc/line/esc_line_search.h"
#include "widgets/kinds/esc/line/esc_line_settings_form.h"
#include "widgets/kinds/esc/line/esc_line_terminal.h"
#include "widgets/structure/structure_view.h"

#include <QAction>
#include <QDockWidget>

namespace codewheel {
namespace {

using namespace scene;

constexpr QSize tallLine(1280, 1150);
constexpr EscLineAddress turning{3};
constexpr EscLineAddress standing{5};
constexpr int untilRead = 3'000;    // ms
constexpr int untilFound = 20'000;  // ms
constexpr int someThousandths = 20; // of all bytes

void readAllOf(TrainingWindow &shown, EscLineAddress address)
{
    EncoderSession &encoder = *shown.line().session()->encoder(placeOnLine(address));
    if (encoder.start(ReadParameters{encoder.device().readableValues()}))
        shown.advance(untilRead);
}

// What the manual shows in it: a read, an alarm, and an imperfect line.
void typeSome(TrainingWindow &shown)
{
    EscLineSession &line = *shown.line().session();
    shown.line().training()->withEncoder(
        turning, [](SimulatedEscEncoder &encoder) { encoder.condition().batteryFlat = true; });
    for (const auto command : {esc::Command::serialNumber, esc::Command::alarms, esc::Command::warnings}) {
        line.send({turning, command, 0});
        shown.advance(whileMilliseconds);
    }
    EscLineFaults faults;
    faults.corrupted = someThousandths;
    shown.line().training()->setFaults(faults);
    shown.advance(untilRead);
}

QWidget *terminalAtWork(TrainingWindow &shown)
{
    typeSome(shown);
    shown.window().findChild<QAction *>(QStringLiteral("lineTerminal"))->trigger();
    shown.advance(whileMilliseconds);
    return dock(shown, "terminalDock");
}

QWidget *windowWithLine(TrainingWindow &shown)
{
    readAllOf(shown, turning);
    choose(shown, placeOnLine(turning));
    terminalAtWork(shown);
    return &shown.window();
}

QWidget *settingsAtWork(TrainingWindow &shown)
{
    shown.window().findChild<QAction *>(QStringLiteral("lineSettings"))->trigger();
    auto *form = shown.window().findChild<EscLineSettingsForm *>();
    form->setPorts(
        {{QStringLiteral("/dev/ttyUSB0"), QStringLiteral("FT232R USB UART"), QStringLiteral("A50285BI")}});
    EscLineSettings wish;
    wish.port = QStringLiteral("/dev/ttyUSB0"); // independent of this computer's ports
    form->setSettings(wish);
    shown.advance(whileMilliseconds);
    return shown.window().findChild<ConnectPage *>(QStringLiteral("lineSettings"));
}

QWidget *searchAtWork(TrainingWindow &shown)
{
    shown.window().findChild<QAction *>(QStringLiteral("lineSearch"))->trigger();
    auto *search = shown.window().findChild<EscLineSearch *>();
    press(*search, EscLineSearch::tr("&Search"));
    shown.advance(untilFound);
    return search;
}

} // namespace

std::vector<Picture> linePictures()
{
    return {
        pictureOf("line", windowWithLine),
        pictureOf("line-small", windowWithLine, {1024, 640}),
        pictureOf("line-terminal", terminalAtWork, tallLine),
        pictureOf(
            "line-figures",
            [](TrainingWindow &shown) {
                typeSome(shown);
                return dock(shown, "lineDock");
            },
            tallLine),
        pictureOf("line-settings", settingsAtWork),
        pictureOf("line-search", searchAtWork),
        pictureOf("line-parameters",
                  [](TrainingWindow &shown) {
                      choose(shown, placeOnLine(standing));
                      readAllOf(shown, standing);
                      return dock(shown, "parametersDock");
                  }),
        pictureOf(
            "training-line",
            [](TrainingWindow &shown) {
                QWidget *seen = dock(shown, "trainingDock");
                shown.window().findChild<StructureView *>()->choose(firstLine);
                shown.advance(whileMilliseconds);
                return seen;
            },
            tallLine),
    };
}

} // namespace codewheel
