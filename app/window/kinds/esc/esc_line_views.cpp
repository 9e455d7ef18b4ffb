// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/esc/esc_line_views.h"

#include "app/window/buses/operate_question.h"
#include "app/window/kinds/esc/esc_line_actions.h"
#include "app/window/kinds/esc/esc_line_at_work.h"
#include "app/window/kinds/esc/esc_line_keeper.h"
#include "app/window/kinds/esc/esc_line_rate.h"
#include "app/window/kinds/esc/esc_line_status.h"
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

EscLineViews::EscLineViews(EscLineAtWork &line, const WindowParts &windowParts, QObject *parent)
    : AskedBusViews(line, windowParts.actions.ofKind<EscLineActions>(), windowParts,
                    {.name = QStringLiteral("line"),
                     .connecting = "serial-line.md#connecting",
                     .operateWarning = lineOperateWarning,
                     .whyNotDisconnected = tr("The line is not connected."),
                     .mayAgree = RefusalId::portOfOther,
                     .agreement = tr("Use this adapter")},
                    parent)
    , m_line(line)
    , m_actions(windowParts.actions.ofKind<EscLineActions>())
    , m_keeper(new EscLineKeeper(line, this))
    , m_terminal(own(new EscLineTerminal(&windowParts.pages)))
    , m_panel(own(new EscLinePanel(&windowParts.pages)))
    , m_form(new EscLineSettingsForm(&connection()))
    , m_search(own(new EscLineSearch(&windowParts.pages)))
    , m_training(own(new EscLineTrainingPanel(line.id(), &windowParts.pages)))
{
    connection().addForm(m_form);
    connection().addForm(
        new PlainLinkForm(tr("Training line"),
                          tr("Three simulated encoders, at factory settings, in this program. "
                             "Nothing leaves this computer."),
                          {}, &connection(), [](const KindData &plan) {
                              const auto *planned = plan.as<EscLinePlan>();
                              return planned != nullptr && planned->settings.port.isEmpty();
                          }));
    m_search->setObjectName(QStringLiteral("lineSearch"));
    m_search->setDevices(devicesOnLines(line.catalog()));
    setHelpTopic(*m_search, "serial-line.md#searching-for-encoders");
    setHelpTopic(*m_training, "training.md#the-serial-line");
    connect(&notice(), &InlineMessage::actionTriggered, this, &EscLineViews::agree);
    m_terminal->setHistory(parts().settings.typedRequests());
    connect(m_terminal, &EscLineTerminal::historyChanged, this,
            [this] { parts().settings.setTypedRequests(m_terminal->history()); });
    connect(m_terminal, &EscLineTerminal::goToWanted, this, &EscLineViews::goToWanted);
    connect(m_form, &EscLineSettingsForm::fractionBitsWanted, this, &EscLineViews::determineFractionBits);
    connect(m_form, &EscLineSettingsForm::baudRateWanted, m_keeper, &EscLineKeeper::keepBaudRate);
    connect(m_search, &EscLineSearch::takeOverWanted, this, &EscLineViews::takeOver);
    connect(m_training, &EscLineTrainingPanel::acted, this,
            [this](Place place, const TrainingAct &what) { tellTraining(place, what); });
    connect(m_training, &EscLineTrainingPanel::afreshWanted, this, &EscLineViews::startAfresh);
    onAction(m_actions.terminal, [this] { showTerminal(); });
    onAction(m_actions.figures, [this] { open(); });
    connect(m_actions.swapWarningBytes, &QAction::triggered, this, &EscLineViews::swapWarningBytes);
    begin(*m_keeper, *m_search);
}

EscLineSession *EscLineViews::session() const
{
    return static_cast<EscLineSession *>(AskedBusViews::session());
}

std::vector<std::pair<const Panel *, QWidget *>> EscLineViews::pages() const
{
    return {{&panel::training, m_training}, {&terminalPanel, m_terminal}, {&linePanel, m_panel}};
}

// For a planned encoder, the project has the byte order of its warnings.
void EscLineViews::showChosen()
{
    if (!isCurrent())
        return;
    const EncoderSession *encoder = session() && chosen() ? session()->encoder(*chosen()) : nullptr;
    const ProjectDevice *planned = chosen() ? findDevice(m_line.project().project(), *chosen()) : nullptr;
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
    m_training->setDevice(place.value_or(Place{m_line.id(), {}}));
    choose(place);
}

void EscLineViews::setRecordingChosen(bool isChosen)
{
    m_terminal->setRecordingChosen(isChosen);
}

void EscLineViews::showFrame()
{
    m_training->refresh();
    AskedBusViews::showFrame();
}

// Nothing on a line can be switched off or confirmed.
FaultBanner::Offer EscLineViews::offer(const Fault &, FaultAction) const
{
    return {tr("Start again"), tr("Asks for positions again"), {}};
}

void EscLineViews::act(const Fault &, FaultAction)
{
    if (session())
        session()->setRunning(true);
}

