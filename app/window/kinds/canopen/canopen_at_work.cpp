// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/canopen/canopen_at_work.h"

#include "can/simulator/simulated_can_link.h"
#include "kinds/canopen/protocol/device_of_type.h"
#include "kinds/canopen/simulator/simulated_canopen_plant.h"
#include "links/can_link_to.h"
#include "links/port_access.h"
#include "widgets/project/project_document.h"

#include <utility>

namespace codewheel {
namespace {

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
    : AskedBusAtWork(id, std::move(its), parent)
    , m_make(canLinkTo)
{}

QString CanopenAtWork::kind() const
{
    return QString::fromLatin1(canopenKind);
}

std::unique_ptr<CanopenSession> CanopenAtWork::makeSession(std::unique_ptr<CanLink> link)
{
    auto session =
        std::make_unique<CanopenSession>(std::move(link), catalog(), surroundings().clock(), nullptr, id());
    tellMessagesOf(*session);
    return session;
}

void CanopenAtWork::attach(std::shared_ptr<canopen::SimulatedCanopenPlant> training,
                           const CanopenSettings &openedWith)
{
    m_training = std::move(training);
    m_openedWith = openedWith;
}

void CanopenAtWork::beginTraining(EncoderBus::Start start)
{
    endOpening();
    forgetSimulated();
    const auto encoders = canopen::trainingEncoders();
    auto plant = std::make_shared<canopen::SimulatedCanopenPlant>(encoders);
    const CanopenSettings settings;
    auto session = makeSession(std::make_unique<SimulatedCanLink>(plant->bus(), settings.rate,
                                                                  drive() == EncoderBus::Drive::byHand
                                                                      ? SimulatedCanLink::Clock()
                                                                      : SimulatedCanLink::Clock(steadyTime)));
    // a simulated link always opens
    if (!session->open(settings, start, drive()))
        Q_UNREACHABLE();
    for (const canopen::CanopenEncoderPlan &encoder : encoders)
        if (encoder.node)
            (void)session->add(*encoder.node, trainingDevice(encoder));
    replace(std::move(session), true, [&] { attach(std::move(plant), settings); });
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

void CanopenAtWork::open(const CanopenSettings &settings, bool isUnsure)
{
    endOpening();
    auto link = makeLink(settings);
    if (!link) {
        Q_EMIT openRefused(link.error());
        return;
    }
    if (session() && leadToSameAdapter(settings, m_openedWith))
        close();
    auto session = makeSession(*std::move(link));
    if (isUnsure)
        session->takeUnsureWatch();
    (void)session->open(settings, EncoderBus::Start::watching, EncoderBus::Drive::byThread);
    waitUntilOpen(std::move(session), [this, settings] { attach(nullptr, settings); });
}

} // namespace codewheel
