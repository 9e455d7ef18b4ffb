// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/buses/asked_bus_views.h"

#include "app/window/buses/asked_bus_actions.h"
#include "app/window/buses/asked_bus_at_work.h"
#include "app/window/buses/asked_bus_keeper.h"
#include "app/window/buses/leaving.h"
#include "app/window/buses/operate_question.h"
#include "app/window/connect/port_rows.h"
#include "app/window/connect/trouble_of.h"
#include "app/window/look/afresh.h"
#include "app/window/look/status_line.h"
#include "vocabulary/refusal_text.h"
#include "widgets/comparison/comparison_page.h"
#include "widgets/connect/connect_page.h"
#include "widgets/help/help_topic.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/role_label.h"
#include "widgets/project/project_document.h"

#include <QStackedWidget>
#include <QVBoxLayout>

#include <utility>

namespace codewheel {
namespace {

struct WorkOnBus
{
    std::any rows;
    int link = 0; // that is being entered
};

} // namespace

AskedBusViews::AskedBusViews(AskedBusAtWork &bus, AskedBusActions &actions, const WindowParts &parts,
                             Traits traits, QObject *parent)
    : BusViews(parent)
    , m_bus(bus)
    , m_actions(actions)
    , m_parts(parts)
    , m_traits(std::move(traits))
    , m_state(own(parts.status.addState()))
    , m_notice(own(new InlineMessage(&parts.pages)))
    , m_operateQuestion(new OperateQuestion(bus, m_traits.operateWarning, *parts.pages.window(), this))
    , m_connection(own(new ConnectPage(&parts.pages)))
    , m_comparison(own(new ComparisonPage(bus.project(), bus.catalog(), bus.id(), bus.kind(), &parts.pages)))
{
    m_notice->setObjectName(m_traits.name + QStringLiteral("Notice"));
    parts.notices.insertWidget(0, m_notice);
    m_connection->setObjectName(m_traits.name + QStringLiteral("Settings"));
    setHelpTopic(*m_connection, m_traits.connecting);
    setHelpTopic(*m_comparison, "project.md#comparing");
    connect(m_connection, &ConnectPage::portsWanted, this, &AskedBusViews::listPorts);
    connect(m_connection, &ConnectPage::connectWanted, this, &AskedBusViews::connectAs);
    connect(m_connection, &ConnectPage::keepWanted, this,
            [this](const KindData &plan) { keepLink(wanted(plan)); });
    connect(m_connection, &ConnectPage::testWanted, this,
            [this](const KindData &plan) { test(wanted(plan)); });
    connect(m_connection, &ConnectPage::testCancelled, &m_test, &BackgroundSteps::cancel);
    connect(&m_test, &BackgroundSteps::ended, this, [this] { m_connection->setTesting(false); });
    connect(m_connection, &ConnectPage::agreed, this, &AskedBusViews::connectAgreed);
    onAction(actions.settings, [this] { showSettings(); });
    onAction(actions.search, [this] { showSearch(); });
    onAction(actions.training, [this] { connectSimulated(); });
    onAction(actions.afresh, [this] { startAfresh(); });
    onAction(actions.disconnectBus, [this] { disconnectBus(); });
    onAction(actions.remove, [this] { removeChosen(); });
}

AskedBusViews::~AskedBusViews() = default;

void AskedBusViews::begin(AskedBusKeeper &keeper, Page &search)
{
    m_keeper = &keeper;
    m_search = &search;
    for (QWidget *page : std::initializer_list<QWidget *>{m_connection, m_search, m_comparison})
        m_parts.pages.addWidget(page);
    connect(&m_bus.project(), &ProjectDocument::replaced, this, &AskedBusViews::showPlanned);
    connect(&m_bus.project(), &ProjectDocument::changed, this, &AskedBusViews::showChosen);
    connect(&m_bus.project(), &ProjectDocument::changed, this, &AskedBusViews::showName);
    connect(&m_bus.project(), &ProjectDocument::changed, this, &AskedBusViews::showNewPlan);
    connect(&m_bus, &AskedBusAtWork::opened, this, &AskedBusViews::showOpened);
    connect(&m_bus, &AskedBusAtWork::openRefused, this, &AskedBusViews::showRefused);
    connect(&m_bus, &AskedBusAtWork::openingChanged, this, [this] {
        m_connection->setConnecting(m_bus.isOpening());
        showEncoders();
    });
    connect(&m_bus, &AskedBusAtWork::aboutToChange, this, [this] { follow(nullptr); });
    const auto followPresent = [this] { follow(static_cast<AskedBus *>(m_bus.bus())); };
    connect(&m_bus, &AskedBusAtWork::changed, this, followPresent);
    followPresent();
    showPlanned();
}

AskedBus *AskedBusViews::session() const
{
    return m_session;
}

QWidget *AskedBusViews::comparison() const
{
    return m_comparison;
}

QMenu *AskedBusViews::menu() const
{
    return m_actions.menu;
}

void AskedBusViews::follow(AskedBus *bus)
{
    if (m_session) {
        m_session->disconnect(this);
        m_session->disconnect(m_keeper);
    }
    m_session = bus;
    m_notice->withdraw();
    if (bus != nullptr) {
        connect(bus, &EncoderBus::nodesChanged, this, &AskedBusViews::watchJobs);
        connect(bus, &EncoderBus::nodesChanged, this, &AskedBusViews::showEncoders);
    }
    watchJobs();
    setBus(bus);
    m_comparison->setBus(bus);
    using enum ConnectPage::Connected;
    m_connection->setConnected(bus == nullptr ? no : m_bus.isSimulatedHere() ? simulated : real);
    showStatus();
    showEncoders();
}

void AskedBusViews::watchJobs()
{
    if (!m_session)
        return;
    for (const Place place : m_session->places())
        if (const EncoderSession *encoder = m_session->encoder(place)) {
            disconnect(encoder, &EncoderSession::finished, this, nullptr);
            connect(encoder, &EncoderSession::finished, this,
                    [this, encoder](const Outcome &outcome) { jobEnded(*encoder, outcome); });
        }
}

void AskedBusViews::showCurrent()
{
    showStatus();
    tellActions();
}

void AskedBusViews::showFrame()
{
    tellAfresh();
    showStatus();
}

void AskedBusViews::showStatus()
{
    const bool isShown = isCurrent() && m_session && m_session->isOpen();
    m_state->setVisible(isShown);
    if (!isShown)
        return;
    const ShownStatus now = status();
    m_state->setState(now.role, now.text);
    if (!now.figures.isEmpty() && m_state->toolTip() != now.figures)
        m_state->setToolTip(now.figures);
}

// A job that begins or ends decides, too.
void AskedBusViews::tellAfresh()
{
    showAfresh(training(), m_actions.afresh, Afresh::whyNot(m_session));
}

void AskedBusViews::tellActions()
{
    if (!isCurrent())
        return;
    m_actions.tellBus(nameAmongOthers(m_bus.id())); // their menu already says which kind of bus it is
    const bool isConnected = m_session != nullptr || m_bus.isOpening();
    m_actions.disconnectBus->setEnabled(isMeant() && isConnected);
    if (!isConnected)
        m_actions.tellWhyNotDisconnected(m_traits.whyNotDisconnected);
    m_actions.training->setEnabled(isMeant() && !m_bus.isSimulatedHere());
    tellAfresh();
    showChosen();
}

void AskedBusViews::choose(std::optional<Place> place)
{
    m_chosen = place;
    showChosen();
}

void AskedBusViews::askToOperate(const std::function<void()> &then)
{
    m_operateQuestion->ask(then);
}

QAction *AskedBusViews::actionFor(DataCheck::Action action) const
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

void AskedBusViews::setHasKeys(bool has)
{
    m_actions.setHasKeys(has);
}

std::any AskedBusViews::takeWork()
{
    return WorkOnBus{takeRows(), m_connection->chosenLink()};
}

void AskedBusViews::goOn(const std::any &work)
{
    const auto *before = std::any_cast<WorkOnBus>(&work);
    if (before == nullptr)
        return;
    showRows(before->rows);
    m_connection->chooseLink(before->link);
}

void AskedBusViews::showSearch()
{
    m_parts.pages.setCurrentWidget(m_search);
    m_search->setFocus();
}

void AskedBusViews::showSettings()
{
    listPorts();
    m_parts.pages.setCurrentWidget(m_connection);
    m_connection->setFocus();
}

void AskedBusViews::listPorts()
{
    const PortRows ports = portRows(m_bus.ports());
    m_connection->setPorts(ports.rows, ports.trouble);
}

void AskedBusViews::connectAs(const KindData &plan)
{
    if (plan == KindData())
        connectSimulated();
    else
        afterLeaving([this, wish = wanted(plan)] { m_bus.open(wish); });
}

void AskedBusViews::connectAgreed(const KindData &plan)
{
    afterLeaving([this, wish = wanted(plan)] { m_bus.openAgreed(wish); });
}

void AskedBusViews::keepLink(const KindData &plan)
{
    m_keeper->keepLink(plan);
}

void AskedBusViews::showOpened()
{
    m_connection->setProblem({});
    keepLink(m_bus.openedWith());
    if (isCurrent())
        open();
}

void AskedBusViews::showRefused(const Refusal &why)
{
    if (why.id == m_traits.mayAgree)
        m_connection->ask(refusalText(why), m_traits.agreement);
    else
        m_connection->setProblem(troubleOf(why));
}

void AskedBusViews::showPlanned()
{
    if (const PlannedBus *planned = m_keeper->planned())
        m_connection->showPlan(planned->settings);
    showName();
}

// What is being entered for a bus that is planned already stays.
void AskedBusViews::showNewPlan()
{
    const bool isPlanned = m_keeper->planned() != nullptr;
    if (isPlanned && !std::exchange(m_isPlanned, isPlanned))
        showPlanned();
    m_isPlanned = isPlanned;
}

void AskedBusViews::showName()
{
    const PlannedBus *planned = findBus(m_bus.project().project(), m_bus.id());
    const QString name = planned != nullptr ? planned->name : m_bus.nameOfNew();
    m_connection->setAbout(name);
    m_search->setAbout(name);
}

std::span<const ProjectDevice> AskedBusViews::plannedEncoders() const
{
    return devicesOn(m_bus.project().project(), m_bus.id());
}

void AskedBusViews::beginTest()
{
    m_connection->setProblem({});
    m_connection->setTesting(true);
}

void AskedBusViews::addStep(CheckOutcome outcome, const QString &what, const QString &sentence,
                            const std::optional<Refusal> &why)
{
    m_connection->addStep(outcome, what, sentence);
    if (why)
        tellCommand(*m_connection, *why);
}

void AskedBusViews::afterLeaving(const std::function<void()> &then)
{
    m_parts.leaving.ask(Leaving::Why::disconnect, {m_bus.bus()}, then);
}

void AskedBusViews::connectSimulated()
{
    afterLeaving([this] {
        m_bus.connectTraining();
        showSimulated();
    });
}

// It may have become impossible since the last frame.
void AskedBusViews::startAfresh()
{
    if (!Afresh::whyNot(m_session).isEmpty())
        return;
    m_bus.startAfresh();
    tellTraining(Place{m_bus.id()}, startedAfresh());
}

void AskedBusViews::disconnectBus()
{
    afterLeaving([this] { m_bus.close(); });
}

void AskedBusViews::removeChosen()
{
    const auto chosen = m_chosen; // changes once it is removed
    const EncoderSession *encoder = chosen && m_session ? m_session->encoder(*chosen) : nullptr;
    if (encoder == nullptr)
        return;
    if (const auto removed = m_session->remove(*chosen)) {
        m_keeper->removeEncoder(*chosen);
    } else {
        m_parts.notice.showMessage(Role::attention, refusalText(removed.error()));
        connect(encoder, &EncoderSession::finished, &m_parts.notice, &InlineMessage::withdraw,
                Qt::SingleShotConnection);
    }
}

} // namespace codewheel