void EscLineViews::useSettings(const ProgramSettings &settings)
{
    m_terminal->setMostRows(settings.traceRows);
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

void EscLineViews::setBus(AskedBus *)
{
    EscLineSession *line = session();
    m_takesOther = false;
    if (line != nullptr) {
        connect(line, &EscLineSession::otherAdapterFound, this, &EscLineViews::askForOtherAdapter);
        connect(line, &EscLineSession::fractionBitsDetermined, this,
                [this](Place, const Result<int> &bits) { takeFractionBits(bits); });
        connect(line, &EscLineSession::stateChanged, this, &EscLineViews::showState);
        connect(line, &EscLineSession::nodesChanged, this, &EscLineViews::explainTerminal);
        connect(line, &EscLineSession::moved, m_keeper, &EscLineKeeper::moveEncoder);
        connect(line, &EscLineSession::moved, this, &EscLineViews::explainTerminal);
        connect(line, &EscLineSession::explainOptionsChanged, this, &EscLineViews::explainTerminal);
        connect(line, &EscLineSession::explainOptionsChanged, this, &EscLineViews::showChosen);
    }
    explainTerminal();
    m_terminal->setLine(line);
    m_panel->setLine(line);
    m_search->setLine(line);
    m_training->setLine(line != nullptr ? m_line.training() : nullptr);
}

void EscLineViews::showEncoders()
{
    tellActions();
    m_form->setCanDetermine(session() && !session()->places().empty());
}

TrainingArea *EscLineViews::training() const
{
    return m_training;
}

ShownStatus EscLineViews::status() const
{
    return EscLineStatus::of(*session());
}

std::any EscLineViews::takeRows()
{
    return m_terminal->takeRows();
}

void EscLineViews::showRows(const std::any &rows)
{
    m_terminal->goOn(std::any_cast<const EscLineTerminal::Collected &>(rows));
}

void EscLineViews::showSettings()
{
    m_isFound = false;
    AskedBusViews::showSettings();
}

void EscLineViews::showFound()
{
    m_search->showFoundBefore(std::exchange(m_foundThere, {}));
    showSearch();
}

KindData EscLineViews::wanted(const KindData &plan) const
{
    const EscLineSettings &wish = plan.as<EscLinePlan>()->settings;
    EscLinePlan wanted = m_keeper->line();
    if (m_form->isPicked() || wanted.settings.port != wish.port)
        wanted.adapter = {}; // whichever is there
    wanted.settings = wish;
    return KindData(std::move(wanted));
}

// Its encoders are those of the project.
void EscLineViews::test(const KindData &plan)
{
    const EscLinePlan &line = *plan.as<EscLinePlan>();
    startTest<EscLineCheck>(m_line.makeLink(line), line.settings, plannedAddresses<EscLineAddress>());
}

void EscLineViews::keepLink(const KindData &plan)
{
    AskedBusViews::keepLink(plan);
    m_form->setPort(m_keeper->line().settings.port);
}

void EscLineViews::showOpened()
{
    connection().setProblem({});
    m_form->tellBaudRate({});
    keepLink(m_line.openedWith());
    if (!isCurrent())
        return;
    if (std::exchange(m_isFound, false)) // its encoders are taken over there
        showFound();
    else
        open();
}

void EscLineViews::askForOtherAdapter(const Refusal &which)
{
    notice().showMessage(Role::attention, refusalText(which), tr("&Use this adapter"));
}

void EscLineViews::agree()
{
    notice().withdraw();
    if (!session())
        return;
    session()->takeOtherAdapter();
    m_takesOther = true;
}

void EscLineViews::showState()
{
    if (!session()->latest().connected)
        return;
    notice().withdraw();
    if (std::exchange(m_takesOther, false))
        keepLink(m_keeper->plan());
}

void EscLineViews::determineFractionBits()
{
    if (!session() || session()->places().empty())
        return;
    const Place asked = chosen() && session()->encoder(*chosen()) ? *chosen() : firstThatAnswers(*session());
    if (const auto started = session()->determineFractionBits(asked); !started)
        connection().setProblem(refusalText(started.error()));
}

void EscLineViews::takeFractionBits(const Result<int> &bits)
{
    connection().setProblem(bits ? QString() : refusalText(bits.error()));
    if (!bits)
        return;
    m_form->setFractionBits(*bits);
    session()->setFractionBits(*bits);
    m_keeper->keepFractionBits(*bits);
}

// The training line starts anew with each connection, with its encoders at factory settings.
void EscLineViews::jobEnded(const EncoderSession &encoder, const Outcome &outcome)
{
    const auto rate = valueOf(outcome.written, Parameter::baudRate);
    if (rate && m_line.training() == nullptr)
        tellBaudRate(encoder.place(), static_cast<int>(*rate));
}

void EscLineViews::tellBaudRate(Place encoder, int rate)
{
    const EscLineRate told = lineRateAfter(*session(), encoder, rate);
    m_form->tellBaudRate(told.sentence, told.baudRate);
}

// With the settings of the line, so that the terminal reads a factor as the driver does.
void EscLineViews::explainTerminal()
{
    if (session())
        m_terminal->setExplainOptions(session()->explainOptions());
}

// Its page says how that went.
void EscLineViews::connectFound(const KindData &plan, const std::vector<KindData> &devices)
{
    showSettings();
    m_isFound = true;
    m_foundThere = foundEncoders(devices);
    connection().connectBy(plan);
}

// Encoders at another baud rate would only fall silent: they have to be connected at theirs.
void EscLineViews::takeOver(const std::vector<FoundEncoder> &found, const QString &deviceKey)
{
    EscLineSession *line = session();
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

void EscLineViews::swapWarningBytes(bool on)
{
    if (!isCurrent() || !chosen())
        return;
    if (session())
        session()->setSwapsWarningBytes(*chosen(), on);
    m_keeper->keepByteOrder(*chosen(), on);
}

} // namespace codewheel
