// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/freshness.h"

#include <QTimer>

namespace codewheel {

// Ticks once a second while what a view shows is old, so that its age goes on. Used by the dials, the
// monitors and the cam editor.
class AgeTimer : public QTimer
{
public:
    explicit AgeTimer(QObject *parent)
        : QTimer(parent)
    {
        setInterval(std::chrono::seconds(1));
    }

    void follow(const Freshness &shown)
    {
        if (!shown.isOld())
            stop();
        else if (!isActive())
            start();
    }
};

} // namespace codewheel
