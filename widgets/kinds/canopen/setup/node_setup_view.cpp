// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/setup/node_setup_view.h"

#include "can/can_state.h"
#include "kinds/canopen/bus/canopen_bus_messages.h"
#include "kinds/canopen/bus/canopen_session.h"
#include "kinds/canopen/protocol/canopen_reach.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "widgets/eeprom/eeprom_gate.h"
#include "widgets/kinds/canopen/setup/node_number_field.h"
#include "widgets/kinds/canopen/setup/node_setup_texts.h"
#include "widgets/kinds/canopen/setup/setup_steps.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/wrapped_label.h"

#include <QApplication>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

#include <utility>

namespace codewheel {

using canopen::NodeSetupWish;

NodeSetupView::NodeSetupView(QWidget *parent)
    : QWidget(parent)
    , m_device(wrappedLabel(this, "nodeSetupDevice"))
    , m_read(describe(new QPushButton(lineIcon(Icon::refresh), tr("&Read"), this), "nodeSetupRead", {}))
    , m_find(describe(new QPushButton(lineIcon(Icon::search), tr("Find &one without a number"), this),
                      "nodeSetupFind", {}))
    , m_fields(new QWidget(this))
    , m_way(describe(new QComboBox(m_fields), "nodeSetupWay", tr("Way"),
                     tr("How number and rate reach the device")))
    , m_number(describe(new NodeNumberField(m_fields), "nodeSetupNumber", tr("New number"),
                        tr("The node number that the device gets: 1 to 127")))
    , m_rate(describe(new QComboBox(m_fields), "nodeSetupRate", tr("New rate"),
                      tr("The rate that the device gets. All devices of a bus have the same")))
    , m_consequences(wrappedLabel(this, "nodeSetupConsequences"))
    , m_gate(new EepromGate(this))
    , m_write(describe(new QPushButton(lineIcon(Icon::write), tr("&Write…"), this), "nodeSetupWrite", {}))
    , m_cancel(describe(new QPushButton(lineIcon(Icon::cancel), tr("Cance&l"), this), "nodeSetupCancel",
                        tr("What was not sent yet is not sent")))
    , m_checkNow(
          describe(new QPushButton(lineIcon(Icon::search), tr("Check &it"), this), "nodeSetupCheck", {}))
    , m_message(named(new InlineMessage(this), "nodeSetupMessage"))
    , m_steps(new SetupSteps(this))
{
    for (QPushButton *button : {m_read, m_find, m_write, m_cancel, m_checkNow})
        button->setAutoDefault(false);
    layOutColumn(this,
                 {m_device, layOutRow({m_read, m_find, Stretch{1}}, {.spacing = grid::unit}), m_fields,
                  m_consequences, m_gate, makeButtons(), m_message, m_steps, Stretch{1}},
                 {.spacing = grid::margin, .margins = QMargins()});
    m_fields->setLayout(makeFields());
    setFocusProxy(m_read);
    connect(m_read, &QPushButton::clicked, this, &NodeSetupView::read);
    connect(m_find, &QPushButton::clicked, this, &NodeSetupView::search);
    connect(m_write, &QPushButton::clicked, this, &NodeSetupView::ask);
    connect(m_cancel, &QPushButton::clicked, this, [this] { m_run.cancel(); });
    connect(m_checkNow, &QPushButton::clicked, this, &NodeSetupView::check);
    connect(m_message, &InlineMessage::actionTriggered, this, &NodeSetupView::send);
    connect(m_gate, &EepromGate::changed, this, &NodeSetupView::showWhatIsPossible);
    connect(&m_run, &NodeTaskRun::ended, this, &NodeSetupView::takeEnd);
    connect(&m_run, &NodeTaskRun::changed, this, [this] {
        showSteps();
        showWhatIsPossible();
    });
    reset();
}

NodeSetupView::~NodeSetupView()
{
    m_run.disconnect(this);
    m_run.setBus(nullptr);
}

QLayout *NodeSetupView::makeFields()
{
    auto *form = makeForm(nullptr, grid::unit);
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    m_rate->addItem(tr("as it is"));
    for (const canopen::LssRate &rate : canopen::lssRates)
        m_rate->addItem(tr("%1 kBit/s").arg(inKilobits(rate.rate)), rate.rate);
    form->addRow(tr("Wa&y"), m_way);
    form->addRow(tr("New n&umber"), m_number);
    form->addRow(tr("New ra&te"), m_rate);
    const auto edited = [this] {
        m_message->withdraw(); // what was asked about is otherwise now
        showConsequences();
    };
    connect(m_way, &QComboBox::currentIndexChanged, this, edited);
    connect(m_number, &QSpinBox::valueChanged, this, edited);
    connect(m_rate, &QComboBox::currentIndexChanged, this, edited);
    return form;
}

QLayout *NodeSetupView::makeButtons()
{
    return layOutRow({m_write, m_checkNow, m_cancel, Stretch{1}}, {.spacing = grid::unit});
}

// What was read there may be another device's by now. What is to be proven still is.
void NodeSetupView::setBus(CanopenSession *bus)
{
    if (bus != nullptr && m_bus == bus)
        return;
    if (m_bus)
        m_bus->disconnect(this);
    m_bus = bus;
    m_run.setBus(bus);
    if (bus != nullptr) {
        connect(bus, &CanopenSession::stateChanged, this, &NodeSetupView::showWhatIsPossible);
        connect(bus, &CanopenSession::nodesChanged, this, &NodeSetupView::showConsequences);
    }
    m_bootUps = {};
    if (m_stage == Stage::read) {
        m_identity.reset();
        m_message->withdraw();
        setStage(Stage::unread);
    } else {
        showWhatIsPossible();
    }
}

void NodeSetupView::setNode(std::optional<int> node)
{
    if (isBusy())
        return;
    reset();
    m_node = node;
    if (!m_replacing)
        m_number->setValue(node.value_or(1));
    showDevice();
    showWhatIsPossible();
}

void NodeSetupView::setReplacing(int number)
{
    m_replacing = number;
    m_number->setValue(number);
    m_number->setEnabled(false);
    showConsequences();
}

void NodeSetupView::reset()
{
    if (isBusy())
        return;
    m_node.reset();
    m_identity.reset();
    m_isFound = false;
    m_isRateStored = false;
    m_setup.reset();
    m_check.reset();
    m_rate->setCurrentIndex(0);
    m_message->withdraw();
    setStage(Stage::unread);
}

QString NodeSetupView::about() const
{
    return m_identity || m_node ? node_setup_text::device(m_node) : QString();
}

void NodeSetupView::setStage(Stage stage)
{
    m_stage = stage;
    showDevice();
    showConsequences();
    showSteps();
    Q_EMIT changed();
}

void NodeSetupView::read()
{
    if (isBusy() || !m_node || !whyNotSent().isEmpty())
        return;
    m_identity.reset();
    m_setup.reset();
    m_check.reset();
    m_isFound = false;
    m_isRateStored = false;
    m_message->withdraw();
    m_reading = std::make_unique<canopen::IdentityReading>(*m_node);
    setStage(Stage::reading);
    m_run.start(*m_reading);
}

void NodeSetupView::takeRead()
{
    if (m_reading->result() == canopen::IdentityReading::Result::read) {
        m_identity = m_reading->identity();
        setStage(Stage::read);
        return;
    }
    setStage(Stage::unread);
    tellProblem(node_setup_text::end(*m_reading));
}

void NodeSetupView::search()
{
    if (isBusy())
        return;
    if (const QString why = whyNotSent(); !why.isEmpty()) {
        tellProblem(why);
        return;
    }
    reset();
    m_search = std::make_unique<canopen::LssSearch>(canopen::LssSelection::By::fastScan);
    setStage(Stage::searching);
    m_run.start(*m_search);
}

void NodeSetupView::takeSearched()
{
    if (!m_search->selection().isSelected() || m_search->isCancelled()) {
        setStage(Stage::unread);
        tellProblem(node_setup_text::end(*m_search));
        return;
    }
    m_identity = m_search->selection().identity();
    m_node = m_search->selection().node();
    setStage(Stage::read);
    if (m_search->mayStayInConfiguration())
        tellProblem(tr("The device may still be in the configuration of LSS: switch its supply off and on, "
                       "then search again."));
}

std::optional<node_setup_text::AtStake> NodeSetupView::atStake() const
{
    if (!isBusy())
        return std::nullopt;
    switch (m_stage) {
    case Stage::searching:
        return node_setup_text::ofSearch();
    case Stage::writing:
        return node_setup_text::ofWriting(m_wanted);
    case Stage::checking:
        return node_setup_text::ofChecking(m_wanted);
    default:
        return std::nullopt; // it only reads
    }
}

bool NodeSetupView::isSettled() const
{
    if (isBusy())
        return false;
    if (!m_setup)
        return !m_search || !m_search->mayStayInConfiguration();
    if (m_setup->trouble())
        return m_setup->isUntouched() && !m_setup->mayStayInConfiguration();
    return m_isFound || m_isRateStored;
}

std::optional<canopen::SdoObject> NodeSetupView::nodeObject() const
{
    const EncoderSession *encoder =
        m_bus && m_node ? m_bus->encoder(CanopenAddress{*m_node}.place()) : nullptr;
    if (encoder == nullptr || !m_identity)
        return std::nullopt;
    const CanopenDevice its = canopenDevice(encoder->device());
    return its.vendor == m_identity->vendor() ? its.nodeNumber : std::nullopt;
}

NodeSetupWish NodeSetupView::wish() const
{
    NodeSetupWish wish{.identity = m_identity.value_or(canopen::NodeIdentity()),
                       .nodeBefore = m_node,
                       .node = m_number->value()};
    wish.way = static_cast<NodeSetupWish::Way>(m_way->currentData().toInt());
    if (const auto object = nodeObject(); object && wish.way == NodeSetupWish::Way::object) {
        wish.nodeObject = *object;
        return wish;
    }
    if (const canopen::LssRate *rate = canopen::lssRate(m_rate->currentData().toInt()))
        wish.rate = *rate;
    return wish;
}

QString NodeSetupView::whyNotSent() const
{
    if (!m_bus || !m_bus->isOpen() || !m_bus->latest().connected)
        return tr("The CAN bus is not connected. Connect it first.");
    if (!m_bus->isOperating())
        return tr("In Watch nothing is sent. Switch to Operate first.");
    return {};
}

QString NodeSetupView::whyNotAsked() const
{
    const NodeSetupWish wanted = wish();
    if (!wanted.changesNode() && !wanted.rate)
        return tr("Choose another number or a rate.");
    const EncoderSession *itself = m_node ? m_bus->encoder(CanopenAddress{*m_node}.place()) : nullptr;
    if (itself != nullptr && itself->runningJob())
        return tr("A job of this encoder runs. Wait for its end, or cancel it.");
    if (wanted.rate && wanted.rate->rate == m_bus->rate())
        return tr("The device has the rate of this bus, or it would not answer. Choose another one.");
    const EncoderSession *there = m_bus->encoder(CanopenAddress{wanted.nodeAfter()}.place());
    if (wanted.changesNode() && there != nullptr && !m_replacing)
        return sentence(tr("This bus has an encoder with the number %1 already, whether it answers or not. "
                           "Choose another number, or remove that encoder from the bus."),
                        {CanopenAddress{wanted.nodeAfter()}.shown()});
    return {};
}

void NodeSetupView::ask()
{
    QString why = whyNotSent();
    if (why.isEmpty())
        why = whyNotAsked();
    if (!why.isEmpty()) {
        tellProblem(why);
        return;
    }
    m_wanted = wish();
    m_message->showMessage(Role::attention,
                           node_setup_text::consequences(m_wanted) + u' ' + tr("Shall it be written?"),
                           tr("&Send"));
    m_message->focusSafe();
}

// What was asked about is what is sent.
void NodeSetupView::send()
{
    if (isBusy() || m_stage != Stage::read)
        return;
    m_message->withdraw();
    if (wish() != m_wanted || !whyNotSent().isEmpty() || !whyNotAsked().isEmpty() || !m_gate->isOpen()) {
        ask();
        return;
    }
    Q_EMIT aboutToWrite();
    m_check.reset();
    m_setup = std::make_unique<canopen::NodeSetup>(m_wanted);
    setStage(Stage::writing);
    m_run.start(*m_setup);
}

void NodeSetupView::takeWritten()
{
    const NodeSetupWish &wanted = m_setup->wish();
    const QString sentence = node_setup_text::end(*m_setup);
    if (m_setup->trouble()) {
        m_identity.reset(); // it is read anew before anything else is written
        setStage(Stage::unread);
        tellProblem(sentence);
        return;
    }
    m_isRateStored = wanted.rate.has_value();
    setStage(Stage::toBeProven);
    tell(Role::attention, sentence);
    if (!wanted.rate) {
        check();
        return;
    }
    const BusId bus = m_bus ? m_bus->id() : BusId();
    Q_EMIT messaged(
        {.place = wanted.nodeBefore ? Place{bus, CanopenAddress{*wanted.nodeBefore}.place()} : Place{bus},
         .id = CanopenBusMessageId::nodeRateStored,
         .arguments = {inKilobits(wanted.rate->rate), std::int64_t{wanted.nodeAfter()}}});
}

void NodeSetupView::check()
{
    if (isBusy() || !m_setup || !whyNotSent().isEmpty())
        return;
    const NodeSetupWish &wanted = m_setup->wish();
    if (m_isRateStored && m_bus->rate() != wanted.rate->rate) {
        tellProblem(sentence(tr("This bus is connected at %1 kBit/s. Connect it at %2 kBit/s first."),
                             {inKilobits(m_bus->rate()), inKilobits(wanted.rate->rate)}));
        return;
    }
    // Where it was not found after the reset, it is looked for again.
    const bool isProof = m_isFound || m_isRateStored;
    m_check = std::make_unique<canopen::NodeCheck>(
        canopen::NodeCheck::Wanted{.node = wanted.nodeAfter(),
                                   .identity = wanted.identity,
                                   .nodeBefore = wanted.nodeBefore,
                                   .before = isProof ? m_bootUps : canopen::BootUps()});
    m_message->withdraw();
    setStage(isProof ? Stage::proving : Stage::checking);
    m_run.start(*m_check);
}

void NodeSetupView::takeChecked()
{
    using Result = canopen::NodeCheck::Result;
    const bool isProof = m_stage == Stage::proving;
    const bool isThere = m_check->result() == Result::found;
    // At its new rate it has begun anew, or would not be there.
    const bool isProven = isProof && isThere && (m_check->wasWithoutSupply() || m_isRateStored);
    const int after = m_check->wanted().node;
    if (m_bus && !isProof)
        m_bootUps = canopen::BootUps::of(m_bus->latest(), after);
    const bool wasFound = std::exchange(m_isFound, m_isFound || isThere);
    setStage(isProven ? Stage::proven : Stage::toBeProven);
    tell(isProven ? Role::running : Role::attention,
         isProven && m_isRateStored
             ? sentence(tr("Proven: it is node %1 at the rate of this bus."), {CanopenAddress{after}.shown()})
             : node_setup_text::end(*m_check, isProof));
    if (!isThere || wasFound)
        return;
    const int before = m_check->wanted().nodeBefore.value_or(0);
    if (before != after) {
        Message message{.place = m_bus->placeOf(CanopenAddress{after}.place()),
                        .id = CanopenBusMessageId::deviceNumbered,
                        .arguments = {std::int64_t{after}}};
        if (before != 0) {
            message.id = CanopenBusMessageId::nodeNumbered;
            message.arguments = {std::int64_t{before}, std::int64_t{after}};
        }
        Q_EMIT messaged(message);
    }
    m_node = after;
    showDevice();
    Q_EMIT numbered(before, after);
    Q_EMIT changed();
}

void NodeSetupView::takeEnd()
{
    switch (m_stage) {
    case Stage::reading:
        return takeRead();
    case Stage::searching:
        return takeSearched();
    case Stage::writing:
        return takeWritten();
    case Stage::checking:
    case Stage::proving:
        return takeChecked();
    default:
        break;
    }
}

void NodeSetupView::tell(Role role, const QString &sentence)
{
    m_message->showMessage(role, sentence);
}

// With why nothing was sent, where that is known.
void NodeSetupView::tellProblem(const QString &sentence)
{
    const QString refused = m_run.whyRefused() ? refusalText(*m_run.whyRefused()) + u' ' : QString();
    tell(Role::attention, refused + sentence);
}

void NodeSetupView::showDevice()
{
    if (m_stage == Stage::searching)
        m_device->setText(tr("Looking for a device without a number, bit by bit of its identity: some "
                             "seconds."));
    else if (m_identity)
        m_device->setText(sentence(
            tr("%1: %2."), {node_setup_text::device(m_node), node_setup_text::identity(*m_identity)}));
    else if (m_node)
        m_device->setText(
            sentence(tr("%1: who it is has to be read first."), {node_setup_text::device(m_node)}));
    else
        m_device->setText(tr("Choose a node of the CAN bus, or find a device without a number."));
}

void NodeSetupView::showWays()
{
    using enum NodeSetupWish::Way;
    std::vector<std::pair<NodeSetupWish::Way, QString>> ways{{lss, tr("LSS: selected by its identity")}};
    if (m_node)
        ways.emplace_back(lssWithoutStore, tr("LSS, and stored by 1010h:1"));
    if (const auto its = nodeObject())
        ways.emplace_back(object, sentence(tr("Object %1, which its description names"), {its->text()}));
    if (m_way->count() == static_cast<int>(ways.size()))
        return;
    const QSignalBlocker blocker(m_way);
    m_way->clear();
    for (const auto &[way, text] : ways)
        m_way->addItem(text, static_cast<int>(way));
}

void NodeSetupView::showConsequences()
{
    showWays();
    const NodeSetupWish wanted = wish();
    const bool isRead = m_stage == Stage::read;
    m_consequences->setText(
        isRead && (wanted.changesNode() || wanted.rate) ? node_setup_text::consequences(wanted) : QString());
    m_consequences->setVisible(!m_consequences->text().isEmpty());
    EncoderSession *encoder = m_bus && m_node ? m_bus->encoder(CanopenAddress{*m_node}.place()) : nullptr;
    if (encoder != nullptr && isRead)
        m_gate->setWrites(*encoder, 1);
    else
        m_gate->setWrites(std::vector<EepromWrites>());
    showWhatIsPossible();
}

void NodeSetupView::showSteps()
{
    std::vector<SetupSteps::Row> rows;
    if (m_setup)
        for (std::size_t i = 0; i < m_setup->steps().size(); ++i)
            rows.push_back(
                {m_setup->stateOf(i), node_setup_text::step(m_setup->steps()[i], m_setup->wish())});
    using enum canopen::NodeSetup::StepState;
    if (m_setup && !m_setup->trouble() && m_setup->isEnded()) {
        const QString node = CanopenAddress{m_setup->wish().nodeAfter()}.shown();
        if (!m_setup->wish().rate)
            rows.push_back({m_isFound                    ? done
                            : m_stage == Stage::checking ? now
                            : m_check                    ? failed
                                                         : planned,
                            sentence(tr("It is there as node %1"), {node})});
        rows.push_back({m_stage == Stage::proven    ? done
                        : m_stage == Stage::proving ? now
                                                    : planned,
                        sentence(tr("It is there as node %1 after its supply was off"), {node})});
    }
    m_steps->show(rows);
}

void NodeSetupView::showWhatIsPossible()
{
    const QString whyNot = whyNotSent();
    const bool isRead = m_stage == Stage::read;
    const QPointer<QWidget> focused = QApplication::focusWidget();
    const bool isFocused = isAncestorOf(focused);
    const auto enable = [&](QPushButton *button, bool isMeant, const QString &toolTip,
                            const QString &whyElse) {
        button->setEnabled(isMeant && whyNot.isEmpty() && !isBusy());
        button->setToolTip(!whyNot.isEmpty() ? whyNot : isMeant ? toolTip : whyElse);
    };
    enable(m_read, m_node.has_value(), tr("Reads who the node is (1018h). Nothing is written (Alt+R)"),
           tr("Choose a node of the CAN bus first"));
    enable(m_find, true, tr("Looks for a device without a number by LSS (Alt+O)"), {});
    enable(m_write, isRead && (wish().changesNode() || wish().rate) && m_gate->isOpen(),
           tr("Writes number and rate, after a question (Alt+W)"),
           isRead ? tr("Choose another number or a rate first") : tr("Read who the device is first"));
    enable(m_checkNow, m_stage == Stage::toBeProven,
           tr("Looks for the device, once its supply was switched off and on (Alt+I)"),
           tr("For a device that was given a number or rate"));
    m_cancel->setEnabled(isBusy() && (m_stage == Stage::searching || m_stage == Stage::writing));
    m_fields->setEnabled(isRead);
    m_rate->setEnabled(wish().way != NodeSetupWish::Way::object);
    if (isFocused && (!focused->isEnabled() || focused == m_steps))
        focusNext();
}

// What had the focus cannot be used now. While nothing can, the steps have it.
void NodeSetupView::focusNext()
{
    for (QWidget *next :
         std::initializer_list<QWidget *>{m_cancel, m_checkNow, m_write, m_number, m_read, m_find})
        if (next->isEnabled() && next->isVisible()) {
            next->setFocus(Qt::OtherFocusReason);
            return;
        }
    m_steps->setFocus(Qt::OtherFocusReason);
}

} // namespace codewheel
