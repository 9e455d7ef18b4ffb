// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/esc/training/esc_line_faults_box.h"

#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"
#include "widgets/training/rate_fields.h"
#include "widgets/training/training_fields.h"

#include <QCheckBox>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace codewheel {

using namespace training_fields;

namespace {

// By row of the fields.
struct LineRate
{
    int EscLineFaults::*count;
    LineAct act;
};
constexpr std::array lineRates{LineRate{&EscLineFaults::lost, LineAct::bytesLost},
                               LineRate{&EscLineFaults::corrupted, LineAct::bytesWrong},
                               LineRate{&EscLineFaults::doubled, LineAct::bytesDoubled},
                               LineRate{&EscLineFaults::delayed, LineAct::bytesDelayed}};

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
    , m_rates(new RateFields(
          {{tr("Lost bytes"), tr("Of 1000 bytes, both ways; they never arrive")},
           {tr("Wrong bytes"), tr("Of 1000 bytes, both ways; one bit is another")},
           {tr("Doubled bytes"), tr("Of 1000 bytes, both ways; they arrive twice")},
           {tr("Delayed bytes"), tr("Of 1000 bytes, both ways; they and all behind them come later")}},
          tr("How much later a delayed byte comes, in ms"), this))
{
    auto *column = layOut<QVBoxLayout>(this, grid::unit);
    column->addWidget(m_rates);
    m_echo = addBox(column, tr("Echo"), tr("The adapter hears what it sends: half duplex, as RS-485 may do"));
    m_silent = addBox(column, tr("All encoders silent"), tr("They receive and act, but do not answer"));
    m_unplugged =
        addBox(column, tr("Adapter unplugged"), tr("The port is gone until it is plugged in again"));
    connect(m_rates, &RateFields::rateSet, this,
            [this](int row, int count) { setRate(static_cast<std::size_t>(row), count); });
    connect(m_rates, &RateFields::delaySet, this, &EscLineFaultsBox::setDelay);
    connect(m_echo, &QCheckBox::clicked, this, &EscLineFaultsBox::setEcho);
    connect(m_silent, &QCheckBox::clicked, this, &EscLineFaultsBox::setSilent);
    connect(m_unplugged, &QCheckBox::clicked, this, &EscLineFaultsBox::setUnplugged);
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
    std::array<int, lineRates.size()> counts{};
    std::ranges::transform(lineRates, counts.begin(),
                           [&](const LineRate &rate) { return faults.*rate.count; });
    m_rates->showRates(counts, std::chrono::duration_cast<std::chrono::milliseconds>(faults.delay));
    m_echo->setChecked(faults.echo);
}

void EscLineFaultsBox::setRate(std::size_t row, int count)
{
    EscLineFaults faults = m_line->faults();
    faults.*lineRates.at(row).count = count;
    m_line->setFaults(faults);
    Q_EMIT acted(lineAct(lineRates.at(row).act, {std::int64_t{count}}));
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
