// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/esc/esc_line_views.h"

#include "app/window/buses/leaving.h"
#include "app/window/buses/operate_question.h"
#include "app/window/connect/link_test.h"
#include "app/window/connect/port_rows.h"
#include "app/window/connect/trouble_of.h"
#include "app/window/kinds/esc/esc_line_actions.h"
#include "app/window/kinds/esc/esc_line_at_work.h"
#include "app/window/kinds/esc/esc_line_keeper.h"
#include "app/window/kinds/esc/esc_line_rate.h"
#include "app/window/look/afresh.h"
#include "app/window/window_actions.h"
#include "app/window/window_settings.h"
#include "catalog/catalog.h"
#include "kinds/esc/line/esc_line_check.h"
#include "kinds/esc/line/esc_line_session.h"
#include "kinds/esc/plan/esc_line_plan.h"
#include "kinds/esc/protocol/esc_forms.h"
#include "kinds/esc/protocol/esc_profile.h"
#include "kinds/esc/protocol/esc_refusals.h"
#include "vocabulary/refusal_text.h"
#include "widgets/comparison/comparison_page.h"
#include "widgets/connect/connect_page.h"
#include "widgets/connect/plain_link_form.h"
#include "widgets/help/help_topic.h"
#include "widgets/kinds/esc/line/esc_line_panel.h"
#include "widgets/kinds/esc/line/esc_line_search.h"
#include "widgets/kinds/esc/line/esc_line_settings_form.h"
#include "widgets/kinds/esc/line/esc_line_terminal.h"
#include "widgets/kinds/esc/line/request_field.h"
#include "widgets/kinds/esc/training/esc_line_training_panel.h"
#include "widgets/look/inline_message.h"
#include "widgets/project/project_document.h"

#include <QAction>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace codewheel {
namespace {

struct WorkOnLine
{
    EscLineTerminal::Collected collected;
    int link = 0; // that is being entered
};

std::vector<EscLineSearch::Device> devicesOnLines(const Catalog &catalog)
{
    std::vector<EscLineSearch::Device> devices;
    for (const DeviceDescription &device : catalog.devices())
        if (device.profile == profile::esc)
            devices.push_back({device.key, device.fullName()});
    return devices;
}

// The first one if none answers.
Place firstThatAnswers(const EscLineSession &line)
{
    const std::vector<Place> numbers = line.places();
    const auto answering = std::ranges::find_if(numbers, [&line](Place number) {
        return line.encoder(number)->latest().state == EncoderState::operation;
    });
    return answering == numbers.end() ? numbers.front() : *answering;
}

std::vector<FoundEncoder> foundEncoders(const std::vector<KindData> &devices)
{
    std::vector<FoundEncoder> found;
    for (const KindData &device : devices)
        if (const auto *encoder = device.as<FoundEncoder>())
            found.push_back(*encoder);
    return found;
}

OperateWarning lineOperateWarning(const EncoderBus &line)
{
    const QString name = nameAmongOthers(line.id());
    return {
        .question =
            name.isEmpty()
                ? OperateQuestion::tr("This serial line is real. Shall the program write to it?")
                : OperateQuestion::tr("%1 is a real serial line. Shall the program write to it?").arg(name),
        .explanation = OperateQuestion::tr(
            "In Operate, what you write goes to the encoders on the line. A preset or a parameter changes "
            "the position that the controller sees. Switching over sends nothing."),
        .helpTopic = "serial-line.md#watch-and-operate"};
}

} // namespace

KeyGroup keysOfLines()
{
    return {EscLineViews::tr("Request field of the terminal"), RequestField::keys()};
}

