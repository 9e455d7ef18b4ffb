// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/screenshots/scene.h"

#include "bus/buses.h"
#include "bus/encoder_bus.h"
#include "bus/word_channel.h"
#include "catalog/device_description.h"
#include "widgets/look/label_text.h"
#include "widgets/parameters/wanted_values.h"
#include "widgets/structure/structure_view.h"

#include <QAbstractButton>
#include <QDockWidget>
#include <QPushButton>

namespace codewheel::scene {

QDockWidget *dock(TrainingWindow &shown, const char *name)
{
    auto *dock = shown.window().findChild<QDockWidget *>(QLatin1String(name));
    dock->raise();
    shown.advance(1);
    return dock;
}

void choose(TrainingWindow &shown, Place number)
{
    shown.window().findChild<StructureView *>()->choose(number);
}

void click(TrainingWindow &shown, const char *button)
{
    if (auto *found = shown.window().findChild<QAbstractButton *>(QLatin1String(button));
        found != nullptr && found->isEnabled())
        found->click();
    shown.advance(whileMilliseconds);
}

void press(QWidget &view, const QString &text)
{
    for (auto *button : view.findChildren<QPushButton *>())
        if (plainLabel(button->text()) == plainLabel(text) && button->isEnabled())
            button->click();
}

void start(TrainingWindow &shown, Place number, const Job &job, int milliseconds)
{
    if (shown.buses().encoder(number)->start(job))
        shown.advance(milliseconds);
}

void send(TrainingWindow &shown, Place number, Word word)
{
    WordChannel &channel = *shown.buses().busOf(number)->channel(number);
    channel.stage(word);
    if (channel.write())
        shown.advance(33);
}

void readAll(TrainingWindow &shown, Place number)
{
    start(shown, number, ReadParameters{shown.buses().encoder(number)->device().readableValues()});
}

void want255(TrainingWindow &shown)
{
    auto *wanted = shown.window().findChild<WantedValues *>();
    wanted->set(fraba, Parameter::steps, 255);
    wanted->set(fraba, Parameter::revolutions, 1);
    wanted->set(fraba, Parameter::direction, 3);
    wanted->set(fraba, Parameter::preset, 0);
}

} // namespace codewheel::scene
