// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/replay/replay_slider.h"

#include "vocabulary/freshness_text.h"
#include "widgets/look/describe.h"

#include <QSignalBlocker>

namespace codewheel {

ReplaySlider::ReplaySlider(Playback &playback, QWidget *parent)
    : QSlider(Qt::Horizontal, parent)
    , m_playback(playback)
{
    describe(this, "replayMoment", tr("Moment of the recording"),
             tr("Drag it to another moment of the recording. Left and Right: a hundredth of it; Page Up and "
                "Page Down: a tenth; Home and End"));
    setRange(0, parts);
    setSingleStep(parts / 100);
    setPageStep(parts / 10);
    connect(this, &QSlider::valueChanged, this, [this](int value) {
        const TimeSpan &span = m_playback.span();
        m_playback.jumpTo(span.from + (span.to - span.from) / parts * value +
                          (span.to - span.from) % parts * value / parts);
    });
    showMoment();
}

void ReplaySlider::showMoment()
{
    const TimeSpan &span = m_playback.span();
    const double length = static_cast<double>((span.to - span.from).count());
    const double passed = static_cast<double>((m_playback.position() - span.from).count());
    const QSignalBlocker byItself(this);
    if (!isSliderDown())
        setValue(length > 0 ? static_cast<int>(passed / length * parts) : 0);
    setAccessibleDescription(recordedText(m_playback.dateTime(m_playback.position())));
}

} // namespace codewheel
