// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "replay/playback.h"

#include <QSlider>

namespace codewheel {

// The whole span of a recording, and the moment of it that is shown; dragged, clicked or moved by keys it
// goes to another one.
class ReplaySlider final : public QSlider
{
    Q_OBJECT

public:
    explicit ReplaySlider(Playback &playback, QWidget *parent = nullptr);

    void showMoment();

private:
    static constexpr int parts = 10'000; // of the span

    Playback &m_playback;
};

} // namespace codewheel
