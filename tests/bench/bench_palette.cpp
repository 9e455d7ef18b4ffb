// SPDX-License-Identifier: GPL-3.0-or-later
// The command palette of the window with a project of 512 devices, all actions, the manual and 10 000
// messages: the time until it is open and until it knows everything, and from each key until its picture. 60
// frames a second allow 16 ms.
#include "app/window/kinds/training_window.h"
#include "kinds/interbus/words/device_number.h"
#include "tests/bench/largest_project.h"
#include "widgets/look/appearance.h"
#include "widgets/palette/command_palette.h"

#include <QAction>
#include <QApplication>
#include <QElapsedTimer>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListView>
#include <QTemporaryDir>

#include <algorithm>
#include <cstdio>

namespace {

using namespace codewheel;

constexpr int messageTotal = 10'000;
constexpr double frame = 16; // ms

double milliseconds(const QElapsedTimer &clock)
{
    return static_cast<double>(clock.nsecsElapsed()) / 1e6;
}

void addMessages(MessageModel &messages)
{
    for (int i = 0; i < messageTotal; ++i)
        messages.addNow(
            {.place = Place{firstBus, DeviceNumber{i % 8 + 1, i % 63 + 1}.node()},
             .id = MessageId::parametersWritten,
             .arguments = {std::int64_t{1}, std::int64_t{1}, QStringLiteral("Steps = %1").arg(i)}});
    messages.catchUp();
}

void open(TrainingWindow &shown, CommandPalette &palette, const char *name)
{
    QElapsedTimer clock;
    clock.start();
    shown.window().actions().findCommand->trigger();
    palette.repaint();
    const double seen = milliseconds(clock);
    double longest = 0;
    while (!palette.isComplete()) {
        QElapsedTimer turn;
        turn.start();
        QCoreApplication::processEvents();
        longest = std::max(longest, milliseconds(turn));
    }
    std::printf("%s: seen after %.1f ms, all known after %.0f ms, longest turn %.1f ms\n", name, seen,
                milliseconds(clock), longest);
}

double press(QWidget &field, CommandPalette &palette, int key, const QString &text)
{
    QElapsedTimer clock;
    clock.start();
    QKeyEvent event(QEvent::KeyPress, key, Qt::NoModifier, text);
    QCoreApplication::sendEvent(&field, &event);
    QCoreApplication::sendPostedEvents();
    palette.repaint();
    return milliseconds(clock);
}

void type(CommandPalette &palette, const QString &text)
{
    auto *field = palette.findChild<QLineEdit *>();
    std::vector<double> times;
    for (const QChar letter : text)
        times.push_back(press(*field, palette, 0, letter));
    const int found = palette.findChild<QListView *>()->model()->rowCount();
    for (int i = 0; i < text.size(); ++i)
        times.push_back(press(*field, palette, Qt::Key_Backspace, {}));
    const double first = times.front();
    std::ranges::sort(times);
    std::printf("type and delete %-22s %5d found; the first key %5.2f ms, median %5.2f ms, worst %5.2f ms of "
                "%.0f ms\n",
                qUtf8Printable(u'"' + text + u'"'), found, first, times[times.size() / 2], times.back(),
                frame);
}

} // namespace

int main(int argc, char **argv)
{
    QApplication application(argc, argv);
    applyAppearance(application, {});
    const QTemporaryDir folder;
    TrainingWindow shown(folder.filePath(QStringLiteral("bench.ini")));
    for (const BusId bus : {firstBus, firstLine})
        shown.buses().open(bus)->close();
    shown.project().setProject(largestProject(), {});
    shown.window().show();
    shown.advance(100);
    addMessages(shown.messages());
    QApplication::processEvents();
    auto &palette = *shown.window().findChild<CommandPalette *>();
    open(shown, palette, "the first time");
    press(*palette.findChild<QLineEdit *>(), palette, Qt::Key_Escape, {});
    open(shown, palette, "again");
    for (const char *text : {"station 4.17", "parameters written", "e e e", "trend", "steps = 777", "xyzzy"})
        type(palette, QString::fromLatin1(text));
    return 0;
}
