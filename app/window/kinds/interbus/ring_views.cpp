// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/interbus/ring_views.h"

#include "app/window/buses/leaving.h"
#include "app/window/buses/operate_question.h"
#include "app/window/connect/trouble_of.h"
#include "app/window/kinds/interbus/offer_views.h"
#include "app/window/kinds/interbus/ring_actions.h"
#include "app/window/kinds/interbus/ring_at_work.h"
#include "app/window/kinds/interbus/ring_connection.h"
#include "app/window/kinds/interbus/ring_links.h"
#include "app/window/kinds/interbus/ring_operate_warning.h"
#include "app/window/look/afresh.h"
#include "app/window/window_actions.h"
#include "kinds/interbus/ring/ring_messages.h"
#include "kinds/interbus/words/device_number.h"
#include "widgets/connect/connect_page.h"
#include "widgets/device/device_panel.h"
#include "widgets/eeprom/eeprom_question.h"
#include "widgets/functions/function_questions.h"
#include "widgets/help/help_topic.h"
#include "widgets/kinds/interbus/gateway/gateway_panel.h"
#include "widgets/kinds/interbus/gateway/registers_page.h"
#include "widgets/kinds/interbus/master/led_row.h"
#include "widgets/kinds/interbus/master/master_panel.h"
#include "widgets/kinds/interbus/master/ring_comparison.h"
#include "widgets/kinds/interbus/master/ring_plan_fields.h"
#include "widgets/kinds/interbus/offer/offer_page.h"
#include "widgets/kinds/interbus/training/training_panel.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/inline_message.h"
#include "widgets/project/device_names.h"
#include "widgets/project/project_document.h"
#include "widgets/structure/bus_branch.h"
#include "widgets/structure_editor/structure_editor.h"

#include <QAction>
#include <QPointer>
#include <QStackedWidget>

#include <algorithm>

