// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/trend/scene_maker.h"
#include "widgets/trend/seen_time.h"

#include <QWidget>

class QPainter;
class QScrollBar;

namespace codewheel {

class TrendChart;

// The chart of a trend over the time there is: follows what comes, scrolls and zooms, has two cursors.
class TrendView : public QWidget
{
    Q_OBJECT

public:
    // All outlive it.
    TrendView(const Histories &histories, const TrendTracks &tracks, EncoderScales &scales,
              std::function<QString(Place)> station, QWidget *parent = nullptr);

    const TrendScene &scene() const { return m_scene; }
    TrendChart &chart() const { return *m_chart; }

    // All there is of the encoders and recordings whose curves are shown; nothing: nothing is kept.
    std::optional<TimeSpan> timeOfCurves() const;

    // Takes what came since the last frame.
    void showFrame();
    // The same part of the time, with what else has changed.
    void showAnew();
    bool follows() const { return m_time.follows(); }
    void follow();
    void stopFollowing(); // where it is
    void showAll();       // of the time there is; axes fit again
    void showSpan(const TimeSpan &span);
    void zoom(double factor, double at = 0.5);
    void scroll(double lengths);
    // Scrolls there if it is not seen.
    void reveal(Instant at);

    void setCursor(std::size_t cursor, Instant at);
    void removeCursors();
    // The mark before or after the chosen cursor, which goes there; nothing: there is none.
    std::optional<Mark> goToMark(bool forward);

    // What is seen, in light colours, as for paper.
    void draw(QPainter &painter, QSize size) const;

Q_SIGNALS:
    void cursorsMoved();
    void scalesChanged(); // other units, and so other values
    void followChanged(bool follows);

private:
    std::optional<Instant> played() const;
    void takeTime();
    void update(const std::function<void()> &change);
    void showScrollBar();
    void scrollTo(int value);

    const Histories &m_histories;
    const TrendTracks &m_tracks;
    EncoderScales &m_scales;
    SceneMaker m_maker;
    SeenTime m_time;
    TrendScene m_scene;
    TrendChart *m_chart;
    QScrollBar *m_bar;
    std::array<std::optional<Instant>, 2> m_cursors{};
    std::size_t m_chosenCursor = 0;
    unsigned m_frames = 0;
};

} // namespace codewheel