EscLineViews::EscLineViews(EscLineAtWork &line, const WindowParts &parts, QObject *parent)
    : BusViews(parent)
    , m_line(line)
    , m_parts(parts)
    , m_actions(parts.actions.ofKind<EscLineActions>())
    , m_status(parts.status)
    , m_notice(own(new InlineMessage(&parts.pages)))
    , m_keeper(new EscLineKeeper(line, line.project(), this))
    , m_operateQuestion(new OperateQuestion(line, lineOperateWarning, *parts.pages.window(), this))
    , m_terminal(own(new EscLineTerminal(&parts.pages)))
    , m_panel(own(new EscLinePanel(&parts.pages)))
    , m_connection(own(new ConnectPage(&parts.pages)))
    , m_form(new EscLineSettingsForm(m_connection))
    , m_search(own(new EscLineSearch(&parts.pages)))
    , m_training(own(new EscLineTrainingPanel(line.id(), &parts.pages)))
    , m_comparison(
          own(new ComparisonPage(line.project(), line.catalog(), line.id(), line.kind(), &parts.pages)))
{
    m_notice->setObjectName(QStringLiteral("lineNotice"));
    parts.notices.insertWidget(0, m_notice);
    m_connection->setObjectName(QStringLiteral("lineSettings"));
    m_connection->addForm(m_form);
    m_connection->addForm(
        new PlainLinkForm(tr("Training line"),
                          tr("Three simulated encoders, at factory settings, in this program. "
                             "Nothing leaves this computer."),
                          {}, m_connection, [](const KindData &plan) {
                              const auto *planned = plan.as<EscLinePlan>();
                              return planned != nullptr && planned->settings.port.isEmpty();
                          }));
    m_search->setObjectName(QStringLiteral("lineSearch"));
    m_search->setDevices(devicesOnLines(line.catalog()));
    parts.pages.addWidget(m_connection);
    parts.pages.addWidget(m_search);
    parts.pages.addWidget(m_comparison);
    setHelpTopic(*m_connection, "serial-line.md#connecting");
    setHelpTopic(*m_search, "serial-line.md#searching-for-encoders");
    setHelpTopic(*m_comparison, "project.md#comparing");
    setHelpTopic(*m_training, "training.md#the-serial-line");
    m_terminal->setHistory(parts.settings.typedRequests());
    connect(m_terminal, &EscLineTerminal::historyChanged, this,
            [this] { m_parts.settings.setTypedRequests(m_terminal->history()); });
    connect(m_terminal, &EscLineTerminal::goToWanted, this, &EscLineViews::goToWanted);
    connect(m_form, &EscLineSettingsForm::fractionBitsWanted, this, &EscLineViews::determineFractionBits);
    connect(m_form, &EscLineSettingsForm::baudRateWanted, m_keeper, &EscLineKeeper::keepBaudRate);
    connect(m_connection, &ConnectPage::portsWanted, this, &EscLineViews::listPorts);
    connect(m_connection, &ConnectPage::connectWanted, this, &EscLineViews::connectAs);
    connect(m_connection, &ConnectPage::keepWanted, this,
            [this](const KindData &plan) { keepPort(wanted(plan.as<EscLinePlan>()->settings)); });
    connect(m_connection, &ConnectPage::testWanted, this, &EscLineViews::test);
    connect(m_connection, &ConnectPage::testCancelled, &m_test, &BackgroundSteps::cancel);
    connect(&m_test, &BackgroundSteps::ended, this, [this] { m_connection->setTesting(false); });
    connect(m_connection, &ConnectPage::agreed, this, &EscLineViews::connectOtherAdapter);
    connect(m_notice, &InlineMessage::actionTriggered, this, &EscLineViews::useOtherAdapter);
    connect(m_search, &EscLineSearch::takeOverWanted, this, &EscLineViews::takeOver);
    connect(&line.project(), &ProjectDocument::replaced, this, &EscLineViews::showPlanned);
    connect(&line.project(), &ProjectDocument::changed, this, &EscLineViews::showChosen);
    connect(&line.project(), &ProjectDocument::changed, this, &EscLineViews::showName);
    connect(&line.project(), &ProjectDocument::changed, this, &EscLineViews::showNewPlan);
    connect(m_training, &EscLineTrainingPanel::acted, this,
            [this](Place place, const TrainingAct &what) { tellTraining(place, what); });
    connect(m_training, &EscLineTrainingPanel::afreshWanted, this, &EscLineViews::startAfresh);
    connect(&line, &EscLineAtWork::opened, this, &EscLineViews::showOpened);
    connect(&line, &EscLineAtWork::openRefused, this, &EscLineViews::showRefused);
    connect(&line, &EscLineAtWork::openingChanged, this, [this] {
        m_connection->setConnecting(m_line.isOpening());
        showActions();
    });
    connect(&line, &EscLineAtWork::aboutToChange, this, [this] { setLine(nullptr); });
    connect(&line, &EscLineAtWork::changed, this, [this] { setLine(m_line.session()); });
    onAction(m_actions.settings, [this] { showSettings(); });
    onAction(m_actions.search, [this] { showSearch(); });
    onAction(m_actions.terminal, [this] { showTerminal(); });
    onAction(m_actions.figures, [this] { open(); });
    onAction(m_actions.training, [this] { connectTraining(); });
    onAction(m_actions.afresh, [this] { startAfresh(); });
    onAction(m_actions.disconnectLine, [this] { disconnectLine(); });
    onAction(m_actions.remove, [this] { removeChosen(); });
    connect(m_actions.swapWarningBytes, &QAction::triggered, this, &EscLineViews::swapWarningBytes);
    setLine(line.session());
    showPlanned();
}

