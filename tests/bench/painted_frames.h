// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <QEvent>
#include <QGraphicsView>

namespace codewheel::bench {

// Lets the view lay out and paint what has changed; ends the program if it paints nothing, since then nothing
// is measured.
inline void paint(QWidget &viewport)
{
    struct Painted : QObject
    {
        bool eventFilter(QObject *, QEvent *event) override
        {
            isSeen = isSeen || event->type() == QEvent::Paint;
            return false;
        }
        bool isSeen = false;
    } painted;
    viewport.installEventFilter(&painted);
    for (int turn = 0; turn < 100 && !painted.isSeen; ++turn)
        QApplication::processEvents();
    if (!painted.isSeen)
        qFatal("nothing was painted");
}

} // namespace codewheel::bench
