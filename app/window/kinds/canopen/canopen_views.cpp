// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/canopen/canopen_views.h"

#include "app/window/buses/leaving.h"
#include "app/window/buses/operate_question.h"
#include "app/window/connect/link_test.h"
#include "app/window/connect/port_rows.h"
#include "app/window/connect/trouble_of.h"
#include "app/window/kinds/canopen/can_interface_rows.h"
#include "app/window/kinds/canopen/canopen_actions.h"
#include "app/window/kinds/canopen/canopen_at_work.h"
#include "app/window/kinds/canopen/canopen_keeper.h"
#include "app/window/look/afresh.h"
#include "app/window/look/described_action.h"
#include "app/window/window_actions.h"
#include "app/window/window_settings.h"
#include "can/can_refusals.h"
#include "kinds/canopen/bus/canopen_bus_refusals.h"
#include "kinds/canopen/bus/canopen_link_check.h"
#include "kinds/canopen/bus/canopen_session.h"
#include "kinds/canopen/protocol/canopen_refusals.h"
#include "kinds/canopen/protocol/cob_id.h"
#include "links/serial_ports.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "widgets/comparison/comparison_page.h"
#include "widgets/connect/connect_page.h"
#include "widgets/connect/plain_link_form.h"
#include "widgets/help/help_topic.h"
#include "widgets/kinds/canopen/can_bus_panel.h"
#include "widgets/kinds/canopen/can_search_page.h"
#include "widgets/kinds/canopen/can_settings_form.h"
#include "widgets/kinds/canopen/dictionary/dictionary_view.h"
#include "widgets/kinds/canopen/nmt_texts.h"
#include "widgets/kinds/canopen/traffic/can_traffic_view.h"
#include "widgets/look/inline_message.h"
#include "widgets/project/project_document.h"

#include <QAction>
#include <QMessageBox>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <utility>