std::vector<std::pair<const Panel *, QWidget *>> EscLineViews::pages() const
{
    return {{&panel::training, m_training}, {&terminalPanel, m_terminal}, {&linePanel, m_panel}};
}

QWidget *EscLineViews::comparison() const
{
    return m_comparison;
}

QMenu *EscLineViews::menu() const
{
    return m_actions.menu;
}

void EscLineViews::showCurrent()
{
    showStatus();
    tellActions();
}

void EscLineViews::showStatus()
{
    m_status.show(isCurrent() ? m_session.get() : nullptr);
}

void EscLineViews::tellActions()
{
    if (isCurrent())
        m_actions.tellBus(nameAmongOthers(m_line.id())); // their menu already says that it is the line
    const bool isConnected = m_line.session() != nullptr || m_line.isOpening();
    m_actions.disconnectLine->setEnabled(isMeant() && isConnected);
    if (!isConnected)
        m_actions.tellWhyNotDisconnected(tr("The line is not connected."));
    m_actions.training->setEnabled(isMeant() && m_line.training() == nullptr);
    showAfresh(*m_training, m_actions.afresh, Afresh::whyNot(m_session));
    showChosen();
}

// For a planned encoder, the project has the byte order of its warnings.
void EscLineViews::showChosen()
{
    if (!isCurrent())
        return;
    const EncoderSession *encoder = m_session && m_chosen ? m_session->encoder(*m_chosen) : nullptr;
    const ProjectDevice *planned = m_chosen ? findDevice(m_line.project().project(), *m_chosen) : nullptr;
    const KindData given = valueOptionsOf(encoder);
    const auto *options = given.as<EscValueOptions>();
    m_actions.showChosen(
        {.isOnLine = encoder != nullptr || planned != nullptr,
         .isConnected = encoder != nullptr,
         .isSwapped = options != nullptr
                          ? options->swapsWarningBytes
                          : planned != nullptr && planned->its<EscEncoderSettings>().swapsWarningBytes});
}

void EscLineViews::setChosen(std::optional<Place> place)
{
    m_chosen = place;
    m_training->setDevice(place.value_or(Place{m_line.id(), {}}));
    showChosen();
}

void EscLineViews::setRecordingChosen(bool isChosen)
{
    m_terminal->setRecordingChosen(isChosen);
}

void EscLineViews::showFrame()
{
    m_training->refresh();
    showAfresh(*m_training, m_actions.afresh, Afresh::whyNot(m_session));
    showStatus();
}

