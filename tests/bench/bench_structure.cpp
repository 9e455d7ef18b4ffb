// SPDX-License-Identifier: GPL-3.0-or-later
// The structure editor with a project of 512 devices: the time to open it, and from each edit, undo and wheel
// step until it is painted. 60 frames a second allow 16 ms.
#include "catalog/catalog.h"
#include "kinds/interbus/ring/ring_edit.h"
#include "tests/bench/largest_project.h"
#include "tests/support/places.h"
#include "tests/support/plans.h"
#include "widgets/look/appearance.h"
#include "widgets/structure_editor/plan_model.h"
#include "widgets/structure_editor/structure_editor.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QScrollBar>
#include <QTreeView>

#include <algorithm>
#include <cstdio>

namespace {

using namespace codewheel;

constexpr double frame = 16; // ms
constexpr int repetitions = 60;

template <typename What>
void measure(const char *name, QWidget &seen, What what)
{
    std::vector<double> times;
    for (int i = 0; i < repetitions; ++i) {
        QElapsedTimer timer;
        timer.start();
        what(i);
        QCoreApplication::sendPostedEvents();
        QCoreApplication::processEvents();
        seen.repaint();
        times.push_back(static_cast<double>(timer.nsecsElapsed()) / 1e6);
    }
    std::ranges::sort(times);
    std::printf("%-28s median %6.2f ms, worst %6.2f ms of %.0f ms\n", name, times[times.size() / 2],
                times.back(), frame);
}

} // namespace

int main(int argc, char **argv)
{
    QApplication application(argc, argv);
    applyAppearance(application, {});
    const Catalog catalog = Catalog::builtIn();
    ProjectDocument document;
    StructureEditor editor(document, catalog);
    editor.resize(1200, 800);
    editor.show();
    QApplication::processEvents();
    const Project project = largestProject();

    QElapsedTimer timer;
    timer.start();
    document.setProject(project, {});
    QApplication::processEvents();
    editor.repaint();
    std::printf("%zu devices opened and painted: %.1f ms of 100 ms\n", project.devices.size(),
                static_cast<double>(timer.nsecsElapsed()) / 1e6);

    PlanEdits edits(document, catalog);
    auto *tree = editor.findChild<QTreeView *>();
    QScrollBar *bar = tree->verticalScrollBar();
    measure("scroll by a page", editor,
            [&](int i) { bar->setValue((i * bar->pageStep()) % std::max(1, bar->maximum())); });
    measure("edit a station", editor, [&](int i) {
        document.editDevice("4.7"_ring, {},
                            [&](ProjectDevice &device) { device.station = QString::number(i); });
    });
    measure("move first to last and back", editor, [&](int i) {
        const RingPlace place{.terminal = {}, .onLocalBus = false, .row = i % 2 == 0 ? 99U : 0U};
        (void)edits.move({document.ids(firstBus)[i % 2 == 0 ? 0 : 512 - localDevicesOfLargest - 1]},
                         KindData(place));
    });
    measure("remove a local bus and undo", editor, [&](int i) {
        if (i % 2 == 0)
            (void)edits.remove({document.ids(firstBus).front()});
        else
            document.undoStack().undo();
    });
    measure("insert at the front and undo", editor, [&](int i) {
        if (i == 0)
            (void)edits.remove({document.ids(firstBus)[1], document.ids(firstBus)[2]});
        if (i % 2 == 0)
            (void)edits.insert(deviceOf(0x0237), KindData(RingPlace{}));
        else
            document.undoStack().undo();
    });
    measure("addresses in words, in bytes", editor, [&](int i) {
        Project after = document.project();
        changeRing(after, [&](RingPlan &ring) {
            ring.addresses.unit = i % 2 == 0 ? AddressRules::Unit::word : AddressRules::Unit::byte;
        });
        document.edit(after, {});
    });
    return 0;
}