namespace codewheel {
namespace {

struct WorkOnCanBus
{
    std::shared_ptr<const TrafficModel> traffic;
    int link = 0; // that is being entered
};

OperateWarning canOperateWarning(const EncoderBus &bus)
{
    const QString name = nameAmongOthers(bus.id());
    return {.question =
                name.isEmpty()
                    ? OperateQuestion::tr("This CAN bus is real. Shall the program send to it?")
                    : OperateQuestion::tr("%1 is a real CAN bus. Shall the program send to it?").arg(name),
            .explanation = OperateQuestion::tr(
                "In Operate, the encoders are asked for what they do not tell by themselves, and what you "
                "write goes to them. A preset or a parameter changes the position that the controller sees."),
            .helpTopic = "canopen.md#watch-and-operate"};
}

} // namespace

CanopenViews::CanopenViews(CanopenAtWork &bus, const WindowParts &parts, QObject *parent)
    : BusViews(parent)
    , m_bus(bus)
    , m_parts(parts)
    , m_actions(parts.actions.ofKind<CanopenActions>())
    , m_status(parts.status)
    , m_notice(own(new InlineMessage(&parts.pages)))
    , m_keeper(new CanopenKeeper(bus, bus.project(), this))
    , m_operateQuestion(new OperateQuestion(bus, canOperateWarning, *parts.pages.window(), this))
    , m_traffic(own(new CanTrafficView(&parts.pages)))
    , m_panel(own(new CanBusPanel(&parts.pages)))
    , m_objects(own(new DictionaryView(&parts.pages)))
    , m_search(own(new CanSearchPage(&parts.pages)))
    , m_connection(own(new ConnectPage(&parts.pages)))
    , m_interface(new CanSettingsForm(CanSettingsForm::Adapter::interface, m_connection))
    , m_adapter(new CanSettingsForm(CanSettingsForm::Adapter::serial, m_connection))
    , m_comparison(own(new ComparisonPage(bus.project(), bus.catalog(), bus.id(), bus.kind(), &parts.pages)))
{
    m_notice->setObjectName(QStringLiteral("canNotice"));
    parts.notices.insertWidget(0, m_notice);
    m_connection->setObjectName(QStringLiteral("canSettings"));
    m_connection->addForm(m_interface);
    m_connection->addForm(m_adapter);
    m_connection->addForm(new PlainLinkForm(
        tr("CAN training bus"),
        tr("Four simulated encoders on CANopen, one of them without a node number, in this program. Nothing "
           "leaves this computer."),
        {}, m_connection, [](const KindData &plan) {
            const auto *planned = plan.as<CanopenPlan>();
            return planned != nullptr && planned->settings.isSimulated();
        }));
    m_search->setObjectName(QStringLiteral("canSearch"));
    parts.pages.addWidget(m_connection);
    parts.pages.addWidget(m_search);
    parts.pages.addWidget(m_comparison);
    setHelpTopic(*m_connection, "canopen.md#connecting-in-the-window");
    setHelpTopic(*m_search, "canopen.md#searching-for-nodes");
    setHelpTopic(*m_comparison, "project.md#comparing");
    connect(m_traffic, &CanTrafficView::goToWanted, this, &CanopenViews::goToWanted);
    connect(m_panel, &CanBusPanel::commandWanted, this, &CanopenViews::askToCommand);
    connect(m_search, &CanSearchPage::takeOverWanted, this, &CanopenViews::takeOver);
    connect(m_connection, &ConnectPage::portsWanted, this, &CanopenViews::listAdapters);
    connect(m_connection, &ConnectPage::connectWanted, this, &CanopenViews::connectAs);
    connect(m_connection, &ConnectPage::keepWanted, this,
            [this](const KindData &plan) { m_keeper->keepLink(plan.as<CanopenPlan>()->settings); });
    connect(m_connection, &ConnectPage::testWanted, this, &CanopenViews::test);
    connect(m_connection, &ConnectPage::testCancelled, &m_test, &BackgroundSteps::cancel);
    connect(&m_test, &BackgroundSteps::ended, this, [this] { m_connection->setTesting(false); });
    connect(m_connection, &ConnectPage::agreed, this, &CanopenViews::connectUnsure);
    connect(m_notice, &InlineMessage::actionTriggered, this, &CanopenViews::agree);
    connect(&bus.project(), &ProjectDocument::replaced, this, &CanopenViews::showPlanned);
    connect(&bus.project(), &ProjectDocument::changed, this, &CanopenViews::showName);
    connect(&bus.project(), &ProjectDocument::changed, this, &CanopenViews::showNewPlan);
    connect(&bus, &CanopenAtWork::opened, this, &CanopenViews::showOpened);
    connect(&bus, &CanopenAtWork::openRefused, this, &CanopenViews::showRefused);
    connect(&bus, &CanopenAtWork::openingChanged, this, [this] {
        m_connection->setConnecting(m_bus.isOpening());
        tellActions();
    });
    connect(&bus, &CanopenAtWork::aboutToChange, this, [this] { setBus(nullptr); });
    connect(&bus, &CanopenAtWork::changed, this, [this] { setBus(m_bus.session()); });
    onAction(m_actions.settings, [this] { showSettings(); });
    onAction(m_actions.search, [this] { showSearch(); });
    onAction(m_actions.nodes, [this] { open(); });
    onAction(m_actions.remove, [this] { removeChosen(); });
    onAction(m_actions.training, [this] { connectTrainingBus(); });
    onAction(m_actions.afresh, [this] { startAfresh(); });
    onAction(m_actions.disconnectBus, [this] { disconnectBus(); });
    setBus(bus.session());
    showPlanned();
}

std::vector<std::pair<const Panel *, QWidget *>> CanopenViews::pages() const
{
    return {{&canTrafficPanel, m_traffic}, {&canBusPanel, m_panel}, {&canObjectsPanel, m_objects}};
}

QWidget *CanopenViews::comparison() const
{
    return m_comparison;
}

QMenu *CanopenViews::menu() const
{
    return m_actions.menu;
}

void CanopenViews::showCurrent()
{
    showStatus();
    tellActions();
}

void CanopenViews::showStatus()
{
    m_status.show(isCurrent() ? m_session.get() : nullptr);
}

void CanopenViews::tellActions()
{
    if (!isCurrent())
        return;
    m_actions.tellBus(nameAmongOthers(m_bus.id())); // their menu already says that it is a CAN bus
    const bool isConnected = m_session != nullptr || m_bus.isOpening();
    m_actions.disconnectBus->setEnabled(isMeant() && isConnected);
    if (!isConnected)
        m_actions.tellWhyNotDisconnected(tr("The CAN bus is not connected."));
    m_actions.training->setEnabled(isMeant() && m_bus.training() == nullptr);
    tellAfresh();
    showChosen();
}

void CanopenViews::showChosen()
{
    if (isCurrent())
        m_actions.showChosen(m_session && m_chosen && m_session->encoder(*m_chosen) != nullptr);
}

void CanopenViews::setChosen(std::optional<Place> place)
{
    m_chosen = place;
    if (place)
        m_panel->chooseNode(CanopenAddress::of(place->node).node);
    m_objects->setNode(place ? std::optional(CanopenAddress::of(place->node).node) : std::nullopt);
    showChosen();
}

void CanopenViews::setRecordingChosen(bool isChosen)
{
    m_traffic->setRecordingChosen(isChosen);
    m_objects->setRecordingChosen(isChosen);
}

void CanopenViews::useSettings(const ProgramSettings &settings)
{
    m_traffic->setMostRows(settings.traceRows);
}

// A job that begins or ends decides, too.
void CanopenViews::tellAfresh()
{
    if (!isCurrent())
        return;
    const QString whyNot = Afresh::whyNot(m_session);
    described(m_actions.afresh, m_actions.afresh->shortcut(), Afresh::tip(whyNot));
    m_actions.afresh->setEnabled(isMeant() && whyNot.isEmpty());
}

void CanopenViews::showFrame()
{
    tellAfresh();
    showStatus();
}

void CanopenViews::askToOperate(const std::function<void()> &then)
{
    m_operateQuestion->ask(then);
}

QAction *CanopenViews::actionFor(DataCheck::Action action) const
{
    switch (action) {
    case DataCheck::Action::connectBus:
    case DataCheck::Action::connection:
        return m_actions.settings;
    case DataCheck::Action::search:
        return m_actions.search;
    default:
        return nullptr;
    }
}

std::any CanopenViews::takeWork()
{
    return WorkOnCanBus{m_traffic->takeRows(), m_connection->chosenLink()};
}

void CanopenViews::goOn(const std::any &work)
{
    const auto *before = std::any_cast<WorkOnCanBus>(&work);
    if (before == nullptr)
        return;
    m_traffic->goOn(*before->traffic);
    m_connection->chooseLink(before->link);
}

void CanopenViews::open()
{
    Q_EMIT panelRequested(canBusPanel);
    m_panel->setFocus();
}

bool CanopenViews::open(Place place)
{
    open();
    m_panel->chooseNode(CanopenAddress::of(place.node).node);
    return true;
}

void CanopenViews::showSearch()
{
    m_parts.pages.setCurrentWidget(m_search);
    m_search->setFocus();
}

void CanopenViews::setBus(CanopenSession *bus)
{
    if (m_session)
        m_session->disconnect(this);
    m_session = bus;
    m_asked = Asked::nothing;
    m_notice->withdraw();
    if (bus != nullptr) {
        connect(bus, &CanopenSession::stateChanged, this, &CanopenViews::showState);
        connect(bus, &CanopenSession::watchNotSure, this, [this](const Refusal &why) {
            ask(Asked::unsureWatch, refusalText(why), tr("&Watch all the same"));
        });
        connect(bus, &CanopenSession::nodesChanged, this, &CanopenViews::tellActions);
        connect(bus, &CanopenSession::nodesChanged, this, &CanopenViews::watchJobs);
        connect(bus, &CanopenSession::frameSent, this, &CanopenViews::tellSent);
    }
    delete m_commandQuestion;
    watchJobs();
    m_traffic->setBus(bus);
    m_panel->setBus(bus);
    m_objects->setBus(bus);
    m_search->setBus(bus);
    m_comparison->setBus(bus);
    using enum ConnectPage::Connected;
    m_connection->setConnected(bus == nullptr ? no : m_bus.training() != nullptr ? simulated : real);
    showStatus();
    tellActions();
}

void CanopenViews::ask(Asked what, const QString &sentence, const QString &answer)
{
    if (std::exchange(m_asked, what) != what)
        m_notice->showMessage(Role::attention, sentence, answer);
}

void CanopenViews::withdraw(Asked what)
{
    if (m_asked != what)
        return;
    m_asked = Asked::nothing;
    m_notice->withdraw();
}

void CanopenViews::agree()
{
    m_notice->withdraw();
    const Asked asked = std::exchange(m_asked, Asked::nothing);
    if (!m_session)
        return;
    if (asked == Asked::unsureWatch)
        m_session->takeUnsureWatch();
    else if (asked == Asked::otherMaster)
        m_session->sendBesideOthers();
    else if (asked == Asked::stopOfNode && m_wouldStop) {
        m_session->mayStopNode(*m_wouldStop);
        m_parts.notice.showMessage(Role::running,
                                   sentence(tr("%1 may be stopped for a moment by the next job: "
                                               "start that again."),
                                            {m_wouldStop->shown()}));
    }
}

void CanopenViews::watchJobs()
{
    if (!m_session)
        return;
    for (const Place place : m_session->places())
        if (const EncoderSession *encoder = m_session->encoder(place)) {
            disconnect(encoder, &EncoderSession::finished, this, nullptr);
            connect(encoder, &EncoderSession::finished, this,
                    [this, place](const Outcome &outcome) { askToStop(place, outcome); });
        }
}

// A running node takes some objects only while it is pre-operational.
void CanopenViews::askToStop(Place place, const Outcome &outcome)
{
    if (outcome.result || outcome.result.error().id != CanopenRefusalId::nodeWouldStop) {
        withdraw(Asked::stopOfNode);
        return;
    }
    m_wouldStop = place;
    ask(Asked::stopOfNode, refusalText(outcome.result.error()), tr("S&top it for a moment"));
}

// Not by exec(): the bus may be left while it is open.
void CanopenViews::askToCommand(int node, canopen::NmtCommand command)
{
    delete m_commandQuestion;
    const NmtAction &action = nmtAction(command);
    m_commandQuestion = new QMessageBox(QMessageBox::Question, tr("Node"), action.question(node),
                                        QMessageBox::NoButton, m_parts.pages.window());
    m_commandQuestion->setObjectName(QStringLiteral("nmtQuestion"));
    m_commandQuestion->setAttribute(Qt::WA_DeleteOnClose);
    setHelpTopic(*m_commandQuestion, "canopen.md#the-panel");
    auto *send = m_commandQuestion->addButton(action.label(), QMessageBox::AcceptRole);
    send->setToolTip(action.toolTip());
    auto *leave = m_commandQuestion->addButton(tr("&Leave it"), QMessageBox::RejectRole);
    leave->setToolTip(tr("Nothing is sent (Esc)"));
    m_commandQuestion->setDefaultButton(leave);
    m_commandQuestion->setEscapeButton(leave);
    connect(send, &QPushButton::clicked, this, [this, node, command] { sendCommand(node, command); });
    m_commandQuestion->open();
}

// No node answers it: what it tells afterwards stands among the nodes.
void CanopenViews::sendCommand(int node, canopen::NmtCommand command)
{
    if (m_session)
        m_session->send(canopen::NmtRequest{command, node}.frame());
}

void CanopenViews::tellSent(const FrameSent &sent)
{
    if (sent.frame.id != canopen::CobId{.service = canopen::CobId::Service::nmt}.identifier())
        return;
    if (sent.refused)
        m_parts.notice.showMessage(Role::attention, refusalText(*sent.refused));
    else if (sent.fate == CanFate::refused)
        m_parts.notice.showMessage(Role::attention, tr("The command to the node could not be sent. Check the "
                                                       "CAN bus, then send it again."));
}

void CanopenViews::takeOver(const std::vector<CanFoundRow> &found)
{
    if (!m_session)
        return;
    std::vector<Place> taken;
    for (const CanFoundRow &row : found)
        if (m_session->add(row.found.node, row.deviceKey))
            taken.push_back(m_session->placeOf(CanopenAddress{row.found.node}.place()));
    m_keeper->keepEncoders(taken);
}

void CanopenViews::removeChosen()
{
    const auto chosen = m_chosen; // changes once it is removed
    if (!chosen || !m_session || m_session->encoder(*chosen) == nullptr)
        return;
    if (const auto removed = m_session->remove(*chosen))
        m_keeper->removeEncoder(*chosen);
    else
        m_parts.notice.showMessage(Role::attention, refusalText(removed.error()));
}

void CanopenViews::showState()
{
    const CanopenSnapshot &now = m_session->latest();
    if (now.connected)
        withdraw(Asked::unsureWatch);
    if (now.operate && now.isHeldBack())
        ask(Asked::otherMaster,
            refusalText({RefusalKind::busy, CanopenBusRefusalId::otherMaster, {now.otherMaster.argument()}}),
            tr("&Send all the same"));
    else
        withdraw(Asked::otherMaster);
}

void CanopenViews::showPlanned()
{
    if (const CanopenPlan *planned = canopenPlan(m_bus.project().project(), m_bus.id()))
        m_connection->showPlan(KindData(*planned));
    showName();
}

// What is being entered for a bus that is planned already stays.
void CanopenViews::showNewPlan()
{
    const bool isPlanned = canopenPlan(m_bus.project().project(), m_bus.id()) != nullptr;
    if (isPlanned && !std::exchange(m_isPlanned, isPlanned))
        showPlanned();
    m_isPlanned = isPlanned;
}

void CanopenViews::showName()
{
    const PlannedBus *planned = findBus(m_bus.project().project(), m_bus.id());
    const QString name = planned != nullptr ? planned->name : m_bus.nameOfNew();
    m_connection->setAbout(name);
    m_search->setAbout(name);
}

void CanopenViews::showSettings()
{
    listAdapters();
    m_parts.pages.setCurrentWidget(m_connection);
    m_connection->setFocus();
}

void CanopenViews::listAdapters()
{
    const PortRows ports = portRows(serialPorts());
    m_connection->setPorts(ports.rows, ports.trouble);
    m_interface->setInterfaces(canInterfaceRows(canInterfaces()));
}

void CanopenViews::connectAs(const KindData &plan)
{
    const auto *its = plan.as<CanopenPlan>();
    if (its == nullptr) {
        connectTrainingBus();
        return;
    }
    m_parts.leaving.ask(Leaving::Why::disconnect, {m_bus.session()}, [this, settings = its->settings] {
        m_wanted = settings;
        m_bus.open(settings);
    });
}

void CanopenViews::connectUnsure(const KindData &plan)
{
    m_parts.leaving.ask(Leaving::Why::disconnect, {m_bus.session()},
                        [this, settings = plan.as<CanopenPlan>()->settings] {
                            m_wanted = settings;
                            m_bus.openUnsure(settings);
                        });
}

// The planned nodes are listened for; without any, all that are heard are told.
void CanopenViews::test(const KindData &plan)
{
    const CanopenSettings settings = plan.as<CanopenPlan>()->settings;
    auto link = m_bus.makeLink(settings);
    if (!link) {
        m_connection->setProblem(troubleOf(link.error()));
        return;
    }
    std::vector<CanopenAddress> nodes;
    for (const ProjectDevice &encoder : devicesOn(m_bus.project().project(), m_bus.id()))
        nodes.push_back(CanopenAddress::of(encoder.place().node));
    m_connection->setProblem({});
    m_connection->setTesting(true);
    m_test.start(std::make_unique<LinkTest<CanopenLinkCheck, CanLink>>(
        *std::move(link),
        [this](const CanopenLinkFinding &finding) {
            m_connection->addStep(finding.outcome, CanopenLinkCheck::stepText(finding.step, finding.address),
                                  finding.sentence);
            if (finding.why)
                tellCommand(*m_connection, *finding.why);
        },
        settings.rate, nodes));
}

void CanopenViews::showOpened()
{
    m_connection->setProblem({});
    m_keeper->keepLink(m_wanted);
    if (isCurrent())
        open();
}

void CanopenViews::showRefused(const Refusal &why)
{
    if (why.id == CanRefusalId::watchNotSure)
        m_connection->ask(refusalText(why), tr("&Watch all the same"));
    else
        m_connection->setProblem(troubleOf(why));
}

// Its page says how that went.
void CanopenViews::connectFound(const KindData &plan, const std::vector<KindData> &)
{
    showSettings();
    m_connection->connectBy(plan);
}

void CanopenViews::connectTrainingBus()
{
    m_parts.leaving.ask(Leaving::Why::disconnect, {m_bus.session()}, [this] {
        m_bus.connectTraining();
        open();
    });
}

// It may have become impossible since the last frame.
void CanopenViews::startAfresh()
{
    if (!Afresh::whyNot(m_session).isEmpty())
        return;
    m_bus.startAfresh();
    tellTraining(Place{m_bus.id()}, startedAfresh());
}

void CanopenViews::disconnectBus()
{
    m_parts.leaving.ask(Leaving::Why::disconnect, {m_bus.session()}, [this] { m_bus.close(); });
}

} // namespace codewheel
