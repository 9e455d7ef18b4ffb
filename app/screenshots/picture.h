// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/kinds/training_window.h"

#include <QPixmap>
#include <QSize>
#include <QString>

#include <functional>
#include <vector>

namespace codewheel {

// A picture of the manual, of a window just started on a training bus of its own.
struct Picture
{
    using Look = std::function<void(QWidget &)>;

    QString name; // of the file, without its suffix
    QSize window;
    // Brings the window to what is worth showing, and passes on the widget.
    std::function<void(TrainingWindow &, const Look &)> show;

    bool isOfQuestion = false; // in front of the window

    QPixmap take(TrainingWindow &shown) const;
};

inline constexpr QSize usualWindow(1280, 800);

// `prepare` brings the window to what is worth showing, and returns the widget.
Picture pictureOf(const char *name, std::function<QWidget *(TrainingWindow &)> prepare,
                  QSize window = usualWindow);

// `ask` brings up a modal question, which is closed without an answer.
Picture pictureOfQuestion(const char *name, std::function<void(TrainingWindow &)> ask);

} // namespace codewheel