void EscLineViews::askToOperate(const std::function<void()> &then)
{
    m_operateQuestion->ask(then);
}

// Nothing on a line can be switched off or confirmed.
FaultBanner::Offer EscLineViews::offer(const Fault &, FaultAction) const
{
    return {tr("Start again"), tr("Asks for positions again"), {}};
}

void EscLineViews::act(const Fault &, FaultAction)
{
    if (m_session)
        m_session->setRunning(true);
}

QAction *EscLineViews::actionFor(DataCheck::Action action) const
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

void EscLineViews::useSettings(const ProgramSettings &settings)
{
    m_terminal->setMostRows(settings.traceRows);
}

std::any EscLineViews::takeWork()
{
    return WorkOnLine{m_terminal->takeRows(), m_connection->chosenLink()};
}

void EscLineViews::goOn(const std::any &work)
{
    const auto *before = std::any_cast<WorkOnLine>(&work);
    if (before == nullptr)
        return;
    m_terminal->goOn(before->collected);
    m_connection->chooseLink(before->link);
}

void EscLineViews::open()
{
    Q_EMIT panelRequested(linePanel);
    m_panel->setFocus();
}

bool EscLineViews::open(Place)
{
    showTerminal();
    return true;
}

void EscLineViews::showTerminal()
{
    Q_EMIT panelRequested(terminalPanel);
    m_terminal->setFocus();
}

void EscLineViews::setLine(EscLineSession *line)
{
    if (m_session) {
        m_session->disconnect(this);
        m_session->disconnect(m_keeper);
    }
    m_session = line;
    m_takesOther = false;
    m_notice->withdraw();
    if (line != nullptr) {
        connect(line, &EscLineSession::otherAdapterFound, this, &EscLineViews::askForOtherAdapter);
        connect(line, &EscLineSession::fractionBitsDetermined, this,
                [this](Place, const Result<int> &bits) { takeFractionBits(bits); });
        connect(line, &EscLineSession::stateChanged, this, &EscLineViews::showState);
        connect(line, &EscLineSession::nodesChanged, this, &EscLineViews::showActions);
        connect(line, &EscLineSession::nodesChanged, this, &EscLineViews::explainTerminal);
        connect(line, &EscLineSession::nodesChanged, this, &EscLineViews::watchBaudRates);
        connect(line, &EscLineSession::moved, m_keeper, &EscLineKeeper::moveEncoder);
        connect(line, &EscLineSession::moved, this, &EscLineViews::explainTerminal);
        connect(line, &EscLineSession::explainOptionsChanged, this, &EscLineViews::explainTerminal);
        connect(line, &EscLineSession::explainOptionsChanged, this, &EscLineViews::showChosen);
    }
    explainTerminal();
    watchBaudRates();
    m_terminal->setLine(line);
    m_panel->setLine(line);
    m_search->setLine(line);
    m_comparison->setBus(line);
    m_training->setLine(line != nullptr ? m_line.training() : nullptr);
    using enum ConnectPage::Connected;
    m_connection->setConnected(line == nullptr ? no : m_line.training() != nullptr ? simulated : real);
    showStatus();
    showActions();
}

void EscLineViews::showActions()
{
    if (isCurrent())
        tellActions();
    m_form->setCanDetermine(m_session && !m_session->places().empty());
}

void EscLineViews::showPlanned()
{
    if (const EscLinePlan *planned = linePlan(m_line.project().project(), m_line.id()))
        m_connection->showPlan(KindData(*planned));
    showName();
}

// What is being entered for a line that is planned already stays.
void EscLineViews::showNewPlan()
{
    const bool isPlanned = linePlan(m_line.project().project(), m_line.id()) != nullptr;
    if (isPlanned && !std::exchange(m_isPlanned, isPlanned))
        showPlanned();
    m_isPlanned = isPlanned;
}

void EscLineViews::showName()
{
    const PlannedBus *planned = findBus(m_line.project().project(), m_line.id());
    const QString name = planned != nullptr ? planned->name : m_line.nameOfNew();
    m_connection->setAbout(name);
    m_search->setAbout(name);
}

