// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/screenshots/picture.h"

#include <QApplication>
#include <QPropertyAnimation>
#include <QTimer>

#include <utility>

namespace codewheel {
namespace {

// What moves by the time of the computer, as the button that clears a field appears, has got there.
void endAnimations()
{
    for (const QWidget *window : QApplication::topLevelWidgets())
        for (auto *animation : window->findChildren<QPropertyAnimation *>())
            animation->setCurrentTime(animation->totalDuration());
}

// Layout and painting; which window is active, and what has the focus, comes from the window system, and what
// that changes comes behind it. One round is enough on some computers only.
void settle()
{
    constexpr int rounds = 10;
    for (int i = 0; i < rounds; ++i)
        QCoreApplication::processEvents();
    endAnimations();
}

} // namespace

QPixmap Picture::take(TrainingWindow &shown) const
{
    QPixmap taken;
    show(shown, [&taken](QWidget &seen) { taken = seen.grab(); });
    return taken;
}

Picture pictureOf(const char *name, std::function<QWidget *(TrainingWindow &)> prepare, QSize window)
{
    return {QString::fromLatin1(name), window,
            [prepare = std::move(prepare)](TrainingWindow &shown, const Picture::Look &look) {
                QWidget *seen = prepare(shown);
                settle();
                look(*seen);
            }};
}

// A question runs its own event loop until it is answered: the picture is taken from within it.
Picture pictureOfQuestion(const char *name, std::function<void(TrainingWindow &)> ask)
{
    return {QString::fromLatin1(name), usualWindow,
            [ask = std::move(ask)](TrainingWindow &shown, const Picture::Look &look) {
                QTimer watch;
                QObject::connect(&watch, &QTimer::timeout, &watch, [&] {
                    QWidget *question = QApplication::activeModalWidget();
                    if (question == nullptr)
                        return;
                    watch.stop();
                    settle();
                    look(*question);
                    question->close();
                });
                watch.start(0);
                ask(shown);
            },
            true};
}

} // namespace codewheel
