// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/interbus/master/master_panel.h"

#include "catalog/hex_code.h"
#include "kinds/interbus/ring/master_look.h"
#include "kinds/interbus/ring/master_text.h"
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/ring/send_permission.h"
#include "vocabulary/refusal_text.h"
#include "widgets/kinds/interbus/master/crc_bars.h"
#include "widgets/kinds/interbus/master/segment_model.h"
#include "widgets/kinds/interbus/master/segment_question.h"
#include "widgets/kinds/interbus/master/status_bits.h"
#include "widgets/look/describe.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/role_label.h"

#include <QFormLayout>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int masterPanelHeight = 260; // the rest is scrolled to
constexpr int segmentsInSight = 6;

} // namespace

MasterPanel::MasterPanel(RingSession &bus, QWidget *parent)
    : ScrolledPanel(tr("Master"), masterPanelHeight, parent)
    , m_bus(bus)
    , m_state(new RoleLabel(content()))
    , m_bits(new StatusBits(content()))
    , m_progress(new QProgressBar(content()))
    , m_segments(new SegmentModel(this))
    , m_table(new QTableView(content()))
    , m_message(new InlineMessage(content()))
{
    auto *column = layOut<QVBoxLayout>(content(), grid::margin, grid::unit);
    column->addWidget(m_message);
    makeState(column);
    makeButtons(column);
    column->addWidget(m_bits);
    makeSegments(column);
    column->addStretch(1);

    connect(&bus, &RingSession::updated, this, &MasterPanel::refresh);
    connect(&bus, &RingSession::stateChanged, this, &MasterPanel::refresh);
    connect(&bus, &RingSession::structureChanged, this, [this] {
        m_askedSegment = 0; // what was named may be gone
        m_message->withdraw();
        refresh();
    });
    connect(&bus, &RingSession::readInProgressed, this, [this](int devices) {
        m_progress->setMaximum(std::max(m_progress->maximum(), devices));
        m_progress->setValue(devices);
        m_progress->setFormat(tr("%n devices found", nullptr, devices));
    });
    connect(&bus, &RingSession::readInEnded, this, &MasterPanel::refresh);
    connect(&bus, &RingSession::readInFailed, this, &MasterPanel::refresh);
    m_message->setObjectName(QStringLiteral("masterMessage"));
    connect(m_message, &InlineMessage::actionTriggered, this, &MasterPanel::switchAskedSegmentOff);
    connect(m_message, &InlineMessage::otherActionTriggered, m_message, &InlineMessage::withdraw);
    refresh();
}

MasterPanel::~MasterPanel()
{
    m_table->setModel(nullptr);
}

void MasterPanel::makeState(QVBoxLayout *column)
{
    column->addWidget(m_state);
    auto *form = makeForm(nullptr, grid::unit);
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    m_fault = addLine(*form, tr("Fault"), tr("What is wrong, and where"));
    m_errorCode = addLine(*form, tr("Error code"), tr("As the firmware's manual lists it"));
    m_parameter = addLine(*form, tr("Diagnostic parameter"),
                          tr("Segment and position of the fault; 0080h: not located"));
    m_configuration =
        addLine(*form, tr("Stored configuration"), tr("The configuration stored in the master, by its file"));
    m_errorCode->setFont(numberFont());
    column->addLayout(form);
}

QPushButton *MasterPanel::addButton(Icon icon, const QString &text, const QString &toolTip)
{
    auto *button = new QPushButton(lineIcon(icon), text, content());
    button->setAutoDefault(false);
    button->setToolTip(toolTip);
    return button;
}