void EscLineViews::showSettings()
{
    m_isFound = false;
    listPorts();
    m_parts.pages.setCurrentWidget(m_connection);
    m_connection->setFocus();
}

void EscLineViews::showSearch()
{
    m_parts.pages.setCurrentWidget(m_search);
    m_search->setFocus();
}

void EscLineViews::showFound()
{
    m_search->showFoundBefore(std::exchange(m_foundThere, {}));
    showSearch();
}

void EscLineViews::listPorts()
{
    const PortRows ports = portRows(m_line.ports());
    m_connection->setPorts(ports.rows, ports.trouble);
}

EscLinePlan EscLineViews::wanted(const EscLineSettings &wish) const
{
    EscLinePlan wanted = m_keeper->line();
    if (m_form->isPicked() || wanted.settings.port != wish.port)
        wanted.adapter = {}; // whichever is there
    wanted.settings = wish;
    return wanted;
}

void EscLineViews::connectAs(const KindData &plan)
{
    const auto *line = plan.as<EscLinePlan>();
    if (line == nullptr) {
        connectTraining();
        return;
    }
    m_parts.leaving.ask(Leaving::Why::disconnect, {m_line.session()}, [this, wish = wanted(line->settings)] {
        m_opened = wish;
        m_line.openPort(m_opened);
    });
}

// Its encoders are those of the project.
void EscLineViews::test(const KindData &plan)
{
    const EscLinePlan line = wanted(plan.as<EscLinePlan>()->settings);
    std::vector<EscLineAddress> addresses;
    for (const ProjectDevice &encoder : devicesOn(m_line.project().project(), m_line.id()))
        addresses.push_back(EscLineAddress::of(encoder.place().node));
    m_connection->setProblem({});
    m_connection->setTesting(true);
    m_test.start(std::make_unique<LinkTest<EscLineCheck, ByteLink>>(
        m_line.makeLink(line),
        [this](const EscLineFinding &finding) {
            m_connection->addStep(finding.outcome, EscLineCheck::stepText(finding.step, finding.address),
                                  finding.sentence);
            if (finding.why)
                tellCommand(*m_connection, *finding.why);
        },
        line.settings, std::move(addresses)));
}

void EscLineViews::connectOtherAdapter(const KindData &plan)
{
    m_parts.leaving.ask(Leaving::Why::disconnect, {m_line.session()},
                        [this, wish = plan.as<EscLinePlan>()->settings] {
                            m_opened = m_keeper->line();
                            m_opened.settings = wish;
                            m_line.openOtherAdapter(m_opened);
                        });
}

void EscLineViews::showOpened()
{
    m_connection->setProblem({});
    m_form->tellBaudRate({});
    keepPort(m_opened);
    if (!isCurrent())
        return;
    if (std::exchange(m_isFound, false)) // its encoders are taken over there
        showFound();
    else
        open();
}

void EscLineViews::showRefused(const Refusal &why)
{
    if (why.id == RefusalId::portOfOther)
        m_connection->ask(refusalText(why), tr("Use this adapter"));
    else
        m_connection->setProblem(troubleOf(why));
}

void EscLineViews::keepPort(const EscLinePlan &line)
{
    m_keeper->keepPort(line);
    m_form->setPort(m_keeper->line().settings.port);
}

void EscLineViews::askForOtherAdapter(const Refusal &which)
{
    m_notice->showMessage(Role::attention, refusalText(which), tr("&Use this adapter"));
}

void EscLineViews::useOtherAdapter()
{
    m_notice->withdraw();
    if (!m_session)
        return;
    m_session->takeOtherAdapter();
    m_takesOther = true;
}

void EscLineViews::showState()
{
    if (!m_session->latest().connected)
        return;
    m_notice->withdraw();
    if (std::exchange(m_takesOther, false))
        keepPort(m_keeper->line());
}

