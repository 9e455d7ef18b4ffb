// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/canopen/canopen_views.h"

#include "app/window/buses/operate_question.h"
#include "app/window/connect/trouble_of.h"
#include "app/window/kinds/canopen/can_interface_rows.h"
#include "app/window/kinds/canopen/canopen_actions.h"
#include "app/window/kinds/canopen/canopen_at_work.h"
#include "app/window/kinds/canopen/canopen_keeper.h"
#include "app/window/kinds/canopen/canopen_status.h"
#include "app/window/kinds/canopen/node_recognition.h"
#include "app/window/kinds/canopen/planned_objects.h"
#include "app/window/kinds/canopen/setups_under_way.h"
#include "app/window/look/page_place.h"
#include "app/window/window_actions.h"
#include "app/window/window_settings.h"
#include "can/can_refusals.h"
#include "kinds/canopen/bus/canopen_bus_refusals.h"
#include "kinds/canopen/bus/canopen_link_check.h"
#include "kinds/canopen/bus/canopen_session.h"
#include "kinds/canopen/plan/canopen_plan.h"
#include "kinds/canopen/protocol/canopen_refusals.h"
#include "kinds/canopen/protocol/cob_id.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "widgets/connect/connect_page.h"
#include "widgets/connect/plain_link_form.h"
#include "widgets/help/help_topic.h"
#include "widgets/kinds/canopen/can_bus_panel.h"
#include "widgets/kinds/canopen/can_search_page.h"
#include "widgets/kinds/canopen/can_settings_form.h"
#include "widgets/kinds/canopen/dictionary/dictionary_view.h"
#include "widgets/kinds/canopen/nmt_texts.h"
#include "widgets/kinds/canopen/setup/can_replace_steps.h"
#include "widgets/kinds/canopen/setup/node_setup_page.h"
#include "widgets/kinds/canopen/setup/node_setup_view.h"
#include "widgets/kinds/canopen/traffic/can_traffic_view.h"
#include "widgets/kinds/canopen/training/can_training_panel.h"
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

constexpr char nodeSetupTopic[] = "canopen.md#number-and-rate";

OperateWarning canOperateWarning(const EncoderBus &bus)
{
    const QString name = nameAmongOthers(bus.id());
    const auto *session = qobject_cast<const CanopenSession *>(&bus);
    const bool isSilent = session != nullptr && session->latest().figures.isNothingHeard();
    return {
        .question =
            name.isEmpty()
                ? OperateQuestion::tr("This CAN bus is real. Shall the program send to it?")
                : OperateQuestion::tr("%1 is a real CAN bus. Shall the program send to it?").arg(name),
        .explanation =
            (isSilent ? OperateQuestion::tr("Nothing was heard on the bus so far: the rate may be wrong, or "
                                            "nobody there.") +
                            QStringLiteral("\n\n")
                      : QString()) +
            OperateQuestion::tr(
                "In Operate, the encoders are asked for what they do not tell by themselves, and what you "
                "write goes to them. A preset or a parameter changes the position that the controller sees."),
        .helpTopic = "canopen.md#watch-and-operate"};
}

} // namespace