void MasterPanel::makeButtons(QVBoxLayout *column)
{
    m_start =
        addButton(Icon::start, tr("Start"), tr("Activates the configuration, and starts data transfer"));
    m_stop = addButton(Icon::stop, tr("Stop"), tr("Stops data transfer"));
    m_readIn = addButton(Icon::refresh, tr("Read in the ring"),
                         tr("Stops the ring, finds its devices one by one, and starts it again"));
    m_confirm = addButton(Icon::ok, tr("Confirm diagnostics"),
                          tr("Confirms peripheral faults; one whose cause is still there comes back"));
    auto *grid = new QGridLayout;
    grid->setSpacing(grid::unit);
    grid->addWidget(m_start, 0, 0);
    grid->addWidget(m_stop, 0, 1);
    grid->addWidget(m_readIn, 1, 0, 1, 2);
    grid->addWidget(m_confirm, 2, 0, 1, 2);
    column->addLayout(grid);
    m_progress->setAccessibleName(tr("Reading in the ring"));
    m_progress->hide();
    column->addWidget(m_progress);
    connect(m_start, &QPushButton::clicked, this, &MasterPanel::startRequested);
    connect(m_stop, &QPushButton::clicked, this, &MasterPanel::stopRequested);
    connect(m_readIn, &QPushButton::clicked, this, [this] {
        if (mayChangeRing())
            Q_EMIT readInRequested();
    });
    connect(m_confirm, &QPushButton::clicked, this, [this] {
        if (mayChangeRing())
            m_bus.confirmDiagnostics();
    });
}

void MasterPanel::makeSegments(QVBoxLayout *column)
{
    describe(m_table, tr("Segments"), tr("A segment is a remote-bus device and the cable before it"));
    m_table->setModel(m_segments);
    m_table->setItemDelegateForColumn(SegmentModel::historyColumn, new CrcBars(m_table));
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setTabKeyNavigation(false);
    m_table->setIconSize({grid::smallIcon, grid::smallIcon});
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    const int rowHeight = m_table->fontMetrics().height() + grid::unit;
    m_table->verticalHeader()->setDefaultSectionSize(rowHeight);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(SegmentModel::historyColumn, QHeaderView::Stretch);
    m_table->setMinimumHeight((segmentsInSight + 2) * rowHeight);
    column->addWidget(m_table);
    m_switch = addButton(Icon::power, {}, {});
    column->addWidget(m_switch);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentChanged, this,
            &MasterPanel::showSegmentButton);
    connect(m_switch, &QPushButton::clicked, this, [this] { toggleSegment(chosenSegment()); });
}

const SegmentRow *MasterPanel::findSegment(int segment) const
{
    const auto found = std::ranges::find(m_segments->rows(), segment, &SegmentRow::segment);
    return found == m_segments->rows().end() ? nullptr : &*found;
}

bool MasterPanel::mayChangeRing()
{
    const auto allowed = codewheel::mayChangeRing(m_bus.latest());
    m_askedSegment = 0;
    if (allowed) {
        m_message->withdraw();
        return true;
    }
    m_message->showMessage(Role::attention, refusalText(allowed.error()));
    ensureWidgetVisible(m_message);
    Q_EMIT asked();
    return false;
}

void MasterPanel::toggleSegment(int segment)
{
    const SegmentRow *found = findSegment(segment);
    if (found == nullptr || !mayChangeRing())
        return;
    if (found->switchedOff)
        m_bus.switchSegment(segment, true);
    else
        askForSegment(segment);
}

void MasterPanel::askForSegment(int segment)
{
    m_askedSegment = segment;
    m_message->showMessage(Role::attention, segmentQuestion(m_bus, segment), tr("Switch o&ff"),
                           tr("&Leave it on"));
    ensureWidgetVisible(m_message);
    Q_EMIT asked();
}

void MasterPanel::switchAskedSegmentOff()
{
    const int segment = std::exchange(m_askedSegment, 0);
    if (segment > 0 && mayChangeRing())
        m_bus.switchSegment(segment, false);
}

// A refusal goes once writing is allowed; a question, once there is nothing left to switch off.
void MasterPanel::withdrawWhatIsOver()
{
    const SegmentRow *segment = findSegment(m_askedSegment);
    const bool canBeSwitched = segment != nullptr && !segment->switchedOff && m_bus.isOperating();
    if (m_askedSegment > 0 ? !canBeSwitched : m_bus.isOperating()) {
        m_askedSegment = 0;
        m_message->withdraw();
    }
}

