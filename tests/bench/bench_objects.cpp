// SPDX-License-Identifier: GPL-3.0-or-later
// The view of the objects of a node with a file of 1300: the processor time until it is painted, beside that
// of a QTreeWidget with an item for each object of the same file.
#include "kinds/canopen/eds/device_file_reader.h"
#include "tests/bench/large_eds.h"
#include "tests/bench/processor_time.h"
#include "widgets/kinds/canopen/dictionary/dictionary_view.h"
#include "widgets/kinds/canopen/dictionary/object_texts.h"
#include "widgets/look/appearance.h"

#include <QApplication>
#include <QFile>
#include <QTemporaryDir>
#include <QTreeWidget>

#include <cstdio>
#include <functional>

namespace {

using namespace codewheel;

constexpr double allowed = 30; // ms
constexpr int rounds = 25;

void paint(QWidget &seen)
{
    QCoreApplication::sendPostedEvents();
    QCoreApplication::processEvents();
    seen.repaint();
}

double median(const char *name, const std::function<void()> &what)
{
    const bench::FrameTimes times = bench::timesOf(rounds, [&](int) { what(); });
    std::printf("%-44s median %6.2f ms, longest %6.2f ms\n", name, times.median, times.longest);
    return times.median;
}

void fill(QTreeWidget &tree, const canopen::DeviceFile &file)
{
    tree.clear();
    for (const canopen::FileObject &each : file.objects)
        tree.addTopLevelItem(new QTreeWidgetItem(
            {each.object.text(), each.name, each.type ? canopen::dataTypeKey(*each.type) : QString(),
             objectAccessText(each.access),
             each.factory ? objectValueText(*each.factory, each.type) : QString(), QString(), QString()}));
}

} // namespace

int main(int argc, char **argv)
{
    QApplication application(argc, argv);
    applyAppearance(application, {});
    const QByteArray bytes = bench::largeEds();
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("large.eds"));
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        return 1;
    file.close();

    DictionaryView view;
    view.resize(1200, 800);
    view.show();
    view.setNode(6);
    paint(view);
    bool isOpened = true;
    const double opened = median("file read, rows shown and painted", [&] {
        isOpened = isOpened && view.openFile(path);
        paint(view);
    });
    const double chosen = median("another node chosen, and this one again", [&] {
        view.setNode(5);
        view.setNode(6);
        paint(view);
    });

    QTreeWidget tree;
    tree.setColumnCount(7);
    tree.resize(1200, 800);
    tree.show();
    paint(tree);
    median("a QTreeWidget: file read, filled and painted", [&] {
        if (const auto read = canopen::readDeviceFile(bytes))
            fill(tree, *read);
        paint(tree);
    });
    std::printf("%d objects: %.1f and %.1f ms of %.0f ms\n", bench::largeEdsObjects, opened, chosen, allowed);
    return isOpened ? 0 : 1;
}