CanopenViews::CanopenViews(CanopenAtWork &bus, const WindowParts &windowParts, QObject *parent)
    : AskedBusViews(bus, windowParts.actions.ofKind<CanopenActions>(), windowParts,
                    {.name = QStringLiteral("can"),
                     .connecting = "canopen.md#connecting-in-the-window",
                     .operateWarning = canOperateWarning,
                     .whyNotDisconnected = tr("The CAN bus is not connected."),
                     .mayAgree = CanRefusalId::watchNotSure,
                     .agreement = tr("&Watch all the same")},
                    parent)
    , m_bus(bus)
    , m_actions(windowParts.actions.ofKind<CanopenActions>())
    , m_keeper(new CanopenKeeper(bus, this))
    , m_startNode(new QAction(nmtAction(canopen::NmtCommand::start).label(), this))
    , m_recognition(new NodeRecognition(bus.project(), this))
    , m_search(own(new CanSearchPage(&windowParts.pages)))
    , m_places{makePlace(), makePlace(), makePlace(), makePlace()}
    , m_training(own(new CanTrainingPanel(bus.id(), &windowParts.pages)))
    , m_setups(new SetupsUnderWay(this))
    , m_interface(new CanSettingsForm(CanSettingsForm::Adapter::interface, &connection()))
    , m_adapter(new CanSettingsForm(CanSettingsForm::Adapter::serial, &connection()))
{
    connection().addForm(m_interface);
    connection().addForm(m_adapter);
    connection().addForm(new PlainLinkForm(
        tr("CAN training bus"),
        tr("Four simulated encoders on CANopen, one of them without a node number, in this program. Nothing "
           "leaves this computer."),
        {}, &connection(), [](const KindData &plan) {
            const auto *planned = plan.as<CanopenPlan>();
            return planned != nullptr && planned->settings.isSimulated();
        }));
    m_search->setObjectName(QStringLiteral("canSearch"));
    windowParts.pages.addWidget(m_places.setup);
    setHelpTopic(*m_places.setup, nodeSetupTopic);
    setHelpTopic(*m_search, "canopen.md#searching-for-nodes");
    connect(&notice(), &InlineMessage::actionTriggered, this, &CanopenViews::agree);
    setHelpTopic(*m_training, "training.md#the-can-bus");
    connect(m_search, &CanSearchPage::takeOverWanted, this, &CanopenViews::takeOver);
    connect(m_training, &CanTrainingPanel::acted, this,
            [this](Place place, const TrainingAct &what) { tellTraining(place, what); });
    connect(m_training, &CanTrainingPanel::afreshWanted, this, &CanopenViews::startAfresh);
    connect(&bus.project(), &ProjectDocument::changed, this, &CanopenViews::showPlannedObjects);
    connect(m_recognition, &NodeRecognition::recognised, this, &CanopenViews::tellRecognised);
    onAction(m_actions.nodes, [this] { open(); });
    onAction(m_actions.unnumbered, [this] { showSetup({}); });
    onAction(m_actions.setup, [this] {
        if (chosen())
            showSetup(CanopenAddress::of(chosen()->node).node);
    });
    connect(m_startNode, &QAction::triggered, this, [this] {
        if (chosen())
            askToCommand(CanopenAddress::of(chosen()->node).node, canopen::NmtCommand::start);
    });
    begin(*m_keeper, *m_search);
}

QAction *CanopenViews::actionFor(DataCheck::Action action) const
{
    if (action != DataCheck::Action::startNode)
        return AskedBusViews::actionFor(action);
    m_startNode->setEnabled(chosen() && session() != nullptr && session()->isOperating() &&
                            session()->latest().connected);
    return m_startNode;
}

PagePlace *CanopenViews::makePlace()
{
    auto *its = own(new PagePlace(&parts().pages));
    connect(its, &PagePlace::pageWanted, this, &CanopenViews::made);
    return its;
}

CanopenViews::Made &CanopenViews::made()
{
    if (m_made)
        return *m_made;
    QWidget *window = &parts().pages;
    m_made = Made{.traffic = own(new CanTrafficView(window)),
                  .panel = own(new CanBusPanel(window)),
                  .objects = own(new DictionaryView(window)),
                  .setup = own(new NodeSetupPage(window))};
    m_made->setup->setObjectName(QStringLiteral("canSetup"));
    setHelpTopic(*m_made->setup, nodeSetupTopic);
    connectMade();
    useSettings(parts().settings.choices());
    setRecordingChosen(m_isRecordingChosen);
    tellBus();
    setChosen(chosen());
    m_places.traffic->giveWay(m_made->traffic);
    m_places.panel->giveWay(m_made->panel);
    m_places.objects->giveWay(m_made->objects);
    m_places.setup->giveWay(m_made->setup);
    return *m_made;
}

void CanopenViews::connectMade()
{
    connect(m_made->traffic, &CanTrafficView::goToWanted, this, &CanopenViews::goToWanted);
    connect(m_made->objects, &DictionaryView::fileChosen, m_keeper, &CanopenKeeper::keepFile);
    connect(m_made->panel, &CanBusPanel::commandWanted, this, &CanopenViews::askToCommand);
    connect(m_made->panel, &CanBusPanel::setupWanted, this, &CanopenViews::showSetup);
    connect(m_made->panel, &CanBusPanel::searchWanted, this, [this] { showSetup({}); });
    connect(&m_made->setup->view(), &NodeSetupView::numbered, this, &CanopenViews::takeNumbered);
    connect(&m_made->setup->view(), &NodeSetupView::messaged, this, &CanopenViews::told);
    m_setups->add(m_made->setup->view());
}

void CanopenViews::tellBus()
{
    m_made->traffic->setBus(session());
    m_made->panel->setBus(session());
    m_made->objects->setBus(session());
    m_made->setup->setBus(session());
    showPlannedObjects();
}

CanopenSession *CanopenViews::session() const
{
    return static_cast<CanopenSession *>(AskedBusViews::session());
}

std::vector<std::pair<const Panel *, QWidget *>> CanopenViews::pages() const
{
    return {{&panel::training, m_training},
            {&canTrafficPanel, m_places.traffic->page()},
            {&canBusPanel, m_places.panel->page()},
            {&canObjectsPanel, m_places.objects->page()}};
}

