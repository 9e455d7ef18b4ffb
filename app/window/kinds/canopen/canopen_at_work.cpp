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

void CanopenAtWork::beginTraining(EncoderBus::Start start)
{
    const auto encoders = canopen::trainingEncoders();
    auto plant = std::make_shared<canopen::SimulatedCanopenPlant>(encoders);
    const CanopenSettings settings;
    auto link = std::make_unique<SimulatedCanLink>(plant->bus(), settings.rate,
                                                   drive() == EncoderBus::Drive::byHand
                                                       ? SimulatedCanLink::Clock()
                                                       : SimulatedCanLink::Clock(steadyTime));
    auto adapter = link->adapter();
    auto session = makeSession(std::move(link));
    // a simulated link always opens
    if (!session->open(settings, start, drive()))
        Q_UNREACHABLE();
    for (const canopen::CanopenEncoderPlan &encoder : encoders)
        if (encoder.node)
            (void)session->add(*encoder.node, trainingDevice(encoder));
    replace(std::move(session), true, [&] {
        m_training = std::move(plant);
        m_trainingAdapter = std::move(adapter);
    });
}

Result<std::unique_ptr<CanLink>> CanopenAtWork::makeLink(const CanopenSettings &settings) const
{
    return canLinkOf(settings).map([this](const CanLinkArgument &at) { return m_make(at); });
}

void CanopenAtWork::beginOpening(const KindData &plan, bool isAgreed)
{
    const CanopenSettings &settings = plan.as<CanopenPlan>()->settings;
    const auto *present = openedWith().as<CanopenPlan>();
    auto link = makeLink(settings);
    if (!link) {
        Q_EMIT openRefused(link.error());
        return;
    }
    if (present != nullptr && leadToSameAdapter(settings, present->settings))
        close();
    auto session = makeSession(*std::move(link));
    if (isAgreed)
        session->takeUnsureWatch();
    (void)session->open(settings, EncoderBus::Start::watching, EncoderBus::Drive::byThread);
    waitUntilOpen(std::move(session), plan, [] {});
}

} // namespace codewheel
