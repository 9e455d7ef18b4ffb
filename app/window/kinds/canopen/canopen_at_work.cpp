// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/canopen/canopen_at_work.h"

#include "app/journal_files.h"
#include "can/simulator/simulated_can_link.h"
#include "journal/ledger_keeper.h"
#include "kinds/canopen/protocol/device_of_type.h"
#include "kinds/canopen/simulator/simulated_canopen_plant.h"
#include "links/can_link_to.h"
#include "links/port_access.h"
#include "project/bus_kind.h"
#include "project/bus_plans.h"
#include "widgets/project/project_document.h"

#include <chrono>
#include <utility>

namespace codewheel {
namespace {

constexpr std::chrono::milliseconds untilNextLook{5}; // to see whether the adapter is open

Instant steadyTimeOfBus()
{
    return std::chrono::duration_cast<Instant>(std::chrono::steady_clock::now().time_since_epoch());
}

// As it would tell by its device type.
QString trainingDevice(const canopen::CanopenEncoderPlan &encoder)
{
    return deviceOfType(encoder.deviceType());
}

// A serial adapter has one user.
bool leadToSameAdapter(const CanopenSettings &one, const CanopenSettings &other)
{
    const auto its = canLinkOf(one);
    const auto others = canLinkOf(other);
    if (!its || !others || its->isSerial != others->isSerial)
        return false;
    return its->isSerial ? isSamePort(its->where, others->where) : its->where == others->where;
}

} // namespace

CanopenAtWork::CanopenAtWork(BusId id, Surroundings its, QObject *parent)
    : BusAtWork(id, std::move(its), parent)
    , m_make(canLinkTo)
{
    connect(&project(), &ProjectDocument::replaced, this, &CanopenAtWork::followProject);
    connect(&m_openingTurns, &QTimer::timeout, this, &CanopenAtWork::goOnOpening);
    connect(this, &CanopenAtWork::openRefused, this, [this](const Refusal &why) { noteRefused(why); });
    connect(this, &CanopenAtWork::changed, this, [this] { noteRefused({}); });
}

CanopenAtWork::~CanopenAtWork()
{
    endAccount();
}

QString CanopenAtWork::kind() const
{
    return QString::fromLatin1(canopenKind);
}

// The simulated encoders give way to those of an opened project that has a link to them.
void CanopenAtWork::followProject()
{
    const bool isForTraining = plansTraining(project().project(), id());
    if (m_training && !isForTraining) {
        close();
        m_gaveWay = true;
    } else if (std::exchange(m_gaveWay, false) && isForTraining && !m_session) {
        connectTraining();
    }
}

std::unique_ptr<CanopenSession> CanopenAtWork::makeSession(std::unique_ptr<CanLink> link)
{
    auto session =
        std::make_unique<CanopenSession>(std::move(link), catalog(), surroundings().clock(), nullptr, id());
    tellMessagesOf(*session);
    return session;
}

void CanopenAtWork::replace(std::unique_ptr<CanopenSession> session,
                            std::shared_ptr<canopen::SimulatedCanopenPlant> training,
                            const CanopenSettings &settings)
{
    Q_EMIT aboutToChange();
    if (m_session)
        m_session->close();
    endAccount();
    m_session = std::move(session);
    m_training = std::move(training);
    m_openedWith = settings;
    if (m_session)
        keepAccount(
            std::make_unique<LedgerKeeper>(*m_session, ledgerPlace(*m_session, surroundings().dataFolder)));
    Q_EMIT changed();
}

void CanopenAtWork::connectTraining()
{
    connectTraining(CanopenSession::Start::operating);
}

void CanopenAtWork::startAfresh()
{
    connectTraining(m_session->isOperating() ? CanopenSession::Start::operating
                                             : CanopenSession::Start::watching);
}

void CanopenAtWork::connectTraining(CanopenSession::Start start)
{
    endOpening();
    forgetSimulated();
    const auto encoders = canopen::trainingEncoders();
    auto plant = std::make_shared<canopen::SimulatedCanopenPlant>(encoders);
    const bool isVirtual = !surroundings().byThread;
    const CanopenSettings settings;
    auto session = makeSession(std::make_unique<SimulatedCanLink>(
        plant->bus(), settings.rate,
        isVirtual ? SimulatedCanLink::Clock() : SimulatedCanLink::Clock(steadyTimeOfBus)));
    // a simulated link always opens
    if (!session->open(settings, start,
                       isVirtual ? CanopenSession::Drive::byHand : CanopenSession::Drive::byThread))
        Q_UNREACHABLE();
    for (const canopen::CanopenEncoderPlan &encoder : encoders)
        if (encoder.node)
            (void)session->add(*encoder.node, trainingDevice(encoder));
    replace(std::move(session), std::move(plant), settings);
}

Result<std::unique_ptr<CanLink>> CanopenAtWork::makeLink(const CanopenSettings &settings) const
{
    return canLinkOf(settings).map([this](const CanLinkArgument &at) { return m_make(at); });
}

void CanopenAtWork::open(const CanopenSettings &settings)
{
    open(settings, false);
}

void CanopenAtWork::openUnsure(const CanopenSettings &settings)
{
    open(settings, true);
}

// It is opened in its own thread, since an adapter may be slow.
void CanopenAtWork::open(const CanopenSettings &settings, bool isUnsure)
{
    endOpening();
    auto link = makeLink(settings);
    if (!link) {
        Q_EMIT openRefused(link.error());
        return;
    }
    if (m_session && leadToSameAdapter(settings, m_openedWith))
        close();
    m_opening = {makeSession(*std::move(link)), settings, std::nullopt};
    CanopenSession &session = *m_opening.session;
    if (isUnsure)
        session.takeUnsureWatch();
    connect(&session, &CanopenSession::openRefused, this,
            [this](const Refusal &why) { m_opening.refusal = why; });
    (void)session.open(settings, CanopenSession::Start::watching, CanopenSession::Drive::byThread);
    m_openingTurns.start(untilNextLook);
    Q_EMIT openingChanged();
}

void CanopenAtWork::goOnOpening()
{
    m_opening.session->pump();
    if (m_opening.session->state() == BusState::opening)
        return;
    Opening ended = std::exchange(m_opening, {});
    m_openingTurns.stop();
    const auto refusal = ended.refusal;
    if (!refusal)
        useOpened(std::move(ended));
    Q_EMIT openingChanged();
    if (refusal)
        Q_EMIT openRefused(*refusal);
    else
        Q_EMIT opened();
}

void CanopenAtWork::useOpened(Opening opening)
{
    for (const ProjectDevice &encoder : devicesOn(project().project(), id()))
        (void)opening.session->add(CanopenAddress::of(encoder.place().node).node,
                                   encoder.participant.deviceKey);
    replace(std::move(opening.session), nullptr, opening.settings);
}

// Nothing has been sent at this point.
void CanopenAtWork::endOpening()
{
    if (!isOpening())
        return;
    m_openingTurns.stop();
    m_opening = {};
    Q_EMIT openingChanged();
}

void CanopenAtWork::close()
{
    endOpening();
    if (m_session)
        replace(nullptr, nullptr, {});
}

} // namespace codewheel
