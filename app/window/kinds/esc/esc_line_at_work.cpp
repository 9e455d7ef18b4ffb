// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/esc/esc_line_at_work.h"

#include "kinds/esc/driver/esc_driver.h"
#include "kinds/esc/links/project_adapter.h"
#include "kinds/esc/simulator/simulated_esc_line_link.h"
#include "links/port_access.h"
#include "widgets/project/project_document.h"

#include <utility>

namespace codewheel {
namespace {

const QString simulatedEncoder = QStringLiteral("kuebler-esc-rs485");

EscSettings escSettingsOf(const EscLineSettings &wish)
{
    EscSettings settings;
    settings.positionInterval = wish.pollInterval;
    settings.topSpeed = wish.topSpeed;
    settings.fractionBits = wish.fractionBits;
    return settings;
}

} // namespace

EscLineAtWork::EscLineAtWork(BusId id, Surroundings its, QObject *parent)
    : AskedBusAtWork(id, std::move(its), parent)
{
    connect(&project(), &ProjectDocument::changed, this, &EscLineAtWork::tellByteOrder);
    connect(this, &EscLineAtWork::changed, this, &EscLineAtWork::tellByteOrder);
}

QString EscLineAtWork::kind() const
{
    return QString::fromLatin1(escKind);
}

std::unique_ptr<EscLineSession> EscLineAtWork::makeSession(std::unique_ptr<ByteLink> link,
                                                           const EscLineSettings &wish)
{
    auto session = std::make_unique<EscLineSession>(
        std::move(link), catalog(), surroundings().clock(),
        [settings = escSettingsOf(wish)](const DeviceDescription &device, EscLineAddress address) {
            return std::make_unique<EscDriver>(device, address, settings);
        },
        nullptr, id());
    session->setFractionBits(wish.fractionBits);
    connect(session.get(), &EscLineSession::nodesChanged, this, &EscLineAtWork::tellByteOrder);
    tellMessagesOf(*session);
    return session;
}

void EscLineAtWork::detach()
{
    m_training.reset();
    m_port = nullptr;
}

void EscLineAtWork::beginTraining(EncoderBus::Start start)
{
    auto line = std::make_shared<SimulatedEscLine>();
    auto link = std::make_unique<SimulatedEscLineLink>(line, drive() == EncoderBus::Drive::byHand
                                                                 ? SimulatedEscLineLink::Clock()
                                                                 : SimulatedEscLineLink::Clock(steadyTime));
    auto session = makeSession(std::move(link), {});
    // a simulated link always opens
    if (!session->open({}, {}, start, drive()))
        Q_UNREACHABLE();
    for (const EscLineAddress address : line->addresses())
        (void)session->add(address, simulatedEncoder);
    replace(std::move(session), true, [&] { m_training = std::move(line); });
}

// A port has many paths, and its adapter may have been moved since it was opened.
bool EscLineAtWork::holds(const QString &path) const
{
    if (m_port == nullptr)
        return false;
    const auto held = m_port->adapter();
    const auto &wanted = m_wanted->adapter();
    return isSamePort(m_port->name(), path) ||
           (held && wanted && sameAdapter(*held, {*wanted}).kind == AdapterMatch::Kind::found);
}

void EscLineAtWork::beginOpening(const KindData &plan, bool isAgreed)
{
    const EscLinePlan &line = *plan.as<EscLinePlan>();
    if (isAgreed && m_wanted)
        m_wanted->takeOther();
    else
        m_wanted = keptAdapterOf(line);
    const auto there = m_wanted->find(m_ports());
    if (!there) {
        Q_EMIT openRefused(there.error());
        return;
    }
    auto link = std::make_unique<SerialPortLink>(*m_wanted, m_ports);
    const SerialPortLink *port = link.get();
    if (holds(*there))
        close();
    auto session = makeSession(std::move(link), line.settings);
    (void)session->open(line.settings.serial, line.settings.timing, EncoderBus::Start::watching,
                        EncoderBus::Drive::byThread);
    waitUntilOpen(std::move(session), plan, [this, port] { m_port = port; });
}

std::unique_ptr<ByteLink> EscLineAtWork::makeLink(const EscLinePlan &line) const
{
    return std::make_unique<SerialPortLink>(keptAdapterOf(line), m_ports);
}

// For the project's encoders, also after undo, but not for those of the training line.
void EscLineAtWork::tellByteOrder()
{
    if (!session() || m_training)
        return;
    for (const ProjectDevice &encoder : devicesOn(project().project(), id()))
        session()->setSwapsWarningBytes(encoder.place(), encoder.its<EscEncoderSettings>().swapsWarningBytes);
}

KindData EscLineAtWork::asOpened(const KindData &plan) const
{
    if (m_port == nullptr)
        return plan;
    EscLinePlan line = *plan.as<EscLinePlan>();
    line.adapter = lineAdapter(m_port->adapter());
    if (const QString path = m_port->name(); path != portPath(line.settings.port))
        line.settings.port = path;
    return KindData(std::move(line));
}

} // namespace codewheel
