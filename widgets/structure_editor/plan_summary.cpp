// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/structure_editor/plan_summary.h"

#include "project/project_take_over.h"
#include "project/ring_plan.h"
#include "ring/cycle_time.h"
#include "ring/ring_rules.h"
#include "widgets/input/number_fields.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/project/project_document.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace codewheel {
namespace {

QString cycleTimeText(MicrosecondsOnTheWire time)
{
    return QLocale().toString(time.count() / 1000, 'f', 2);
}

} // namespace

PlanSummary::PlanSummary(ProjectDocument &document, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
    , m_counts(new QLabel(this))
    , m_times(describe(new QLabel(this), "planTimes",
                       tr("About how long one bus cycle takes on the wire, by the formulas of G3 and of G4 "
                          "masters")))
    , m_cable(describe(new DecimalField(this), "cableKilometres", tr("Length of cable in km"),
                       tr("Length of all remote bus cables: each km takes 0.016 ms")))
    , m_stepping(document.newGesture())
{
    m_counts->setObjectName(QStringLiteral("planCounts"));
    m_counts->setWordWrap(true);
    m_times->setWordWrap(true);
    m_cable->setRange(0, longestRemoteBus);
    m_cable->setDecimals(2);
    m_cable->setSingleStep(0.1);
    auto *cableLabel = new QLabel(tr("Cable in k&m"), this);
    cableLabel->setBuddy(m_cable);

    auto *times = new QHBoxLayout;
    times->setSpacing(grid::groupGap);
    times->addWidget(m_times, 1);
    times->addWidget(cableLabel);
    times->addWidget(m_cable);
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins({});
    rows->setSpacing(grid::unit);
    rows->addWidget(m_counts);
    rows->addLayout(times);
    connect(m_cable, &QDoubleSpinBox::valueChanged, this, [this](double kilometres) {
        Project after = m_document.project();
        RingPlan plan = ringPlan(after, m_ring);
        plan.cableKilometres = kilometres;
        setRingPlan(after, m_ring, std::move(plan));
        m_document.edit(std::move(after), tr("Length of cable"), m_stepping);
    });
    connect(m_cable, &QDoubleSpinBox::editingFinished, this,
            [this] { m_stepping = m_document.newGesture(); });
    connect(&m_document, &ProjectDocument::changed, this, &PlanSummary::show);
    show();
}

// Losing the focus by going is no leaving of a field.
PlanSummary::~PlanSummary()
{
    m_cable->disconnect(this);
}

void PlanSummary::setRing(BusId ring)
{
    m_ring = ring;
    show();
}

void PlanSummary::show()
{
    m_counts->setText(countsText());
    m_times->setText(timesText());
    const QSignalBlocker blocker(m_cable);
    m_cable->setValue(ringPlan(m_document.project(), m_ring).cableKilometres);
}

QString PlanSummary::countsText() const
{
    const RingCounts counts = countRing(structureOf(m_document.project(), m_ring));
    const auto part = [](const QString &what, int count, int limit) {
        return QStringLiteral("%1 %2 / %3").arg(what, QLocale().toString(count), QLocale().toString(limit));
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

QString PlanSummary::timesText() const
{
    const Project &project = m_document.project();
    const RingLoad load = ringLoad(structureOf(project, m_ring), ringPlan(project, m_ring).cableKilometres);
    const auto both = [&](MicrosecondsOnTheWire bit) {
        return QStringLiteral("%1 / %2").arg(cycleTimeText(cycleTime(load, bit, CycleTimeForm::g3)),
                                             cycleTimeText(cycleTime(load, bit, CycleTimeForm::g4)));
    };
    return tr("Cycle about %1 ms at 500 kBd, %2 ms at 2 MBd (G3 / G4)")
        .arg(both(bitAt500kBd), both(bitAt2MBd));
}

} // namespace codewheel
