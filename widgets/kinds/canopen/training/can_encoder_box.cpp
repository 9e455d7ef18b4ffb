// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/training/can_encoder_box.h"

#include "vocabulary/enumeration_rows.h"
#include "widgets/kinds/canopen/training/can_quirk_boxes.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"
#include "widgets/training/shaft_fields.h"
#include "widgets/training/training_fields.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>

#include <array>

namespace codewheel {

using namespace training_fields;

namespace {

using canopen::SimulatedNode;

struct TroubleRow
{
    NodeTrouble id;
    bool (*isThere)(const SimulatedNode &node);
    void (*put)(SimulatedNode &node, bool on);
    const char *toolTip;
};

std::uint16_t withBit(std::uint16_t bits, unsigned bit, bool on)
{
    const unsigned mask = 1U << bit;
    return static_cast<std::uint16_t>(on ? bits | mask : bits & ~mask);
}

// A bit of 6503h.
template <unsigned bit>
constexpr TroubleRow alarmBit(NodeTrouble trouble, const char *toolTip)
{
    return {trouble, [](const SimulatedNode &node) { return (node.alarms() >> bit & 1) != 0; },
            [](SimulatedNode &node, bool on) { node.setAlarms(withBit(node.alarms(), bit, on)); }, toolTip};
}

// A bit of 6505h.
template <unsigned bit>
constexpr TroubleRow warningBit(NodeTrouble trouble, const char *toolTip)
{
    return {trouble, [](const SimulatedNode &node) { return (node.warnings() >> bit & 1) != 0; },
            [](SimulatedNode &node, bool on) { node.setWarnings(withBit(node.warnings(), bit, on)); },
            toolTip};
}

constexpr std::array troubleRows{
    TroubleRow{NodeTrouble::powered, [](const SimulatedNode &node) { return node.isOn(); },
               [](SimulatedNode &node, bool on) { node.setOn(on); },
               QT_TRANSLATE_NOOP("codewheel::CanEncoderBox",
                                 "Supply of the encoder. It forgets what was not stored")},
    alarmBit<0>(
        NodeTrouble::positionError,
        QT_TRANSLATE_NOOP("codewheel::CanEncoderBox", "Alarm in 6503h, told by an emergency message")),
    alarmBit<12>(
        NodeTrouble::makersAlarm,
        QT_TRANSLATE_NOOP("codewheel::CanEncoderBox", "Alarm in 6503h, whose meaning only the maker tells")),
    warningBit<1>(NodeTrouble::lightReserve,
                  QT_TRANSLATE_NOOP("codewheel::CanEncoderBox", "Warning in 6505h")),
    warningBit<2>(NodeTrouble::cpuWatchdog,
                  QT_TRANSLATE_NOOP("codewheel::CanEncoderBox", "Warning in 6505h")),
    warningBit<4>(NodeTrouble::batteryLow, QT_TRANSLATE_NOOP("codewheel::CanEncoderBox", "Warning in 6505h")),
    TroubleRow{NodeTrouble::eepromBroken, [](const SimulatedNode &node) { return node.isEepromBroken(); },
               [](SimulatedNode &node, bool on) { node.setEepromBroken(on); },
               QT_TRANSLATE_NOOP("codewheel::CanEncoderBox", "Storing by 1010h is refused")},
};
static_assert(areInOrder(troubleRows, &TroubleRow::id, NodeTrouble::eepromBroken));

struct NodeNow
{
    ShaftFields::Shaft shaft;
    std::uint64_t writes = 0;
    std::array<bool, troubleRows.size()> troubles{};
    canopen::NodeQuirks quirks;
};

// Looking at its shaft makes it turn up to now, also where nothing is due on the bus.
NodeNow nodeNow(SimulatedNode &node)
{
    const TurningShaft &shaft = node.shaft();
    NodeNow now{.shaft = {.raw = shaft.raw(),
                          .stepsPerTurn = shaft.resolution().stepsPerTurn,
                          .turns = shaft.resolution().turns,
                          .revolutionsPerMinute = shaft.speed()},
                .writes = node.eepromWrites(),
                .quirks = node.quirks()};
    for (std::size_t row = 0; row < troubleRows.size(); ++row)
        now.troubles.at(row) = troubleRows.at(row).isThere(node);
    return now;
}

} // namespace

CanEncoderBox::CanEncoderBox(QWidget *parent)
    : QWidget(parent)
    , m_shaft(new ShaftFields(TurningShaft::fastest, this))
    , m_writes(numberLabel(tr("EEPROM writes"), this))
    , m_quirks(new CanQuirkBoxes(this))
{
    auto *writes = new QGridLayout;
    writes->setColumnStretch(1, 1);
    addNumber(writes, 0, tr("EEPROM writes"), m_writes);
    auto *column = layOut<QVBoxLayout>(this, grid::unit);
    column->addWidget(m_shaft);
    column->addLayout(writes);
    for (const TroubleRow &row : troubleRows) {
        m_troubles.push_back(addBox(column, nodeTroubleName(row.id), tr(row.toolTip)));
        connect(m_troubles.back(), &QCheckBox::clicked, this, [this, &row](bool on) { set(row.id, on); });
    }
    column->addWidget(m_quirks);
    connect(m_quirks, &CanQuirkBoxes::quirkSet, this, [this](const canopen::NamedQuirk &quirk, bool on) {
        change([&](Node &node) {
            canopen::NodeQuirks quirks = node.quirks();
            quirk.put(quirks, on);
            node.setQuirks(quirks);
        });
        Q_EMIT acted(nodeQuirkAct(quirk.key, on));
    });
    followShaft();
}

void CanEncoderBox::followShaft()
{
    connect(m_shaft, &ShaftFields::turned, this,
            [this](qint64 steps) { change([&](Node &node) { node.shaft().turnBy(steps); }); });
    connect(m_shaft, &ShaftFields::turnedTo, this, [this](int raw) {
        change([&](Node &node) { node.shaft().turnTo(raw); });
        Q_EMIT acted(canAct(CanAct::shaftTurnedTo, {std::int64_t{raw}}));
    });
    connect(m_shaft, &ShaftFields::speedSet, this, [this](double rpm) {
        change([&](Node &node) { node.shaft().setSpeed(rpm); });
        Q_EMIT acted(rpm == 0 ? canAct(CanAct::shaftStopped) : canAct(CanAct::shaftTurns, {rpm}));
    });
    connect(m_shaft, &ShaftFields::leftAlone, this,
            [this](qint64 raw) { Q_EMIT acted(canAct(CanAct::shaftTurnedByHand, {std::int64_t{raw}})); });
}

void CanEncoderBox::showEncoder(canopen::SimulatedCanopenPlant &plant, std::size_t which)
{
    m_plant = &plant;
    m_which = which;
    const NodeNow now = plant.withEncoder(which, nodeNow);
    m_shaft->showShaft(now.shaft);
    m_writes->setText(QLocale().toString(qulonglong{now.writes}));
    for (std::size_t row = 0; row < m_troubles.size(); ++row)
        m_troubles[row]->setChecked(now.troubles.at(row));
    m_quirks->showQuirks(now.quirks);
}

void CanEncoderBox::leave()
{
    m_shaft->leave();
}

void CanEncoderBox::set(NodeTrouble trouble, bool ticked)
{
    change([&](Node &node) { rowOf(troubleRows, trouble).put(node, ticked); });
    Q_EMIT acted(nodeTroubleAct(trouble, ticked));
}

void CanEncoderBox::change(const std::function<void(Node &)> &how)
{
    m_plant->withEncoder(m_which, how);
}

} // namespace codewheel
