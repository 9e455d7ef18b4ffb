// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/ring_at_work.h"

#include "app/journal_files.h"
#include "journal/ledger_keeper.h"
#include "project/ring_plan.h"
#include "transfer/last_positions.h"

namespace codewheel {
namespace {

constexpr std::chrono::milliseconds busPeriod{1}; // of a training ring

} // namespace

RingAtWork::RingAtWork(BusId id, Surroundings its, QObject *parent)
    : BusAtWork(id, std::move(its), parent)
    , m_training(
          makeTrainingSession(catalog(), surroundings().clock(), surroundings().trainingRing(catalog()), id))
{
    tellMessagesOf(*bus());
    keepAccount(*bus(),
                std::make_unique<LedgerKeeper>(*bus(), ledgerPlace(*bus(), surroundings().dataFolder)));
}

RingAtWork::~RingAtWork()
{
    endAccount();
}

QString RingAtWork::kind() const
{
    return QString::fromLatin1(interbusKind);
}

Result<void> RingAtWork::open()
{
    auto opened = bus()->open(BusSession::Start::operating);
    if (opened && !std::exchange(m_wasOpen, true))
        tellTrainingPlan(*bus());
    return opened;
}

void RingAtWork::start()
{
    if (surroundings().byThread)
        bus()->startThread(busPeriod);
}

} // namespace codewheel
