// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/screenshots/picture.h"

#include <QApplication>
#include <QTimer>

#include <utility>

namespace codewheel {
namespace {

QPixmap grab(QWidget &seen)
{
    QCoreApplication::processEvents(); // what it waits for to be laid out and painted
    return seen.grab();
}

} // namespace

Picture pictureOf(const char *name, std::function<QWidget *(TrainingWindow &)> prepare, QSize window)
{
    return {QString::fromLatin1(name), window,
            [prepare = std::move(prepare)](TrainingWindow &shown) { return grab(*prepare(shown)); }};
}

// A question has an event loop of its own until it is answered: the picture is taken from within.
Picture pictureOfQuestion(const char *name, std::function<void(TrainingWindow &)> ask)
{
    return {QString::fromLatin1(name), usualWindow,
            [ask = std::move(ask)](TrainingWindow &shown) {
                QPixmap taken;
                QTimer watch;
                QObject::connect(&watch, &QTimer::timeout, &watch, [&] {
                    QWidget *question = QApplication::activeModalWidget();
                    if (question == nullptr)
                        return;
                    watch.stop();
                    taken = grab(*question);
                    question->close();
                });
                watch.start(0);
                ask(shown);
                return taken;
            },
            true};
}

} // namespace codewheel
