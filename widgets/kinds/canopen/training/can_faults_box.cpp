// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/training/can_faults_box.h"

#include "can/simulator/simulated_can_adapter.h"
#include "kinds/canopen/simulator/simulated_canopen_plant.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/layouts.h"
#include "widgets/training/rate_fields.h"
#include "widgets/training/training_fields.h"

#include <QCheckBox>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace codewheel {

using namespace training_fields;

namespace {

// By row of the fields.
struct FaultRate
{
    int CanBusFaults::*count;
    CanAct act;
};
constexpr std::array faultRates{FaultRate{&CanBusFaults::lost, CanAct::framesLost},
                                FaultRate{&CanBusFaults::damaged, CanAct::framesDamaged},
                                FaultRate{&CanBusFaults::doubled, CanAct::framesDoubled},
                                FaultRate{&CanBusFaults::late, CanAct::framesLate}};

constexpr int mostThatIsSentAgain = 999; // of 1000: one has to get through

} // namespace

CanFaultsBox::CanFaultsBox(QWidget *parent)
    : QWidget(parent)
    , m_rates(new RateFields(
          {{tr("Lost frames"), tr("Of 1000 frames; acknowledged, but they reach nobody")},
           {tr("Destroyed frames"),
            tr("Of 1000 frames; an error frame destroys them, and they are sent again"), mostThatIsSentAgain},
           {tr("Doubled frames"), tr("Of 1000 frames; their sender sees an error, and sends them twice"),
            mostThatIsSentAgain},
           {tr("Late frames"),
            tr("Of 1000 frames; they and all that their sender has behind them come later")}},
          tr("How much later a late frame comes, in ms"), this))
    , m_busOff(new QPushButton(lineIcon(Icon::fault), tr("Bus off"), this))
{
    auto *column = layOut<QVBoxLayout>(this, grid::unit);
    column->addWidget(m_rates);
    m_alone = addBox(column, tr("Adapter alone"),
                     tr("Its cable is broken: nobody hears it, and nobody acknowledges what it sends"));
    m_unplugged =
        addBox(column, tr("Adapter unplugged"), tr("The adapter is gone until it is plugged in again"));
    m_busOff->setAutoDefault(false);
    m_busOff->setToolTip(
        tr("The adapter has seen too many errors, and leaves the bus until it is opened again"));
    column->addWidget(m_busOff);
    connect(m_rates, &RateFields::rateSet, this,
            [this](int row, int count) { setRate(static_cast<std::size_t>(row), count); });
    connect(m_rates, &RateFields::delaySet, this, &CanFaultsBox::setDelay);
    connect(m_alone, &QCheckBox::clicked, this, &CanFaultsBox::setAlone);
    connect(m_unplugged, &QCheckBox::clicked, this, &CanFaultsBox::setUnplugged);
    connect(m_busOff, &QPushButton::clicked, this, &CanFaultsBox::goBusOff);
}

// A field changes only when the bus has changed, so as not to undo what the user has just typed.
void CanFaultsBox::showBus(canopen::SimulatedCanopenPlant &plant,
                           const std::shared_ptr<SimulatedCanAdapter> &adapter)
{
    if (&plant != m_plant)
        m_shown.reset();
    m_plant = &plant;
    m_adapter = adapter;
    const CanBusFaults faults = plant.bus()->faults();
    if (m_shown != faults)
        showFaults(faults);
    m_shown = faults;
    m_unplugged->setChecked(adapter->isUnplugged());
    m_busOff->setEnabled(!adapter->isUnplugged() && !plant.bus()->errorsOf(*adapter).isBusOff());
}

void CanFaultsBox::showFaults(const CanBusFaults &faults)
{
    std::array<int, faultRates.size()> counts{};
    std::ranges::transform(faultRates, counts.begin(),
                           [&](const FaultRate &rate) { return faults.*rate.count; });
    m_rates->showRates(counts, std::chrono::duration_cast<std::chrono::milliseconds>(faults.delay));
    m_alone->setChecked(faults.brokenAfter.has_value());
}

void CanFaultsBox::change(const std::function<void(CanBusFaults &)> &how)
{
    CanBusFaults faults = m_plant->bus()->faults();
    how(faults);
    m_plant->bus()->setFaults(faults);
}

void CanFaultsBox::setRate(std::size_t row, int count)
{
    const FaultRate &rate = faultRates.at(row);
    change([&](CanBusFaults &faults) { faults.*rate.count = count; });
    Q_EMIT acted(canAct(rate.act, {std::int64_t{count}}));
}

void CanFaultsBox::setDelay(int milliseconds)
{
    change([&](CanBusFaults &faults) { faults.delay = std::chrono::milliseconds(milliseconds); });
}

// It was added behind all encoders.
void CanFaultsBox::setAlone(bool on)
{
    change([&](CanBusFaults &faults) {
        faults.brokenAfter = on ? std::optional(m_plant->participants()) : std::nullopt;
    });
    Q_EMIT acted(canAct(on ? CanAct::adapterAlone : CanAct::adapterNotAlone));
}

void CanFaultsBox::setUnplugged(bool on)
{
    m_adapter->setUnplugged(on);
    Q_EMIT acted(canAct(on ? CanAct::adapterUnplugged : CanAct::adapterPluggedIn));
}

void CanFaultsBox::goBusOff()
{
    m_plant->bus()->forceBusOff(*m_adapter);
    Q_EMIT acted(canAct(CanAct::adapterBusOff));
}

} // namespace codewheel
