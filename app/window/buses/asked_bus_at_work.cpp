// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/buses/asked_bus_at_work.h"

#include "app/journal_files.h"
#include "journal/ledger_keeper.h"
#include "project/bus_kind.h"
#include "widgets/project/project_document.h"

#include <chrono>
#include <utility>

namespace codewheel {
namespace {

constexpr std::chrono::milliseconds betweenLooks{5}; // whether it is open

} // namespace

Instant steadyTime()
{
    return std::chrono::duration_cast<Instant>(std::chrono::steady_clock::now().time_since_epoch());
}

AskedBusAtWork::AskedBusAtWork(BusId id, Surroundings surroundings, QObject *parent)
    : BusAtWork(id, std::move(surroundings), parent)
{
    connect(&project(), &ProjectDocument::replaced, this, &AskedBusAtWork::followProject);
    connect(&m_openingTurns, &QTimer::timeout, this, &AskedBusAtWork::goOnOpening);
    connect(this, &AskedBusAtWork::openRefused, this, [this](const Refusal &why) { noteRefused(why); });
    connect(this, &AskedBusAtWork::changed, this, [this] { noteRefused({}); });
}

AskedBusAtWork::~AskedBusAtWork()
{
    endAccount();
}

EncoderBus::Drive AskedBusAtWork::drive() const
{
    return surroundings().byThread ? EncoderBus::Drive::byThread : EncoderBus::Drive::byHand;
}

// The simulated encoders give way to those of an opened project that has a link to them.
void AskedBusAtWork::followProject()
{
    const bool isForTraining = plansTraining(project().project(), id());
    if (m_isSimulated && !isForTraining) {
        close();
        m_gaveWay = true;
    } else if (std::exchange(m_gaveWay, false) && isForTraining && !m_session) {
        connectTraining();
    }
}

void AskedBusAtWork::replace(std::unique_ptr<AskedBus> session, bool isSimulated, const Attach &attach)
{
    Q_EMIT aboutToChange();
    if (m_session)
        m_session->close();
    endAccount();
    m_session = std::move(session);
    m_isSimulated = isSimulated;
    m_openedWith = {};
    detach();
    attach();
    if (m_session)
        keepAccount(
            std::make_unique<LedgerKeeper>(*m_session, ledgerPlace(*m_session, surroundings().dataFolder)));
    Q_EMIT changed();
}

void AskedBusAtWork::simulate(EncoderBus::Start start)
{
    endOpening();
    forgetSimulated();
    beginTraining(start);
}

void AskedBusAtWork::startAfresh()
{
    simulate(m_session->isOperating() ? EncoderBus::Start::operating : EncoderBus::Start::watching);
}

void AskedBusAtWork::open(const KindData &plan)
{
    endOpening();
    beginOpening(plan, false);
}

void AskedBusAtWork::openAgreed(const KindData &plan)
{
    endOpening();
    beginOpening(plan, true);
}

KindData AskedBusAtWork::openedPlan() const
{
    return m_openedWith == KindData() ? busKind(kind())->usual() : asOpened(m_openedWith);
}

void AskedBusAtWork::waitUntilOpen(std::unique_ptr<AskedBus> session, const KindData &plan,
                                   const Attach &attach)
{
    m_opening = std::move(session);
    m_attach = [this, plan, attach] {
        m_openedWith = plan;
        attach();
    };
    m_refusal.reset();
    connect(m_opening.get(), &EncoderBus::openRefused, this, [this](const Refusal &why) { m_refusal = why; });
    m_openingTurns.start(betweenLooks);
    Q_EMIT openingChanged();
}

void AskedBusAtWork::goOnOpening()
{
    m_opening->pump();
    if (m_opening->state() == BusState::opening)
        return;
    const auto refusal = std::exchange(m_refusal, std::nullopt);
    auto ended = std::move(m_opening);
    const Attach attach = std::exchange(m_attach, nullptr);
    m_openingTurns.stop();
    if (!refusal) {
        for (const ProjectDevice &encoder : devicesOn(project().project(), id()))
            (void)ended->add(encoder.place().node, encoder.participant.deviceKey);
        replace(std::move(ended), false, attach);
    }
    Q_EMIT openingChanged();
    if (refusal)
        Q_EMIT openRefused(*refusal);
    else
        Q_EMIT opened();
}

// Nothing has been sent at this point.
void AskedBusAtWork::endOpening()
{
    if (!isOpening())
        return;
    m_openingTurns.stop();
    m_opening.reset();
    m_attach = nullptr;
    Q_EMIT openingChanged();
}

void AskedBusAtWork::close()
{
    endOpening();
    if (m_session)
        replace(nullptr, false, [] {});
}

} // namespace codewheel