void CanopenViews::showChosen()
{
    if (isCurrent())
        m_actions.showChosen(session() && chosen() && session()->encoder(*chosen()) != nullptr);
}

void CanopenViews::setChosen(std::optional<Place> place)
{
    if (m_made && place)
        m_made->panel->chooseNode(CanopenAddress::of(place->node).node);
    if (m_made)
        m_made->objects->setNode(place ? std::optional(CanopenAddress::of(place->node).node) : std::nullopt);
    m_training->setDevice(place.value_or(Place{m_bus.id(), {}}));
    choose(place);
}

void CanopenViews::showPlannedObjects()
{
    if (m_made)
        m_made->objects->setPlanned(plannedObjectsOn(m_bus));
}

void CanopenViews::showFrame()
{
    m_recognition->goOn();
    m_training->refresh();
    AskedBusViews::showFrame();
}

void CanopenViews::tellRecognised(Place place, const QString &device)
{
    parts().notice.showMessage(
        Role::running, sentence(tr("By its identity, %1 is described as %2."), {place.shown(), device}));
}

void CanopenViews::setRecordingChosen(bool isChosen)
{
    m_isRecordingChosen = isChosen;
    if (!m_made)
        return;
    m_made->traffic->setRecordingChosen(isChosen);
    m_made->objects->setRecordingChosen(isChosen);
}

void CanopenViews::useSettings(const ProgramSettings &settings)
{
    if (m_made)
        m_made->traffic->setMostRows(settings.traceRows);
}

void CanopenViews::open()
{
    Q_EMIT panelRequested(canBusPanel);
    made().panel->setFocus();
}

bool CanopenViews::open(Place place)
{
    open();
    made().panel->chooseNode(CanopenAddress::of(place.node).node);
    return true;
}

// Nothing is sent before a button of the page is pressed.
void CanopenViews::showSetup(std::optional<int> node)
{
    NodeSetupPage *setup = made().setup;
    setup->setAbout(nameAmongOthers(m_bus.id()));
    setup->showNode(node);
    parts().pages.setCurrentWidget(setup);
    setup->setFocus();
}

bool CanopenViews::isWriting() const
{
    return m_made && m_made->setup->view().isBusy();
}

std::optional<WorkUnderWay> CanopenViews::underWay() const
{
    return m_setups->now();
}

void CanopenViews::breakOff(const std::function<void(bool isSettled)> &then)
{
    const bool isOnPage = m_made && m_made->setup->view().isBusy();
    m_setups->breakOff([this, isOnPage, then](bool isSettled) {
        if (!isSettled && isOnPage)
            parts().pages.setCurrentWidget(m_made->setup);
        then(isSettled);
    });
}

ReplaceStepsOfKind CanopenViews::replaceSteps(Replacing &replacing)
{
    auto *number = new CanReplaceNumberStep(replacing);
    connect(number, &CanReplaceNumberStep::messaged, this, &CanopenViews::told);
    m_setups->add(number->view());
    return {.begin = number, .end = new CanReplaceProofStep(replacing, *number)};
}

// Of one that was in no project, Search for nodes tells what it is.
void CanopenViews::takeNumbered(int before, int after)
{
    CanopenSession *bus = session();
    if (bus == nullptr || before == 0 || before == after)
        return;
    const Place from = bus->placeOf(CanopenAddress{before}.place());
    if (bus->encoder(from) == nullptr)
        return;
    const NodeId to = CanopenAddress{after}.place();
    if (const auto moved = bus->renumber(from, to))
        m_keeper->moveEncoder(from, bus->placeOf(to));
    else
        parts().notice.showMessage(Role::attention, refusalText(moved.error()));
}

void CanopenViews::setBus(AskedBus *)
{
    CanopenSession *bus = session();
    m_asked = Asked::nothing;
    if (bus != nullptr) {
        connect(bus, &CanopenSession::stateChanged, this, &CanopenViews::showState);
        connect(bus, &CanopenSession::watchNotSure, this, [this](const Refusal &why) {
            ask(Asked::unsureWatch, refusalText(why), tr("&Watch all the same"));
        });
        connect(bus, &CanopenSession::nodesChanged, this, &CanopenViews::showPlannedObjects);
        connect(bus, &CanopenSession::frameSent, this, &CanopenViews::tellSent);
    }
    delete m_commandQuestion;
    if (m_made)
        tellBus();
    else if (bus != nullptr)
        made();
    m_search->setBus(bus);
    m_recognition->setBus(bus);
    m_training->setPlant(bus != nullptr ? m_bus.training() : nullptr, m_bus.trainingAdapter());
}

TrainingArea *CanopenViews::training() const
{
    return m_training;
}

void CanopenViews::ask(Asked what, const QString &sentence, const QString &answer)
{
    if (std::exchange(m_asked, what) != what)
        notice().showMessage(Role::attention, sentence, answer);
}

