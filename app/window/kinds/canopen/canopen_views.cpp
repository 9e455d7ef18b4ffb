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
#include "can/can_refusals.h"
#include "kinds/canopen/bus/canopen_bus_refusals.h"
#include "kinds/canopen/bus/canopen_link_check.h"
#include "kinds/canopen/bus/canopen_session.h"
#include "links/serial_ports.h"
#include "vocabulary/refusal_text.h"
#include "widgets/comparison/comparison_page.h"
#include "widgets/connect/connect_page.h"
#include "widgets/connect/plain_link_form.h"
#include "widgets/help/help_topic.h"
#include "widgets/kinds/canopen/can_settings_form.h"
#include "widgets/look/inline_message.h"
#include "widgets/project/project_document.h"

#include <QAction>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <utility>

namespace codewheel {
namespace {

struct WorkOnCanBus
{
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
    parts.pages.addWidget(m_connection);
    parts.pages.addWidget(m_comparison);
    setHelpTopic(*m_connection, "canopen.md#connecting-in-the-window");
    setHelpTopic(*m_comparison, "project.md#comparing");
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
    onAction(m_actions.training, [this] { connectTrainingBus(); });
    onAction(m_actions.afresh, [this] { startAfresh(); });
    onAction(m_actions.disconnectBus, [this] { disconnectBus(); });
    setBus(bus.session());
    showPlanned();
}

std::vector<std::pair<const Panel *, QWidget *>> CanopenViews::pages() const
{
    return {};
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
    default:
        return nullptr;
    }
}

std::any CanopenViews::takeWork()
{
    return WorkOnCanBus{m_connection->chosenLink()};
}

void CanopenViews::goOn(const std::any &work)
{
    if (const auto *before = std::any_cast<WorkOnCanBus>(&work))
        m_connection->chooseLink(before->link);
}

void CanopenViews::open()
{
    showSettings();
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
    }
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
    m_connection->setAbout(planned != nullptr ? planned->name : m_bus.nameOfNew());
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
    m_parts.leaving.ask(Leaving::Why::disconnect, {m_bus.session()}, [this] { m_bus.connectTraining(); });
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