int MasterPanel::chosenSegment() const
{
    const QModelIndex current = m_table->currentIndex();
    return current.isValid() ? m_segments->rowAt(current.row()).segment : 0;
}

// What it said before the connection ended is not what it says.
const MasterStatus *MasterPanel::master() const
{
    return m_bus.isOpen() ? m_bus.master() : nullptr;
}

void MasterPanel::refresh()
{
    const MasterState state = m_bus.latest().state;
    const bool isReading = m_bus.isReadingIn();
    const bool isOpen = m_bus.isOpen();
    showState();
    const bool hasMaster = master() != nullptr;
    m_start->setEnabled(isOpen && state != MasterState::run && !isReading);
    m_stop->setEnabled(isOpen && state == MasterState::run);
    m_readIn->setEnabled(hasMaster && !isReading);
    m_confirm->setEnabled(hasMaster && !isReading);
    m_bits->setVisible(hasMaster);
    m_table->setVisible(hasMaster);
    showFault();
    showReadIn();
    m_segments->show(m_bus);
    if (!m_table->currentIndex().isValid() && m_segments->rowCount() > 0)
        m_table->setCurrentIndex(m_segments->index(0, 0));
    showSegmentButton();
    withdrawWhatIsOver();
}

void MasterPanel::showState()
{
    const bool isLost = m_bus.state() == BusState::lost;
    m_bits->setEnabled(!isLost);
    if (isLost)
        m_state->setState(Role::fault, tr("Link lost: as the master was before"));
    else if (!m_bus.isOpen())
        m_state->setState(Role::inactive, tr("Not connected"));
    else
        m_state->setState(masterRole(m_bus.latest()),
                          tr("Master %1").arg(masterStateName(m_bus.latest().state)));
}

void MasterPanel::showFault()
{
    const MasterStatus *master = this->master();
    if (!master) {
        m_fault->setText(m_bus.isOpen() ? tr("This link does not reach the master.")
                                        : QString(QChar(0x2013)));
        for (QLabel *label : {m_errorCode, m_parameter, m_configuration})
            label->setText(QString(QChar(0x2013)));
        return;
    }
    m_bits->showBits(master->statusBits);
    m_fault->setText(masterFaultText(*master));
    m_errorCode->setText(hexCode(master->errorCode, 4));
    const QString hex = hexCode(master->parameter, 4);
    const auto place = master->faultPlace();
    m_parameter->setText(place                ? QStringLiteral("%1: %2").arg(hex, faultPlaceText(*place))
                         : master->isFaulty() ? tr("%1: not located").arg(hex)
                                              : hex);
    m_configuration->setText(master->configurationName.value_or(tr("no configuration")));
}

void MasterPanel::showReadIn()
{
    if (m_bus.isReadingIn() == !m_progress->isHidden())
        return;
    m_progress->setRange(0, static_cast<int>(m_bus.structure().size()));
    m_progress->setValue(0);
    m_progress->setVisible(m_bus.isReadingIn());
}

void MasterPanel::showSegmentButton()
{
    const int segment = chosenSegment();
    m_switch->setVisible(master() != nullptr);
    m_switch->setEnabled(m_bus.isOpen() && segment > 0 && m_bus.latest().state != MasterState::ready);
    const SegmentRow *found = findSegment(segment);
    const bool isOff = found != nullptr && found->switchedOff;
    const QString text =
        isOff ? tr("Switch segment %1 on").arg(segment) : tr("Switch segment %1 off").arg(segment);
    if (m_switch->text() == text)
        return;
    m_switch->setText(text);
    m_switch->setToolTip(isOff ? tr("Its devices, and those behind them, take part in the data cycles again")
                               : tr("Its devices, and those behind them, take no part in the data cycles; "
                                    "their outputs go to 0"));
    m_switch->setAccessibleDescription(m_switch->toolTip());
}

} // namespace codewheel
