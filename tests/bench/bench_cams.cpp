// SPDX-License-Identifier: GPL-3.0-or-later
// Dragging in the cam editor's board, with all 8 programs of 8 cams set and in sight: the time from a mouse
// move until ruler, table and overview are repainted.
#include "widgets/cams/cam_board.h"
#include "widgets/cams/cam_ruler.h"
#include "widgets/look/appearance.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QMouseEvent>

#include <algorithm>
#include <cstdio>

namespace {

using namespace codewheel;

constexpr std::int64_t largest = 33'554'431;
constexpr QSize boardSize(1200, 600);
constexpr int warmUp = 50;
constexpr int movements = 1'000;

void setAllCams(CamDocument &document)
{
    std::vector<CamProgram> all;
    for (unsigned number = 1; number <= CamProgram::programs; ++number) {
        CamProgram program{.number = number};
        for (std::size_t cam = 0; cam < CamProgram::cams; ++cam) {
            const auto start = (std::int64_t{number} * 8 + static_cast<std::int64_t>(cam)) * 500'009;
            program.cam.at(cam) = {start, (start * 7 + 3'000'000) % (largest + 1), true};
        }
        all.push_back(program);
    }
    document.setPrograms(all, {});
}

void mouse(CamRuler &ruler, QEvent::Type type, int x)
{
    const QPointF at(x, ruler.rowRect(0).center().y());
    const Qt::MouseButton button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
    QMouseEvent event(type, at, ruler.mapToGlobal(at), button, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&ruler, &event);
}

} // namespace

int main(int argc, char **argv)
{
    QApplication application(argc, argv);
    applyAppearance(application, {});
    ProjectDocument project;
    CamSheet sheet(project);
    sheet.setLargest(largest);
    setAllCams(sheet.document());
    CamBoard board(sheet);
    board.resize(boardSize);
    board.show();
    QApplication::processEvents();

    auto *ruler = board.findChild<CamRuler *>();
    const auto middle = static_cast<double>(sheet.cam(0).start + sheet.cam(0).stop) / 2;
    const int from = qRound(ruler->scale().x(middle));
    mouse(*ruler, QEvent::MouseButtonPress, from);
    std::vector<double> times;
    for (int i = 0; i < warmUp + movements; ++i) {
        QElapsedTimer clock;
        clock.start();
        mouse(*ruler, QEvent::MouseMove, from + i % 300);
        CamLive live{.on = {}, .isTold = true, .position = CamLive::Position{i, i}};
        for (std::size_t cam = 0; cam < live.on.size(); ++cam)
            live.on.at(cam) = ((i >> cam) & 1) != 0;
        sheet.setLive(live);
        QApplication::processEvents();
        if (i >= warmUp)
            times.push_back(static_cast<double>(clock.nsecsElapsed()) * 1e-6);
    }
    mouse(*ruler, QEvent::MouseButtonRelease, from);
    std::ranges::sort(times);
    std::printf("64 cams, %d movements: median %.2f ms a frame, 99 %% below %.2f ms, longest %.2f ms\n",
                movements, times[times.size() / 2], times[times.size() * 99 / 100], times.back());
    return 0;
}
