// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/esc/esc_line_at_work.h"

#include "app/journal_files.h"
#include "journal/ledger_keeper.h"
#include "kinds/esc/driver/esc_driver.h"
#include "kinds/esc/links/project_adapter.h"
#include "kinds/esc/simulator/simulated_esc_line_link.h"
#include "links/port_access.h"
#include "project/bus_kind.h"
#include "widgets/project/project_document.h"

#include <chrono>
#include <utility>

namespace codewheel {
namespace {

constexpr std::chrono::milliseconds betweenTries{5}; // to see whether the port is open

const QString trainingDevice = QStringLiteral("kuebler-esc-rs485");

Instant steadyTime()
{
    return std::chrono::duration_cast<Instant>(std::chrono::steady_clock::now().time_since_epoch());
}

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
    : BusAtWork(id, std::move(its), parent)
{
    connect(&project(), &ProjectDocument::changed, this, &EscLineAtWork::tellByteOrder);
    connect(&project(), &ProjectDocument::replaced, this, &EscLineAtWork::followProject);
    connect(&m_openingTurns, &QTimer::timeout, this, &EscLineAtWork::goOnOpening);
    connect(this, &EscLineAtWork::openRefused, this, [this](const Refusal &why) { noteRefused(why); });
    connect(this, &EscLineAtWork::changed, this, [this] { noteRefused({}); });
}

EscLineAtWork::~EscLineAtWork()
{
    endAccount();
}

QString EscLineAtWork::kind() const
{
    return QString::fromLatin1(escKind);
}

// The simulated encoders give way to those of an opened project that has a port for them.
void EscLineAtWork::followProject()
{
    const bool isForTraining = plansTraining(project().project(), id());
    if (m_training && !isForTraining) {
        close();
        m_gaveWay = true;
    } else if (std::exchange(m_gaveWay, false) && isForTraining && !m_session) {
        openTraining();
    }
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

void EscLineAtWork::replace(std::unique_ptr<EscLineSession> session,
                            std::shared_ptr<SimulatedEscLine> training, const SerialPortLink *port)
{
    Q_EMIT aboutToChange();
    if (m_session)
        m_session->close();
    endAccount();
    m_session = std::move(session);
    m_training = std::move(training);
    m_port = port;
    if (m_session)
        keepAccount(
            std::make_unique<LedgerKeeper>(*m_session, ledgerPlace(*m_session, surroundings().dataFolder)));
    Q_EMIT changed();
}

void EscLineAtWork::openTraining()
{
    openTraining(EscLineSession::Start::operating);
}

void EscLineAtWork::startAfresh()
{
    openTraining(m_session->isOperating() ? EscLineSession::Start::operating
                                          : EscLineSession::Start::watching);
}

void EscLineAtWork::openTraining(EscLineSession::Start start)
{
    forgetSimulated();
    auto line = std::make_shared<SimulatedEscLine>();
    const bool isVirtual = !surroundings().byThread;
    auto link = std::make_unique<SimulatedEscLineLink>(
        line, isVirtual ? SimulatedEscLineLink::Clock() : SimulatedEscLineLink::Clock(steadyTime));
    auto session = makeSession(std::move(link), {});
    // a simulated link always opens
    if (!session->open({}, {}, start,
                       isVirtual ? EscLineSession::Drive::byHand : EscLineSession::Drive::byThread))
        Q_UNREACHABLE();
    for (const EscLineAddress address : line->addresses())
        (void)session->add(address, trainingDevice);
    replace(std::move(session), std::move(line), nullptr);
}

void EscLineAtWork::openPort(const EscLinePlan &line)
{
    m_wanted = keptAdapterOf(line);
    open(line);
}

void EscLineAtWork::openOtherAdapter(const EscLinePlan &line)
{
    if (m_wanted)
        m_wanted->takeOther();
    else
        m_wanted = keptAdapterOf(line);
    open(line);
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

// The port is opened in its own thread, since its adapter may be slow.
void EscLineAtWork::open(const EscLinePlan &line)
{
    endOpening();
    const auto there = m_wanted->find(m_ports());
    if (!there) {
        Q_EMIT openRefused(there.error());
        return;
    }
    auto link = std::make_unique<SerialPortLink>(*m_wanted, m_ports);
    const SerialPortLink *port = link.get();
    if (holds(*there))
        close();
    m_opening = {makeSession(std::move(link), line.settings), port, line.settings, std::nullopt};
    EscLineSession &session = *m_opening.session;
    connect(&session, &EscLineSession::openRefused, this,
            [this](const Refusal &why) { m_opening.refusal = why; });
    (void)session.open(line.settings.serial, line.settings.timing, EscLineSession::Start::watching,
                       EscLineSession::Drive::byThread);
    m_openingTurns.start(betweenTries);
    Q_EMIT openingChanged();
}

std::unique_ptr<ByteLink> EscLineAtWork::makeLink(const EscLinePlan &line) const
{
    return std::make_unique<SerialPortLink>(keptAdapterOf(line), m_ports);
}

void EscLineAtWork::goOnOpening()
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
        Q_EMIT portOpened();
}

void EscLineAtWork::useOpened(Opening opening)
{
    for (const ProjectDevice &encoder : devicesOn(project().project(), id()))
        (void)opening.session->add(EscLineAddress::of(encoder.place().node), encoder.participant.deviceKey);
    replace(std::move(opening.session), nullptr, opening.port);
    m_openedWith = opening.wish;
    tellByteOrder();
}

// Nothing has been sent at this point.
void EscLineAtWork::endOpening()
{
    if (!isOpening())
        return;
    m_openingTurns.stop();
    m_opening = {};
    Q_EMIT openingChanged();
}

// For the project's encoders, also after undo, but not for those of the training line.
void EscLineAtWork::tellByteOrder()
{
    if (!m_session || m_training)
        return;
    for (const ProjectDevice &encoder : devicesOn(project().project(), id()))
        m_session->setSwapsWarningBytes(encoder.place(), encoder.its<EscEncoderSettings>().swapsWarningBytes);
}

EscLinePlan EscLineAtWork::asOpened(EscLinePlan line) const
{
    if (m_port == nullptr)
        return line;
    line.adapter = lineAdapter(m_port->adapter());
    if (const QString path = m_port->name(); path != portPath(line.settings.port))
        line.settings.port = path;
    return line;
}

EscLinePlan EscLineAtWork::opened() const
{
    EscLinePlan line;
    if (m_port == nullptr)
        return line;
    line.settings = m_openedWith;
    return asOpened(std::move(line));
}

void EscLineAtWork::close()
{
    endOpening();
    if (m_session)
        replace(nullptr, nullptr, nullptr);
}

} // namespace codewheel
