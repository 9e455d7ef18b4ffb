// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/screenshots/pictures.h"
#include "app/screenshots/scene.h"
#include "app/window/buses/plant.h"
#include "widgets/trend/trend_page.h"

namespace codewheel {
namespace {

using namespace scene;
using namespace std::chrono_literals;

constexpr QSize roomy(1280, 860);
constexpr Place multiTurn{firstBus, NodeId("4.0")};

TrendPage &trend(TrainingWindow &shown)
{
    shown.window().showTrend();
    return *shown.window().findChild<TrendPage *>();
}

void show(TrendPage &page, const Track &track, TrackUnit unit = TrackUnit::steps, bool sharesAxis = false)
{
    page.showTrack(track);
    page.tracks().setUnit(page.tracks().shown().size() - 1, unit);
    page.tracks().shareAxis(page.tracks().shown().size() - 1, sharesAxis);
}

// A shaft that stands, turns, and slips for a moment; beside it one whose position is preset.
QWidget *trendAtWork(TrainingWindow &shown)
{
    readAll(shown);
    TrendPage &page = trend(shown);
    show(page, {baumer, Channel::position, {}}, TrackUnit::turns);
    show(page, {baumer, Channel::speed, {}}, TrackUnit::turns);
    show(page, {fraba, Channel::position, {}}, TrackUnit::degrees);
    shown.controls().setSpeed(fraba.node, 2);
    for (const double speed : {10.0, 30.0, 30.0, 29.0, 30.0, 0.0, -20.0, -20.0}) {
        shown.controls().setSpeed(baumer.node, speed);
        shown.advance(5'000);
    }
    start(shown, fraba, SetPreset{.value = 100});
    shown.advance(3'000);
    const Instant now = shown.plant().histories().span()->to;
    shown.plant().histories().note(now - 27s, QStringLiteral("17 t"));
    page.view().setCursor(0, now - 34s);
    page.view().setCursor(1, now - 14s);
    shown.advance(100);
    page.bringUpToDate();
    return &page;
}

// The words of a handshake bit by bit, and two shafts on one axis.
QWidget *bitsAtWork(TrainingWindow &shown)
{
    readAll(shown);
    TrendPage &page = trend(shown);
    show(page, {baumer, Channel::position, {}}, TrackUnit::turns);
    show(page, {multiTurn, Channel::position, {}}, TrackUnit::turns, true);
    show(page, {fraba, Channel::out, {}});
    for (const unsigned bit : {31U, 28U, 27U, 26U, 25U})
        show(page, {fraba, Channel::out, bit});
    show(page, {fraba, Channel::in, 31});
    shown.advance(500);
    for (const Word word : {0x0200'00FFU, 0x0400'0001U, 0x0600'0003U, 0x0800'0000U, 0x8000'0000U, 0U})
        send(shown, fraba, word);
    shown.advance(500);
    const Instant now = shown.plant().histories().span()->to;
    page.view().showSpan({now - 1s - 500ms, now});
    shown.advance(100);
    page.bringUpToDate();
    return &page;
}

} // namespace

std::vector<Picture> trendPictures()
{
    return {pictureOf("trend", trendAtWork, roomy), pictureOf("trend-bits", bitsAtWork, roomy)};
}

} // namespace codewheel