void CanopenViews::withdraw(Asked what)
{
    if (m_asked != what)
        return;
    m_asked = Asked::nothing;
    notice().withdraw();
}

void CanopenViews::agree()
{
    notice().withdraw();
    const Asked asked = std::exchange(m_asked, Asked::nothing);
    if (!session())
        return;
    if (asked == Asked::unsureWatch)
        session()->takeUnsureWatch();
    else if (asked == Asked::otherMaster || asked == Asked::onlyJ1939)
        session()->sendBesideOthers();
    else if (asked == Asked::stopOfNode && m_wouldStop) {
        session()->mayStopNode(*m_wouldStop);
        parts().notice.showMessage(Role::running,
                                   sentence(tr("%1 may be stopped for a moment by the next job: "
                                               "start that again."),
                                            {m_wouldStop->shown()}));
    }
}

// A running node takes some objects only while it is pre-operational.
void CanopenViews::jobEnded(const EncoderSession &encoder, const Outcome &outcome)
{
    if (outcome.result || !canopen::isAboutStopping(outcome.result.error())) {
        withdraw(Asked::stopOfNode);
        return;
    }
    m_wouldStop = encoder.place();
    ask(Asked::stopOfNode, refusalText(outcome.result.error()), tr("S&top it for a moment"));
}

// Not by exec(): the bus may be left while it is open.
void CanopenViews::askToCommand(int node, canopen::NmtCommand command)
{
    delete m_commandQuestion;
    const NmtAction &action = nmtAction(command);
    m_commandQuestion = new QMessageBox(QMessageBox::Question, tr("Node"), action.question(node),
                                        QMessageBox::NoButton, parts().pages.window());
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
    if (session())
        session()->send(canopen::NmtRequest{command, node}.frame());
}

void CanopenViews::tellSent(const FrameSent &sent)
{
    if (sent.frame.id != canopen::CobId{.service = canopen::CobId::Service::nmt}.identifier())
        return;
    if (sent.refused)
        parts().notice.showMessage(Role::attention, refusalText(*sent.refused));
    else if (sent.fate == CanFate::refused)
        parts().notice.showMessage(Role::attention, tr("The command to the node could not be sent. Check the "
                                                       "CAN bus, then send it again."));
    else if (sent.fate == CanFate::notKnown)
        parts().notice.showMessage(Role::attention, tr("Whether the command to the node has gone out is not "
                                                       "known: the adapter does not tell."));
}

void CanopenViews::takeOver(const std::vector<CanFoundRow> &found)
{
    if (!session())
        return;
    std::vector<Place> taken;
    for (const CanFoundRow &row : found)
        if (session()->add(row.found.node, row.deviceKey))
            taken.push_back(session()->placeOf(CanopenAddress{row.found.node}.place()));
    m_keeper->keepEncoders(taken);
}

void CanopenViews::showState()
{
    const CanopenSnapshot &now = session()->latest();
    if (now.connected)
        withdraw(Asked::unsureWatch);
    const auto held = now.operate ? whyHeldBack(now) : std::nullopt;
    for (const auto &[asked, why] : {std::pair(Asked::otherMaster, CanopenBusRefusalId::otherMaster),
                                     std::pair(Asked::onlyJ1939, CanopenBusRefusalId::onlyJ1939)})
        if (held && held->id == why)
            ask(asked, refusalText(*held), tr("&Send all the same"));
        else
            withdraw(asked);
}

void CanopenViews::listPorts()
{
    AskedBusViews::listPorts();
    m_interface->setInterfaces(canInterfaceRows(canInterfaces()));
}

// The planned nodes are listened for; without any, all that are heard are told.
void CanopenViews::test(const KindData &plan)
{
    const CanopenSettings settings = plan.as<CanopenPlan>()->settings;
    if (auto link = m_bus.makeLink(settings))
        startTest<CanopenLinkCheck, CanLink>(*std::move(link), settings.rate,
                                             plannedAddresses<CanopenAddress>());
    else
        connection().setProblem(troubleOf(link.error()));
}

ShownStatus CanopenViews::status() const
{
    return CanopenStatus::of(*session());
}

std::any CanopenViews::takeRows()
{
    return m_made ? std::any(m_made->traffic->takeRows()) : std::any();
}

void CanopenViews::showRows(const std::any &rows)
{
    if (rows.has_value())
        made().traffic->goOn(*std::any_cast<const std::shared_ptr<const TrafficModel> &>(rows));
}

// Its page says how that went.
void CanopenViews::connectFound(const KindData &plan, const std::vector<KindData> &)
{
    showSettings();
    connection().connectBy(plan);
}

} // namespace codewheel
