// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/interbus/ring_at_work.h"

#include "app/journal_files.h"
#include "app/window/kinds/interbus/ring_offer.h"
#include "journal/ledger_keeper.h"
#include "kinds/interbus/links/modbus_port.h"
#include "kinds/interbus/plan/gateway_plan.h"
#include "kinds/interbus/plan/project_take_over.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "kinds/interbus/simulator/planned_ring.h"
#include "project/bus_kind.h"
#include "widgets/project/project_document.h"

#include <QScopedValueRollback>

#include <algorithm>

namespace codewheel {
namespace {

constexpr std::chrono::milliseconds busPeriod{1}; // of a training ring

TrainingBus trainingRing(const BusAtWork::Surroundings &its)
{
    const auto *make = std::any_cast<RingAtWork::MakeTraining>(&its.training);
    return make != nullptr ? (*make)(its.catalog) : makeTrainingBus(its.catalog);
}

bool isTrainingPlant(const RingStructure &ring, const Catalog &catalog)
{
    return std::ranges::equal(
        ring, trainingPlan(catalog), [](const RingDevice &device, const TrainingParticipant &planned) {
            return device.number == planned.number &&
                   device.deviceKey == (planned.device != nullptr ? planned.device->key : QString());
        });
}

} // namespace

RingAtWork::RingAtWork(BusId id, Surroundings its, QObject *parent)
    : BusAtWork(id, std::move(its), parent)
    , m_training(makeTrainingSession(catalog(), surroundings().clock(), trainingRing(surroundings()), id))
    , m_makePort([](const GatewaySettings &settings) { return std::make_unique<ModbusPort>(settings); })
    , m_offer(std::make_unique<RingOffer>(*this))
{
    tellMessagesOf(*bus());
    connect(bus(), &RingSession::nodesChanged, this, &RingAtWork::tellPlan);
    connect(m_offer.get(), &RingOffer::messaged, this, [this](const Message &message) {
        Q_EMIT messaged(message,
                        surroundings().byThread ? surroundings().clock() : bus()->dateTime(bus()->now()));
    });
    connect(&project(), &ProjectDocument::replaced, this, &RingAtWork::followProject);
    keepAccountOfLink();
}

RingAtWork::~RingAtWork()
{
    endAccount();
}

QString RingAtWork::kind() const
{
    return QString::fromLatin1(interbusKind);
}

// The simulated encoders give way to those of an opened project.
void RingAtWork::followProject()
{
    if (isOpen() && bus()->isSimulated() && !plansTraining(project().project(), id()))
        bus()->close();
}

Result<void> RingAtWork::open()
{
    const auto gateway = plannedGateway(project().project(), id());
    noteRefused(gateway && !*gateway ? std::optional(gateway->error()) : std::nullopt);
    if (gateway && !*gateway)
        return tl::unexpected(gateway->error());
    if (gateway)
        useGateway(**gateway);
    else
        useTraining();
    return openLink(gateway ? RingSession::Start::watching : RingSession::Start::operating);
}

// Others that use the ring go on with the new one, whose words are in the same registers.
void RingAtWork::startAfresh()
{
    const auto start = bus()->isOperating() ? RingSession::Start::operating : RingSession::Start::watching;
    TrainingBus anew = trainingRing(surroundings());
    const auto structure = anew.link->open(); // a simulated link always opens
    anew.link->close();
    m_offer->goOnWith(*structure);
    const QScopedValueRollback startsAfresh(m_isStartingAfresh, true);
    m_training.controls = std::move(anew.controls);
    m_planIsTold = false;
    m_trainingAccount = {};
    use(std::move(anew.link));
    forgetSimulated();
    m_trainingLink.reset(); // of the ring before
    if (!openLink(start))
        Q_UNREACHABLE();
}

// Of writes, those to real encoders are kept, and those to the encoders of the training ring as long as
// these.
void RingAtWork::keepAccountOfLink()
{
    keepAccount(std::make_unique<LedgerKeeper>(*bus(), bus()->isSimulated()
                                                           ? m_trainingAccount.place
                                                           : ledgerPlace(*bus(), surroundings().dataFolder)));
}

void RingAtWork::use(std::unique_ptr<ProcessDataLink> link)
{
    Q_EMIT aboutToChange();
    endAccount();
    auto before = bus()->useLink(std::move(link), surroundings().clock());
    if (before->isSimulated())
        m_trainingLink = std::move(before);
    keepAccountOfLink();
    Q_EMIT changed();
    Q_EMIT linkChanged();
}

void RingAtWork::useTraining()
{
    if (!m_trainingLink)
        return;
    m_gateway.reset();
    use(std::move(m_trainingLink));
}

void RingAtWork::useGateway(const GatewaySettings &settings)
{
    if (m_gateway && *m_gateway != settings)
        forgetKnown();
    m_gateway = settings;
    use(std::make_unique<GatewayLink>(m_makePort(settings), settings,
                                      gatewayDevices(project().project(), id(), catalog())));
}

// A gateway is asked as fast as its link and its settings allow.
Result<void> RingAtWork::openLink(RingSession::Start start)
{
    bus()->setTime(surroundings().clock());
    const auto pacing = [this](std::chrono::nanoseconds period) {
        return surroundings().byThread ? std::optional(Pacing{.period = period}) : std::nullopt;
    };
    return bus()->open(start, pacing(m_gateway ? std::chrono::nanoseconds{} : busPeriod));
}

void RingAtWork::openTraining()
{
    useTraining();
    bus()->setTime(surroundings().clock());
    if (!bus()->open(RingSession::Start::operating)) // a simulated link always opens
        Q_UNREACHABLE();
    project().setProject(projectOf(bus()->structure(), id()), {});
}

std::optional<Place> RingAtWork::turning() const
{
    if (m_gateway)
        return std::nullopt;
    for (const TrainingControls::Shaft &shaft : controls().shafts())
        if (shaft.revolutionsPerMinute != 0)
            return Place{id(), shaft.number};
    return std::nullopt;
}

TrainingSession RingAtWork::makeSeat() const
{
    const RingStructure planned = structureOf(project().project(), id());
    return makeTrainingSession(catalog(), QDateTime::currentDateTime(),
                               planned.empty() || isTrainingPlant(planned, catalog())
                                   ? trainingRing(surroundings())
                                   : makePlannedRing(project().project(), id(), catalog()),
                               id());
}

// What the plan of the training ring knows of its encoders, the first time.
void RingAtWork::tellPlan()
{
    if (!bus()->isOpen() || !bus()->isSimulated() || std::exchange(m_planIsTold, true))
        return;
    tellTrainingPlan(*bus(), &TrainingParticipant::known);
    tellTrainingPlan(*bus(), &TrainingParticipant::knownInWindow);
}

QString RingAtWork::endsForOthers() const
{
    return m_offer->endsForClients();
}

void RingAtWork::start()
{
    if (!surroundings().byThread)
        return;
    bus()->setTime(surroundings().clock());
    bus()->startThread(busPeriod);
}

} // namespace codewheel
