// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/trend/trend_view.h"

#include "widgets/look/describe.h"
#include "widgets/look/layouts.h"
#include "widgets/look/on_event.h"
#include "widgets/look/palettes.h"
#include "widgets/trend/trend_chart.h"

#include <QPainter>
#include <QScrollBar>
#include <QSignalBlocker>

#include <cmath>
#include <set>

namespace codewheel {
namespace {

constexpr int scrollSteps = 10'000;    // of all there is
constexpr unsigned framesPerLook = 15; // at what is known of the encoders

} // namespace

TrendView::TrendView(const Histories &histories, const TrendTracks &tracks, EncoderScales &scales,
                     std::function<QString(Place)> station, QWidget *parent)
    : QWidget(parent)
    , m_histories(histories)
    , m_tracks(tracks)
    , m_scales(scales)
    , m_maker(histories, tracks, scales, std::move(station))
    , m_chart(new TrendChart(this))
    , m_bar(new QScrollBar(Qt::Horizontal, this))
{
    describe(m_chart, "trendChart", tr("Trend"),
             tr("Wheel: zoom, with Shift scroll. Drag a box: zoom into it, with Ctrl scroll. Click: cursor "
                "A, with "
                "Shift cursor B."));
    m_chart->setToolTip({}); // it has its own for each place
    describe(m_bar, "trendTime", tr("Time shown"), tr("Scrolls through all the time that is kept"));
    layOutColumn(this, {{m_chart, 1}, m_bar}, {.spacing = 0, .margins = QMargins()});
    connect(m_chart, &TrendChart::spanWanted, this, &TrendView::showSpan);
    connect(m_chart, &TrendChart::zoomWanted, this, &TrendView::zoom);
    connect(m_chart, &TrendChart::scrollWanted, this, &TrendView::scroll);
    connect(m_chart, &TrendChart::cursorWanted, this, &TrendView::setCursor);
    connect(m_chart, &TrendChart::axisWanted, this, [this](std::size_t lane, double low, double high) {
        m_maker.fixAxis(m_scene.lanes.at(lane), low, high);
        showAnew();
    });
    connect(m_bar, &QScrollBar::valueChanged, this, &TrendView::scrollTo);
    connect(&tracks, &TrendTracks::changed, this, [this] {
        m_scales.look();
        showAnew();
    });
    connect(&histories, &Histories::marksChanged, this, &TrendView::showAnew);
    connect(&histories, &Histories::archivesChanged, this, [this] {
        m_scales.look();
        update([] {});
    });
    onEvent(this, {QEvent::PaletteChange}, [this] { showAnew(); });
}

// Of what is watched now, unless all curves are of recordings.
std::optional<TimeSpan> TrendView::timeOfCurves() const
{
    std::set<const Archive *> shown;
    for (const TrendTracks::Shown &one : m_tracks.shown())
        shown.insert(m_histories.archiveOf(one.track.place));
    const bool isWatched = shown.erase(nullptr) > 0 || shown.empty();
    std::optional<TimeSpan> all = isWatched ? m_histories.span() : std::nullopt;
    for (const Archive *archive : shown)
        if (const auto its = archive->span())
            all = all ? TimeSpan{std::min(all->from, its->from), std::max(all->to, its->to)} : *its;
    return all;
}

// The moment of the first recording that has a curve.
std::optional<Instant> TrendView::played() const
{
    for (const TrendTracks::Shown &one : m_tracks.shown())
        if (const Archive *archive = m_histories.archiveOf(one.track.place))
            if (const auto at = archive->played())
                return at;
    return {};
}

void TrendView::takeTime()
{
    const auto all = timeOfCurves();
    if (!all)
        return;
    const bool isWatched = std::ranges::any_of(m_tracks.shown(), [this](const TrendTracks::Shown &one) {
        return m_histories.archiveOf(one.track.place) == nullptr;
    });
    m_time.setAll(*all, isWatched ? all->to : played().value_or(all->to));
}

// Until the picture would have moved by a pixel, nothing changes, unless what is kept grows in the middle of
// it.
void TrendView::showFrame()
{
    if (m_frames++ % framesPerLook == 0 && m_scales.look()) {
        showAnew();
        Q_EMIT scalesChanged();
    }
    const TimeSpan before = m_time.span();
    const Instant grownFrom = m_time.all().to;
    m_time.setColumns(std::max(static_cast<int>(m_chart->plot().width() * devicePixelRatioF()), 1));
    takeTime();
    const Instant grownTo = m_time.all().to;
    const bool growsInSight = grownFrom < before.to && grownTo > before.from && grownTo != grownFrom;
    if (m_time.span() != before || (!m_time.follows() && growsInSight) || m_scene.played != played())
        showAnew();
    else
        showScrollBar();
}

void TrendView::showAnew()
{
    m_scene = m_maker.make(m_time.span(), palette());
    m_scene.cursors = m_cursors;
    m_scene.chosenCursor = m_chosenCursor;
    m_scene.played = played();
    m_chart->showScene(m_scene);
    showScrollBar();
}

void TrendView::update(const std::function<void()> &change)
{
    const bool followed = follows();
    takeTime();
    change();
    showAnew();
    if (follows() != followed)
        Q_EMIT followChanged(follows());
}

void TrendView::follow()
{
    update([this] { m_time.follow(); });
}

void TrendView::stopFollowing()
{
    update([this] { m_time.show(m_time.span()); });
}

void TrendView::showAll()
{
    m_maker.freeAxes();
    update([this] { m_time.showAll(); });
}

void TrendView::showSpan(const TimeSpan &span)
{
    update([&] { m_time.show(span); });
}

void TrendView::zoom(double factor, double at)
{
    update([=, this] { m_time.zoom(factor, at); });
}

void TrendView::scroll(double lengths)
{
    update([=, this] { m_time.scroll(lengths); });
}

void TrendView::reveal(Instant at)
{
    if (at < m_time.span().from || at >= m_time.span().to)
        showSpan({at - m_time.length() / 2, at + m_time.length() / 2});
}

void TrendView::setCursor(std::size_t cursor, Instant at)
{
    m_chosenCursor = cursor;
    m_cursors.at(cursor) = at;
    reveal(at);
    showAnew();
    Q_EMIT cursorsMoved();
}

void TrendView::removeCursors()
{
    m_cursors = {};
    m_chosenCursor = 0;
    showAnew();
    Q_EMIT cursorsMoved();
}

std::optional<Mark> TrendView::goToMark(bool forward)
{
    const Instant from =
        m_cursors.at(m_chosenCursor).value_or(forward ? m_time.span().from : m_time.span().to);
    const std::deque<Mark> &marks = m_histories.marks();
    const auto behind = std::ranges::upper_bound(marks, from, {}, &Mark::at);
    const auto at = std::ranges::lower_bound(marks, from, {}, &Mark::at);
    if (forward ? behind == marks.end() : at == marks.begin())
        return {};
    const Mark mark = forward ? *behind : *std::prev(at);
    setCursor(m_chosenCursor, mark.at);
    return mark;
}

void TrendView::showScrollBar()
{
    const QSignalBlocker quiet(m_bar);
    const auto all =
        static_cast<double>(std::max((m_time.all().to - m_time.all().from).count(), Instant::rep{1}));
    const double page = std::min(static_cast<double>(m_time.length().count()) / all, 1.0);
    const double at = static_cast<double>((m_time.span().from - m_time.all().from).count()) / all;
    const int pageSteps = std::max(static_cast<int>(page * scrollSteps), 1);
    m_bar->setPageStep(pageSteps);
    m_bar->setSingleStep(std::max(pageSteps / 10, 1));
    m_bar->setRange(0, scrollSteps - std::min(pageSteps, scrollSteps));
    m_bar->setValue(static_cast<int>(std::lround(std::clamp(at, 0.0, 1.0) * scrollSteps)));
}

void TrendView::scrollTo(int value)
{
    const auto all = static_cast<double>((m_time.all().to - m_time.all().from).count());
    const Instant from = m_time.all().from + Instant(std::llround(all * value / scrollSteps));
    value == m_bar->maximum() ? follow() : showSpan({from, from + m_time.length()});
}

// Twice, since how many labels there are depends on the room that they leave.
void TrendView::draw(QPainter &painter, QSize size) const
{
    const QPalette paper = paletteOf(Shade::light);
    TrendScene scene = m_maker.make(m_time.span(), paper);
    scene.cursors = m_cursors;
    scene.chosenCursor = m_cursors.size(); // none is highlighted
    TrendChart chart;
    chart.setPalette(paper);
    chart.resizeForPaper(size);
    chart.showScene(scene);
    chart.showScene(scene);
    chart.render(&painter, QRectF(QPointF(), size), QRect(QPoint(), size));
}

} // namespace codewheel