void EscLineViews::determineFractionBits()
{
    if (!m_session || m_session->places().empty())
        return;
    const Place asked = m_chosen && m_session->encoder(*m_chosen) ? *m_chosen : firstThatAnswers(*m_session);
    if (const auto started = m_session->determineFractionBits(asked); !started)
        m_connection->setProblem(refusalText(started.error()));
}

void EscLineViews::takeFractionBits(const Result<int> &bits)
{
    m_connection->setProblem(bits ? QString() : refusalText(bits.error()));
    if (!bits)
        return;
    m_form->setFractionBits(*bits);
    m_session->setFractionBits(*bits);
    m_keeper->keepFractionBits(*bits);
}

// The training line starts anew with each connection, with its encoders at factory settings.
void EscLineViews::watchBaudRates()
{
    if (!m_session || m_line.training() != nullptr)
        return;
    for (const Place place : m_session->places())
        if (const EncoderSession *encoder = m_session->encoder(place)) {
            disconnect(encoder, &EncoderSession::finished, this, nullptr);
            connect(encoder, &EncoderSession::finished, this, [this, encoder](const Outcome &outcome) {
                if (const auto rate = valueOf(outcome.written, Parameter::baudRate))
                    tellBaudRate(encoder->place(), static_cast<int>(*rate));
            });
        }
}

void EscLineViews::tellBaudRate(Place encoder, int rate)
{
    const EscLineRate told = lineRateAfter(*m_session, encoder, rate);
    m_form->tellBaudRate(told.sentence, told.baudRate);
}

// With the settings of the line, so that the terminal reads a factor as the driver does.
void EscLineViews::explainTerminal()
{
    if (m_session)
        m_terminal->setExplainOptions(m_session->explainOptions());
}

// Its page says how that went.
void EscLineViews::connectFound(const KindData &plan, const std::vector<KindData> &devices)
{
    showSettings();
    m_isFound = true;
    m_foundThere = foundEncoders(devices);
    m_connection->connectBy(plan);
}

void EscLineViews::connectTraining()
{
    m_parts.leaving.ask(Leaving::Why::disconnect, {m_line.session()}, [this] { m_line.openTraining(); });
}

// It may have become impossible since the last frame.
void EscLineViews::startAfresh()
{
    if (!Afresh::whyNot(m_session).isEmpty())
        return;
    m_line.startAfresh();
    tellTraining(Place{m_line.id()}, startedAfresh());
}

void EscLineViews::disconnectLine()
{
    m_parts.leaving.ask(Leaving::Why::disconnect, {m_line.session()}, [this] { m_line.close(); });
}

// Encoders at another baud rate would only fall silent: they have to be connected at theirs.
void EscLineViews::takeOver(const std::vector<FoundEncoder> &found, const QString &deviceKey)
{
    EscLineSession *line = m_line.session();
    if (line == nullptr)
        return;
    std::vector<Place> taken;
    std::vector<FoundEncoder> left;
    std::optional<Refusal> refused;
    for (const FoundEncoder &encoder : found) {
        if (encoder.baudRate != line->settings().baudRate) {
            left.push_back(encoder);
            continue;
        }
        const Place number = line->placeOf(encoder.address.node());
        const auto added = line->add(encoder.address, deviceKey); // an existing one stays
        if (!added && added.error().id == EscRefusalId::lineAddressNotAlone)
            refused = added.error();
        if (line->encoder(number) != nullptr)
            taken.push_back(number);
    }
    m_keeper->keepEncoders(taken);
    m_search->showLeft(left);
    if (refused)
        m_search->showRefused(*refused);
}

void EscLineViews::removeChosen()
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

void EscLineViews::swapWarningBytes(bool on)
{
    if (!isCurrent() || !m_chosen)
        return;
    if (m_session)
        m_session->setSwapsWarningBytes(*m_chosen, on);
    m_keeper->keepByteOrder(*m_chosen, on);
}

} // namespace codewheel
