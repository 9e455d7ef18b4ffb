// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/interbus/master/ring_plan_fields.h"

#include "kinds/interbus/plan/process_addresses.h"
#include "kinds/interbus/plan/project_take_over.h"
#include "kinds/interbus/ring/cycle_time.h"
#include "kinds/interbus/ring/ring_rules.h"
#include "widgets/input/number_fields.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"
#include "widgets/look/wrapped_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

namespace codewheel {
namespace {

QString cycleTimeText(MicrosecondsOnTheWire time)
{
    return QLocale().toString(time.count() / 1000, 'f', 2);
}

QLabel *labelOf(const QString &text, QWidget *buddy)
{
    auto *label = new QLabel(text, buddy->parentWidget());
    label->setBuddy(buddy);
    return label;
}

} // namespace

RingPlanFields::RingPlanFields(ProjectDocument &document, BusId ring, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
    , m_ring(ring)
    , m_unit(describe(new QComboBox(this), "addressUnit", tr("Addresses in"),
                      tr("How addresses in the process image are shown and typed")))
    , m_first(describe(new IntegerField(this), "firstAddress", tr("First address"),
                       tr("Where the automatic addresses begin, in bytes")))
    , m_step5(describe(new QCheckBox(tr("Step &5"), this), "step5",
                       tr("With a Step 5 PLC, encoders must be above P127: this is checked")))
    , m_counts(new QLabel(this))
    , m_times(describe(new QLabel(this), "planTimes",
                       tr("About how long one bus cycle takes on the wire, by the formulas of G3 and of G4 "
                          "masters")))
    , m_cable(describe(new DecimalField(this), "cableKilometres", tr("Length of cable in km"),
                       tr("Length of all remote bus cables: each km takes 0.016 ms")))
    , m_stepping(document.newGesture())
{
    leaveSeparatorsOut(*m_first);
    m_counts->setObjectName(QStringLiteral("planCounts"));
    m_counts->setWordWrap(true);
    auto *rows = layOut<QVBoxLayout>(this, grid::unit);
    rows->addLayout(makeAddressing());
    rows->addWidget(m_counts);
    rows->addLayout(makeTimes());
    for (QAbstractSpinBox *field :
         {static_cast<QAbstractSpinBox *>(m_first), static_cast<QAbstractSpinBox *>(m_cable)})
        connect(field, &QAbstractSpinBox::editingFinished, this,
                [this] { m_stepping = m_document.newGesture(); });
    connect(&m_document, &ProjectDocument::changed, this, &RingPlanFields::show);
    show();
}

// The focus lost in the destructor must not count as leaving a field.
RingPlanFields::~RingPlanFields()
{
    m_first->disconnect(this);
    m_cable->disconnect(this);
}

QHBoxLayout *RingPlanFields::makeAddressing()
{
    m_unit->addItems({tr("bytes"), tr("words")});
    m_first->setRange(0, largestAddress);
    connect(m_unit, &QComboBox::activated, this, &RingPlanFields::setAddressing);
    connect(m_first, &QSpinBox::valueChanged, this, &RingPlanFields::setAddressing);
    connect(m_step5, &QCheckBox::clicked, this, &RingPlanFields::setAddressing);
    auto *addressing = new QHBoxLayout;
    addressing->setSpacing(grid::groupGap);
    addressing->addWidget(labelOf(tr("Addresses i&n"), m_unit));
    addressing->addWidget(m_unit);
    addressing->addWidget(labelOf(tr("fr&om byte"), m_first));
    addressing->addWidget(m_first);
    addressing->addWidget(m_step5);
    addressing->addStretch();
    return addressing;
}

QHBoxLayout *RingPlanFields::makeTimes()
{
    m_times->setWordWrap(true);
    m_cable->setRange(0, longestRemoteBus);
    m_cable->setDecimals(2);
    m_cable->setSingleStep(0.1);
    connect(m_cable, &QDoubleSpinBox::valueChanged, this, [this](double kilometres) {
        Project after = m_document.project();
        RingPlan plan = ringPlan(after, m_ring);
        plan.cableKilometres = kilometres;
        setRingPlan(after, m_ring, std::move(plan));
        m_document.edit(std::move(after), tr("Length of cable"), m_stepping);
    });
    auto *times = new QHBoxLayout;
    times->setSpacing(grid::groupGap);
    times->addWidget(m_times, 1);
    times->addWidget(labelOf(tr("Cable in k&m"), m_cable));
    times->addWidget(m_cable);
    return times;
}

void RingPlanFields::setAddressing()
{
    if (sender() != m_first)
        m_stepping = m_document.newGesture();
    Project after = m_document.project();
    RingPlan plan = ringPlan(after, m_ring);
    plan.addresses = {.unit = static_cast<AddressRules::Unit>(m_unit->currentIndex()),
                      .first = m_first->value(),
                      .step5 = m_step5->isChecked()};
    setRingPlan(after, m_ring, std::move(plan));
    m_document.edit(std::move(after), tr("Addresses"), m_stepping);
}

void RingPlanFields::show()
{
    m_counts->setText(countsText());
    m_times->setText(timesText());
    const RingPlan &plan = ringPlan(m_document.project(), m_ring);
    const QSignalBlocker cable(m_cable);
    const QSignalBlocker first(m_first);
    m_cable->setValue(plan.cableKilometres);
    m_unit->setCurrentIndex(static_cast<int>(plan.addresses.unit));
    m_first->setValue(plan.addresses.first);
    m_step5->setChecked(plan.addresses.step5);
}

QString RingPlanFields::countsText() const
{
    const RingCounts counts = countRing(structureOf(m_document.project(), m_ring));
    const auto part = [](const QString &what, int count, int limit) {
        return QStringLiteral("%1 %2 / %3")
            .arg(what, QLocale().toString(count), QLocale().toString(limit))
            .replace(u' ', QChar::Nbsp); // lines break between the parts
    };
    return QStringList{part(tr("Devices"), counts.devices, ring_limit::devices),
                       part(tr("remote bus"), counts.remoteDevices, ring_limit::remoteDevices),
                       part(tr("levels"), counts.levels, ring_limit::levels),
                       part(tr("longest local bus"), counts.longestLocalBus, ring_limit::localDevices),
                       part(tr("PCP"), counts.pcpDevices, ring_limit::pcpDevices),
                       part(tr("inputs"), counts.inPoints, ring_limit::points),
                       part(tr("outputs"), counts.outPoints, ring_limit::points)}
        .join(QStringLiteral(", "));
}

QString RingPlanFields::timesText() const
{
    const Project &project = m_document.project();
    const RingLoad load = ringLoad(structureOf(project, m_ring), ringPlan(project, m_ring).cableKilometres);
    const auto both = [&](MicrosecondsOnTheWire bit) {
        return QStringLiteral("%1 / %2").arg(cycleTimeText(cycleTime(load, bit, CycleTimeForm::g3)),
                                             cycleTimeText(cycleTime(load, bit, CycleTimeForm::g4)));
    };
    return withWholeParentheses(
        tr("Cycle about %1 ms at 500 kBd, %2 ms at 2 MBd (G3 / G4)").arg(both(bitAt500kBd), both(bitAt2MBd)));
}

} // namespace codewheel