namespace codewheel {

namespace {

QStackedWidget *eitherOf(QWidget *one, QWidget *other, QWidget *parent)
{
    auto *stack = new QStackedWidget(parent);
    stack->addWidget(one);
    stack->addWidget(other);
    return stack;
}

QWidget *noTraining(QWidget *parent)
{
    return new EmptyState(Icon::training, RingViews::tr("Not a training bus"),
                          RingViews::tr("Shafts can be turned and faults caused on a training bus only."),
                          parent);
}

} // namespace

RingViews::RingViews(RingAtWork &ring, const WindowParts &parts, QObject *parent)
    : BusViews(parent)
    , m_ring(ring)
    , m_parts(parts)
    , m_actions(parts.actions.ofKind<RingActions>())
    , m_status(parts.status)
    , m_connection(new RingConnection(ring, ring.project(), parts.leaving, parts.notice, this))
    , m_operateQuestion(new OperateQuestion(
          ring,
          [&project = ring.project()](const EncoderBus &bus) {
              return RingOperateWarning(bus,
                                        [&project](Place place, const QString &name) {
                                            return QStringLiteral("%1  %2").arg(
                                                place.shown(),
                                                calledText(project.device(place).station, name));
                                        })
                  .warning();
          },
          *parts.pages.window(), this))
    , m_master(new MasterPanel(*ring.bus(), &parts.pages))
    , m_gateway(new GatewayPanel(*ring.bus(), &parts.pages))
    , m_masterOrGateway(own(eitherOf(m_master, m_gateway, &parts.pages)))
    , m_training(new TrainingPanel(ring.sharedControls(), ring.id(), &parts.pages))
    , m_trainingOrNone(own(eitherOf(m_training, noTraining(&parts.pages), &parts.pages)))
    , m_connect(own(new ConnectPage(&parts.pages)))
    , m_registers(own(new RegistersPage(&parts.pages)))
    , m_links(
          new RingLinks({ring, *m_connection, parts.settings, parts.leaving, *m_connect, *m_registers}, this))
    , m_offerPage(own(new OfferPage(&parts.pages)))
    , m_offer(new OfferViews(ring, *m_offerPage, parts.settings, parts.status, this))
    , m_comparison(own(new RingComparison(ring.project(), *ring.bus(), &parts.pages)))
    , m_leds(own(new LedRow(*ring.bus(), &parts.device)))
    , m_planFields(own(new RingPlanFields(ring.project(), ring.id())))
{
    parts.editor.addFields(ring.id(), m_planFields);
    new DeviceNames(ring.project(), *ring.bus(), this);
    parts.pages.addWidget(m_comparison);
    setHelpTopic(*m_comparison, "project.md#comparing");
    parts.device.addRow(m_leds);
    m_connect->setObjectName(QStringLiteral("ringConnection"));
    m_registers->setObjectName(QStringLiteral("ringRegisters"));
    parts.pages.addWidget(m_connect);
    parts.pages.addWidget(m_registers);
    m_offerPage->setObjectName(QStringLiteral("offerPage"));
    parts.pages.addWidget(m_offerPage);
    setHelpTopic(*m_offerPage, "serving.md#in-the-window");
    setHelpTopic(*m_connect, "gateway.md#connecting");
    setHelpTopic(*m_registers, "gateway.md#registers");
    setHelpTopic(*m_gateway, "gateway.md#the-panel");
    connect(m_offer, &OfferViews::changed, this, &RingViews::showState);
    connect(m_gateway, &GatewayPanel::connectionWanted, this, &RingViews::showConnection);
    connect(m_gateway, &GatewayPanel::registersWanted, this, [this] { showRegisters(); });
    connect(&ring, &RingAtWork::linkChanged, this, &RingViews::showLink);
    connect(&ring.project(), &ProjectDocument::changed, this, &RingViews::showState);
    connect(m_connection, &RingConnection::told, this, &RingViews::told);
    connect(m_connection, &RingConnection::ringChanged, this, &RingViews::devicesChanged);
    connect(m_connection, &RingConnection::changed, this, &RingViews::showState);
    connect(m_connection, &RingConnection::refused, this, &RingViews::showRefused);
    connect(m_master, &MasterPanel::startRequested, m_ring.bus(), [this] { m_ring.bus()->setRunning(true); });
    connect(m_master, &MasterPanel::stopRequested, m_ring.bus(), [this] {
        m_parts.leaving.ask(Leaving::Why::stop, {m_ring.bus()}, [this] { m_ring.bus()->setRunning(false); });
    });
    connect(m_master, &MasterPanel::readInRequested, m_connection, &RingConnection::readIn);
    connect(m_master, &MasterPanel::asked, this, &RingViews::open);
    connect(m_comparison, &RingComparison::readInRequested, m_connection, &RingConnection::readIn);
    connect(m_training, &TrainingPanel::acted, this,
            [this](Place place, const TrainingAct &what) { tellTraining(place, what); });
    connect(m_training, &TrainingPanel::planned, this, [this](Place place, const TrainingAct &what) {
        tellTraining(place, what, RingMessageId::faultPlan);
    });
    connect(m_training, &TrainingPanel::afreshWanted, this, &RingViews::startAfresh);
    onAction(m_actions.connection, [this] { showConnection(); });
    onAction(m_actions.registers, [this] { showRegisters(); });
    onAction(m_actions.offer, [this] { showOffer(); });
    onAction(m_actions.endOffer, [this] { m_offer->end(); });
    onAction(m_actions.afresh, [this] { startAfresh(); });
    onAction(m_actions.connectBus, [this] { connectBus(); });
    onAction(m_actions.disconnectBus, [this] { m_connection->disconnectRing(); });
    onAction(m_actions.readIn, [this] { m_connection->readIn(); });
    onAction(m_actions.confirmDiagnostics, [this] { m_connection->confirmDiagnostics(); });
    onAction(m_actions.switchSegment, [this] {
        if (const auto segment = chosenSegment())
            m_master->toggleSegment(*segment);
    });
    showLink();
    showState();
}

// The link that is being entered.
std::any RingViews::takeWork()
{
    return m_connect->chosenLink();
}

void RingViews::goOn(const std::any &work)
{
    if (const auto *link = std::any_cast<int>(&work))
        m_connect->chooseLink(*link);
}

void RingViews::showPage(QWidget *page)
{
    m_parts.pages.setCurrentWidget(page);
    page->setFocus();
}

void RingViews::showConnection()
{
    m_links->listPorts();
    showPage(m_connect);
}

// Its page says how that went.
void RingViews::connectFound(const KindData &plan, const std::vector<KindData> &)
{
    showConnection();
    m_links->connectFound(plan);
}

void RingViews::showRegisters()
{
    m_links->showRegisters();
    if (m_chosen)
        m_registers->choose(m_chosen->node);
    showPage(m_registers);
}

void RingViews::showOffer()
{
    m_offer->listAddresses();
    showPage(m_offerPage);
}

// Where it was asked for.
void RingViews::showRefused(const Refusal &why)
{
    if (m_connect->isVisible())
        m_connect->setProblem(troubleOf(why));
    else
        m_parts.notice.showTrouble(Role::fault, troubleOf(why));
}

void RingViews::showLink()
{
    m_training->setControls(m_ring.sharedControls());
    const auto &gateway = m_ring.gateway();
    m_masterOrGateway->setCurrentIndex(gateway ? 1 : 0);
    if (gateway)
        m_gateway->setGateway(gatewayText(*gateway));
    showState();
}

std::vector<std::pair<const Panel *, QWidget *>> RingViews::pages() const
{
    return {{&panel::training, m_trainingOrNone}, {&masterPanel, m_masterOrGateway}};
}

void RingViews::setChosen(std::optional<Place> place)
{
    m_chosen = place;
    m_leds->setPlace(place);
    if (place)
        m_training->setDevice(*place);
    showState();
}

std::optional<int> RingViews::chosenSegment() const
{
    const MasterStatus *master = m_ring.bus()->master();
    if (!m_chosen || master == nullptr)
        return std::nullopt;
    const int segment = DeviceNumber::of(m_chosen->node).segment;
    return std::ranges::count(master->segments, segment, &MasterStatus::Segment::segment) > 0
               ? std::optional(segment)
               : std::nullopt;
}

void RingViews::open()
{
    Q_EMIT panelRequested(masterPanel);
}

bool RingViews::takesFaultPlans() const
{
    return m_ring.isOpen() && m_ring.bus()->isSimulated();
}

void RingViews::loadFaultPlan(const QString &path)
{
    Q_EMIT goToWanted(Place{m_ring.id()});
    Q_EMIT panelRequested(panel::training);
    m_training->loadFaultPlan(path);
}

void RingViews::connectBus()
{
    if (m_links->canConnect())
        m_connection->connectRing();
    else
        showConnection();
}

void RingViews::showFrame()
{
    if (m_registers->isVisible())
        m_links->showRegisters();
    m_offer->showFrame();
    m_training->refresh();
    showAfresh(m_training, m_actions.afresh, whyNotAfresh());
    showStatus();
}

void RingViews::askToOperate(const std::function<void()> &then)
{
    m_operateQuestion->ask(then);
}

void RingViews::compare()
{
    if (m_ring.isOpen())
        m_connection->tellComparison();
}

// Like the same actions elsewhere: whether the ring may be changed is checked again when they are carried
// out.
FaultBanner::Offer RingViews::offer(const Fault &fault, FaultAction action) const
{
    if (action == FaultAction::start)
        return {tr("Start again"), tr("Activates the configuration, and starts data transfer"),
                m_ring.bus()->isReadingIn() ? tr("The ring is being read in.") : QString()};
    if (action == FaultAction::acknowledge)
        return {
            tr("Acknowledge"),
            tr("Writes the register that acknowledges the watchdog of the gateway, as the connection says"),
            {}};
    if (action == FaultAction::bringBack)
        return {m_ring.bus()->isOperating() ? tr("Bring back") : tr("Operate, and bring back"),
                tr("Goes to Operate, sets OUT of %1 to 00000000, and reads what is not known since")
                    .arg(fault.node.toString()),
                m_ring.bus()->isRunning() ? QString() : tr("The bus does not run. Start it first.")};
    if (action == FaultAction::positionMode)
        return {m_ring.bus()->isOperating() ? tr("Position mode") : tr("Operate, and position mode"),
                tr("Switches %1 back to position mode, after asking").arg(fault.node.toString()),
                m_ring.bus()->isRunning() ? QString() : tr("The bus does not run. Start it first.")};
    const QString whyNot =
        m_ring.bus()->isOperating() ? QString() : tr("The program only watches. Switch to Operate first.");
    if (action == FaultAction::run)
        return {tr("Send run"),
                tr("Sends 80000000 to %1, then 00000000: what it has taken becomes valid, and it shows its "
                   "position again")
                    .arg(fault.node.toString()),
                whyNot};
    if (action == FaultAction::confirm)
        return {tr("Confirm"), tr("Confirms the diagnostics; a fault whose cause is still there comes back"),
                whyNot};
    return {
        tr("Switch segment off"),
        tr("Takes segment %1, and what is behind it, out of the data cycles, after asking. The rest can be "
           "started then.")
            .arg(DeviceNumber::of(fault.cutOff).segment),
        whyNot};
}

void RingViews::act(const Fault &fault, FaultAction action)
{
    if (action == FaultAction::start)
        m_ring.bus()->setRunning(true);
    else if (action == FaultAction::confirm)
        m_connection->confirmDiagnostics();
    else if (action == FaultAction::acknowledge)
        m_ring.bus()->acknowledgeWatchdog();
    else if (action == FaultAction::run)
        sendRun(m_ring.bus()->placeOf(fault.node));
    else if (action == FaultAction::positionMode)
        askToOperate([this, place = m_ring.bus()->placeOf(fault.node)] { goToPositionMode(place); });
    else if (action == FaultAction::bringBack)
        askToOperate([this, place = m_ring.bus()->placeOf(fault.node)] { m_ring.bus()->bringBack(place); });
    else
        m_master->toggleSegment(DeviceNumber::of(fault.cutOff).segment);
}

void RingViews::sendRun(Place place)
{
    const EncoderSession *encoder = m_ring.bus()->encoder(place.node);
    if (encoder != nullptr && askToSendRun(m_parts.pages.window(), *encoder))
        m_ring.bus()->sendRun(place);
}

void RingViews::goToPositionMode(Place place)
{
    QWidget *window = m_parts.pages.window();
    const QPointer<EncoderSession> encoder = m_ring.bus()->encoder(place.node);
    const Job job = SwitchMode{Mode::position};
    if (!encoder || (encoder->latest().mode == Mode::cam && !askToLeaveCamMode(window, *encoder)) ||
        !encoder || !askForEeprom(window, *encoder, job) || !encoder)
        return;
    if (const auto started = encoder->start(job); !started)
        showRefused(started.error());
}

QAction *RingViews::actionFor(DataCheck::Action action) const
{
    switch (action) {
    case DataCheck::Action::connectBus:
        return m_actions.connectBus;
    case DataCheck::Action::connection:
        return m_actions.connection;
    case DataCheck::Action::registers:
        return m_actions.registers;
    case DataCheck::Action::confirm:
        return m_actions.confirmDiagnostics;
    default:
        return nullptr;
    }
}

void RingViews::setHasKeys(bool has)
{
    m_actions.setHasKeys(has);
}

void RingViews::showCurrent()
{
    if (!isCurrent())
        leaveActions();
    showState();
}

// The next current ring sets them as it needs them.
void RingViews::leaveActions()
{
    m_actions.disable();
    m_status.clear();
}

// Shafts of the training plant are not those of a ring that is planned behind a gateway.
void RingViews::showTraining()
{
    const bool isReal = m_ring.gateway() || (!m_ring.isOpen() && m_links->plansGateway());
    m_trainingOrNone->setCurrentIndex(isReal ? 1 : 0);
}

QString RingViews::whyNotAfresh() const
{
    return m_ring.bus()->isReadingIn() ? tr("The ring is being read in.") : Afresh::whyNot(m_ring.bus());
}

// It may have become impossible since the last frame.
void RingViews::startAfresh()
{
    if (!whyNotAfresh().isEmpty())
        return;
    m_connection->startAfresh();
    tellTraining(Place{m_ring.id()}, startedAfresh());
}

void RingViews::showState()
{
    showTraining();
    if (!isCurrent())
        return;
    const RingSession &bus = *m_ring.bus();
    const bool isClosed = bus.state() == BusState::closed;
    const bool hasMaster = m_ring.isOpen() && bus.master() != nullptr;
    m_actions.tellBus(called());
    showAfresh(m_training, m_actions.afresh, whyNotAfresh());
    m_actions.connection->setEnabled(isMeant());
    m_actions.showRegisters(isMeant() && (m_ring.gateway() || m_links->plansGateway()));
    m_actions.showOffer(m_offer->whyNot(), m_offer->isOn());
    m_actions.offer->setEnabled(isMeant() && m_actions.offer->isEnabled());
    m_actions.connectBus->setEnabled(isMeant() && isClosed);
    m_actions.disconnectBus->setEnabled(isMeant() && !isClosed);
    if (isClosed)
        m_actions.tellWhyNotDisconnected(tr("The ring is not connected."));
    m_actions.readIn->setEnabled(isMeant() && hasMaster && !bus.isReadingIn());
    m_actions.confirmDiagnostics->setEnabled(isMeant() && hasMaster);
    m_actions.showSegment(hasMaster, chosenSegment().has_value());
    showStatus();
}

void RingViews::showStatus()
{
    if (!isCurrent())
        return;
    if (m_ring.isOpen())
        m_status.show(*m_ring.bus(), m_ring.gateway() ? gatewayText(*m_ring.gateway()) : QString());
    else
        m_status.clear();
}

QWidget *RingViews::comparison() const
{
    return m_comparison;
}

} // namespace codewheel
