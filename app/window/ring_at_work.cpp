// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/ring_at_work.h"

#include "app/journal_files.h"
#include "journal/ledger_keeper.h"
#include "project/project_take_over.h"
#include "project/ring_plan.h"
#include "widgets/project/project_document.h"

namespace codewheel {
namespace {

constexpr std::chrono::milliseconds busPeriod{1}; // of a training ring

TrainingBus trainingRing(const BusAtWork::Surroundings &its)
{
    const auto *make = std::any_cast<RingAtWork::MakeTraining>(&its.training);
    return make != nullptr ? (*make)(its.catalog) : makeTrainingBus(its.catalog);
}

} // namespace

RingAtWork::RingAtWork(BusId id, Surroundings its, QObject *parent)
    : BusAtWork(id, std::move(its), parent)
    , m_training(makeTrainingSession(catalog(), surroundings().clock(), trainingRing(surroundings()), id))
{
    tellMessagesOf(*bus());
    connect(bus(), &RingSession::nodesChanged, this, &RingAtWork::tellPlan);
    keepAccount(std::make_unique<LedgerKeeper>(*bus(), ledgerPlace(*bus(), surroundings().dataFolder)));
}

RingAtWork::~RingAtWork()
{
    endAccount();
}

QString RingAtWork::kind() const
{
    return QString::fromLatin1(interbusKind);
}

std::optional<Pacing> RingAtWork::pacing() const
{
    return surroundings().byThread ? std::optional(Pacing{.period = busPeriod}) : std::nullopt;
}

Result<void> RingAtWork::open(std::optional<Pacing> pacing)
{
    bus()->setTime(surroundings().clock());
    return bus()->open(RingSession::Start::operating, std::move(pacing));
}

void RingAtWork::openTraining()
{
    if (!open({})) // a simulated link always opens
        Q_UNREACHABLE();
    project().setProject(projectOf(bus()->structure(), id()), {});
}

std::optional<Place> RingAtWork::turning() const
{
    for (const TrainingControls::Shaft &shaft : controls().shafts())
        if (shaft.revolutionsPerMinute != 0)
            return Place{id(), shaft.number};
    return std::nullopt;
}

// What the plan of the training ring knows of its encoders, the first time.
void RingAtWork::tellPlan()
{
    if (!bus()->isOpen() || std::exchange(m_planIsTold, true))
        return;
    tellTrainingPlan(*bus(), &TrainingParticipant::known);
    tellTrainingPlan(*bus(), &TrainingParticipant::knownInWindow);
}

void RingAtWork::start()
{
    if (!surroundings().byThread)
        return;
    bus()->setTime(surroundings().clock());
    bus()->startThread(busPeriod);
}

} // namespace codewheel
