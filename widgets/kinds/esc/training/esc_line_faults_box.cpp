// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/esc/training/esc_line_faults_box.h"

#include "widgets/input/number_fields.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"
#include "widgets/training/training_fields.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QSpinBox>
#include <QVBoxLayout>

namespace codewheel {

using namespace training_fields;

namespace {

constexpr int mostPerThousand = 1'000;
constexpr int longestDelay = 1'000; // ms

bool areAllMute(SimulatedEscLine &line)
{
    bool allMute = true;
    for (const EscLineAddress address : line.addresses())
        line.withEncoder(address, [&](const SimulatedEscEncoder &encoder) {
            allMute = allMute && encoder.condition().mute;
        });
    return allMute;
}

} // namespace

EscLineFaultsBox::EscLineFaultsBox(QWidget *parent)
    : QWidget(parent)
    , m_rates{{{&EscLineFaults::lost, tr("Lost bytes"), tr("Of 1000 bytes, both ways; they never arrive"),
                LineAct::bytesLost},
               {&EscLineFaults::corrupted, tr("Wrong bytes"),
                tr("Of 1000 bytes, both ways; one bit is another"), LineAct::bytesWrong},
               {&EscLineFaults::doubled, tr("Doubled bytes"),
                tr("Of 1000 bytes, both ways; they arrive twice"), LineAct::bytesDoubled},
               {&EscLineFaults::delayed, tr("Delayed bytes"),
                tr("Of 1000 bytes, both ways; they and all behind them come later"), LineAct::bytesDelayed}}}
    , m_delay(new IntegerField(this))
{
    auto *column = layOut<QVBoxLayout>(this, grid::unit);
    auto *fields = new QGridLayout;
    fields->setHorizontalSpacing(grid::groupGap);
    fields->setVerticalSpacing(grid::unit);
    fields->setColumnStretch(1, 1);
    makeRates(*fields);
    column->addLayout(fields);
    m_echo = addBox(column, tr("Echo"), tr("The adapter hears what it sends: half duplex, as RS-485 may do"));
    m_silent = addBox(column, tr("All encoders silent"), tr("They receive and act, but do not answer"));
    m_unplugged =
        addBox(column, tr("Adapter unplugged"), tr("The port is gone until it is plugged in again"));
    connect(m_echo, &QCheckBox::clicked, this, &EscLineFaultsBox::setEcho);
    connect(m_silent, &QCheckBox::clicked, this, &EscLineFaultsBox::setSilent);
    connect(m_unplugged, &QCheckBox::clicked, this, &EscLineFaultsBox::setUnplugged);
}

void EscLineFaultsBox::makeRates(QGridLayout &grid)
{
    int row = 0;
    for (Rate &rate : m_rates) {
        rate.field = new IntegerField(this);
        rate.field->setRange(0, mostPerThousand);
        prepare(rate.field, 5);
        describe(rate.field, tr("%1, of 1000").arg(rate.name), rate.toolTip);
        addCaption(&grid, row, tr("%1, of 1000").arg(rate.name), rate.field);
        grid.addWidget(rate.field, row++, 1);
        grid.addWidget(wrongInput(rate.field, this), row++, 0, 1, 2);
        connect(rate.field, &QSpinBox::valueChanged, this,
                [this, &rate](int count) { setRate(rate, count); });
    }
    m_delay->setRange(1, longestDelay);
    prepare(m_delay, 5);
    describe(m_delay, tr("Delay in ms"), tr("How much later a delayed byte comes, in ms"));
    addCaption(&grid, row, tr("Delay, ms"), m_delay);
    grid.addWidget(m_delay, row, 1);
    grid.addWidget(wrongInput(m_delay, this), row + 1, 0, 1, 2);
    connect(m_delay, &QSpinBox::valueChanged, this, &EscLineFaultsBox::setDelay);
}

// A field changes only when the line has changed, so as not to undo what the user has just typed.
void EscLineFaultsBox::showLine(SimulatedEscLine &line)
{
    if (&line != m_line)
        m_shown.reset();
    m_line = &line;
    const EscLineFaults faults = line.faults();
    if (m_shown != faults)
        showFaults(faults);
    m_shown = faults;
    m_silent->setChecked(areAllMute(line));
    m_unplugged->setChecked(line.isUnplugged());
}

void EscLineFaultsBox::showFaults(const EscLineFaults &faults)
{
    for (const Rate &rate : m_rates) {
        const QSignalBlocker silent(rate.field);
        rate.field->setValue(faults.*rate.count);
    }
    const QSignalBlocker silent(m_delay);
    m_delay->setValue(
        static_cast<int>(std::chrono::duration_cast<std::chrono::milliseconds>(faults.delay).count()));
    m_echo->setChecked(faults.echo);
}

void EscLineFaultsBox::setRate(const Rate &rate, int count)
{
    EscLineFaults faults = m_line->faults();
    faults.*rate.count = count;
    m_line->setFaults(faults);
    Q_EMIT acted(lineAct(rate.act, {std::int64_t{count}}));
}

void EscLineFaultsBox::setDelay(int milliseconds)
{
    EscLineFaults faults = m_line->faults();
    faults.delay = std::chrono::milliseconds(milliseconds);
    m_line->setFaults(faults);
}

void EscLineFaultsBox::setEcho(bool on)
{
    EscLineFaults faults = m_line->faults();
    faults.echo = on;
    m_line->setFaults(faults);
    Q_EMIT acted(lineAct(on ? LineAct::echoOn : LineAct::echoOff));
}

void EscLineFaultsBox::setSilent(bool on)
{
    m_line->setSilent(on);
    Q_EMIT acted(lineAct(on ? LineAct::allSilent : LineAct::allAnswer));
}

void EscLineFaultsBox::setUnplugged(bool on)
{
    m_line->setUnplugged(on);
    Q_EMIT acted(lineAct(on ? LineAct::adapterUnplugged : LineAct::adapterPluggedIn));
}

} // namespace codewheel
