// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "replay/playback.h"
#include "widgets/look/icons.h"

#include <QWidget>

class QAction;
class QComboBox;
class QKeySequence;
class QLabel;
class QToolBar;

namespace codewheel {

class InlineMessage;
class ReplaySlider;
class RoleLabel;

// What plays a recording: forward, backward, step by step, at any speed, and to any moment of its span. Its
// keys work in the whole window while it is shown.
class ReplayBar : public QWidget
{
    Q_OBJECT

public:
    // `playback` outlives it.
    explicit ReplayBar(Playback &playback, QWidget *parent = nullptr);

    // By its place in the recording: the one whose samples are stepped through; empty: those of all.
    void setEncoder(std::optional<Place> encoder) { m_encoder = encoder; }
    void showMoment();
    // What the program said then: shown until something else is passed, or the recording jumps.
    void tell(const QString &message);

Q_SIGNALS:
    void closeRequested();

private:
    QAction *addAction(Icon icon, const QString &text, const QKeySequence &key, const QString &tip);
    void makeTools();
    void makeSpeeds();
    void arrange();
    void step(Playback::Direction direction);
    void play(Playback::Direction direction);
    void changeSpeed(int by);
    void showState();
    void showProblem();

    Playback &m_playback;
    std::optional<Place> m_encoder;
    RoleLabel *m_what;
    QLabel *m_moment;
    QToolBar *m_tools;
    QAction *m_backward = nullptr;
    QAction *m_pause = nullptr;
    QAction *m_forward = nullptr;
    QComboBox *m_speed;
    ReplaySlider *m_slider;
    QLabel *m_from;
    QLabel *m_to;
    QLabel *m_told;
    int m_toldBefore = 0; // the jump
    InlineMessage *m_message;
    std::optional<Refusal> m_problem;
};

} // namespace codewheel
