// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/comparison/comparison_page.h"

#include "bus/encoder_bus.h"
#include "project/old_devices.h"
#include "widgets/comparison/comparison_model.h"
#include "widgets/look/describe.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/wrapped_label.h"
#include "widgets/models/age_text.h"
#include "widgets/models/age_timer.h"

#include <QCheckBox>
#include <QHeaderView>
#include <QPushButton>
#include <QTableView>

#include <numeric>

namespace codewheel {
namespace {

// No signal tells whether an encoder answers, and which one it is.
constexpr Instant lookInterval = std::chrono::seconds(1);

} // namespace

std::vector<std::size_t> allLines(const Comparison &comparison)
{
    std::vector<std::size_t> lines(comparison.size());
    std::iota(lines.begin(), lines.end(), 0U);
    return lines;
}

ComparisonPage::ComparisonPage(ProjectDocument &document, const Catalog &catalog, BusId bus,
                               const QString &kind, QWidget *parent)
    : Page(parent)
    , m_edits(document, catalog)
    , m_model(new ComparisonModel(this))
    , m_table(describe(new QTableView(this), "comparison", tr("Configured and connected bus"),
                       tr("Choose the lines that are to be taken over.")))
    , m_summary(wrappedLabel(this, "comparisonSummary"))
    , m_onlyDifferences(describe(new QCheckBox(tr("On&ly differences"), this), "onlyDifferences",
                                 tr("Hides the lines that are the same")))
    , m_lineIntoProject(describe(new QPushButton(tr("Chosen lines into the &project"), this),
                                 "linesIntoProject",
                                 tr("Plans the chosen lines as they are connected; can be undone")))
    , m_allIntoProject(describe(new QPushButton(tr("&All into the project"), this), "allIntoProject",
                                tr("Plans the whole bus as it is connected; can be undone")))
    , m_message(named(new InlineMessage(this), "comparisonMessage"))
    , m_empty(new EmptyState(Icon::compare, tr("The bus is not connected"),
                             tr("Connect to compare it with the project."), this))
    , m_age(new AgeTimer(this))
    , m_top(new QHBoxLayout)
    , m_buttons(new QGridLayout)
{
    m_edits.setBus(bus, kind);
    m_table->setModel(m_model);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setTabKeyNavigation(false);
    m_table->setIconSize({grid::smallIcon, grid::smallIcon});
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setMinimumSectionSize(m_table->verticalHeader()->defaultSectionSize());
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents); // nothing is cut off
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    setFocusProxy(m_table);
    arrange();
    connect(m_onlyDifferences, &QCheckBox::toggled, this, &ComparisonPage::compare);
    connect(m_lineIntoProject, &QPushButton::clicked, this, [this] { takeIntoProject(selectedLines()); });
    connect(m_allIntoProject, &QPushButton::clicked, this,
            [this] { takeIntoProject(allLines(comparison())); });
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            [this] { showWhatIsPossible(); });
    connect(m_age, &QTimer::timeout, this, &ComparisonPage::showSummary);
    connect(&document, &ProjectDocument::changed, this, &ComparisonPage::compare);
}

QString ComparisonPage::about() const
{
    const PlannedBus *bus = findBus(m_edits.project(), m_edits.bus());
    return bus != nullptr ? bus->name : QString();
}

QString ComparisonPage::effect() const
{
    return tr("What you take over changes the project alone. Nothing is sent here.");
}

void ComparisonPage::arrange()
{
    m_top->setSpacing(grid::groupGap);
    m_top->addWidget(m_summary, 1);
    m_top->addWidget(m_onlyDifferences);
    m_buttons->setSpacing(grid::unit);
    m_buttons->addWidget(m_lineIntoProject, 0, 0);
    m_buttons->addWidget(m_allIntoProject, 0, 1);
    layOutColumn(this, {m_top, m_message, {m_empty, 1}, {m_table, 1}, m_buttons},
                 {.spacing = grid::unit, .margins = allAround(grid::margin)});
}

void ComparisonPage::setBus(EncoderBus *bus)
{
    if (m_bus)
        m_bus->disconnect(this);
    m_bus = bus;
    if (bus != nullptr) {
        connect(bus, &EncoderBus::stateChanged, this, [this] { showState(); });
        connect(bus, &EncoderBus::nodesChanged, this, &ComparisonPage::compare);
        connect(bus, &EncoderBus::updated, this, &ComparisonPage::followAnswers);
    }
    showState();
}

bool ComparisonPage::isConnected() const
{
    return m_bus && m_bus->isOpen();
}

void ComparisonPage::showState()
{
    m_empty->setVisible(!isConnected());
    m_table->setVisible(isConnected() && m_bus->findsDevices());
    m_message->withdraw();
    m_comparedAt.reset(); // how its devices stand is told with the next frame; the clock may stand still
    compare();
}

const Comparison &ComparisonPage::comparison() const
{
    return m_model->comparison();
}

int ComparisonPage::differences() const
{
    return codewheel::differences(comparison());
}

// The selection stays while nothing changes.
void ComparisonPage::followAnswers()
{
    if (!isVisible() || !isConnected())
        return;
    const bool isLive = m_connected.notLive.empty();
    if (m_comparedAt && isLive && m_bus->now() - *m_comparedAt < lookInterval)
        return;
    m_comparedAt = m_bus->now();
    if (connectedBus(m_edits.project(), *m_bus) != m_connected)
        compare();
}

void ComparisonPage::compare()
{
    if (!isConnected()) {
        m_summary->clear();
        m_age->stop();
        showWhatIsPossible();
        return;
    }
    m_connected = connectedBus(m_edits.project(), *m_bus);
    m_model->compare(m_edits, m_connected, m_onlyDifferences->isChecked());
    showSummary();
    showWhatIsPossible();
}

// What nobody hears of now is told as it was.
void ComparisonPage::showSummary()
{
    if (isConnected() && !m_bus->findsDevices()) {
        m_age->stop();
        m_summary->setText(
            tr("There is nothing to compare: this link does not tell which devices are on the ring. "
               "Those shown as connected are the ones that the project had when the ring was "
               "connected."));
        return;
    }
    const std::vector<OldDevices> old = oldDevices(m_connected);
    const bool isSame = differences() == 0;
    QStringList sentences{old.empty() ? isSame ? tr("The bus is as configured.")
                                               : tr("%n lines differ.", nullptr, differences())
                          : isSame ? tr("The bus was as configured.")
                                      : tr("%n lines differed.", nullptr, differences())};
    QDateTime seen;
    for (const OldDevices &devices : old) {
        sentences << withPlaces(devices, ageSentence(devices.old));
        seen = devices.old.seen.isValid() ? devices.old.seen : seen;
    }
    m_summary->setText(sentences.join(u' '));
    m_age->follow(seen);
}

std::vector<std::size_t> ComparisonPage::selectedLines() const
{
    std::vector<std::size_t> lines;
    for (const QModelIndex &index : m_table->selectionModel()->selectedRows())
        lines.push_back(m_model->rowAt(index.row()).line);
    return lines;
}

// Copies, since the page compares again while the project changes.
void ComparisonPage::takeIntoProject(const std::vector<std::size_t> &lines)
{
    const ConnectedBus connected = m_connected;
    const Comparison taken = comparison();
    m_edits.takeOver(connected, taken, lines, tr("Take over from the bus"));
}

void ComparisonPage::showWhatIsPossible()
{
    const bool canTake = isConnected() && m_bus->findsDevices();
    m_lineIntoProject->setEnabled(canTake && m_table->selectionModel()->hasSelection());
    m_allIntoProject->setEnabled(canTake && differences() > 0);
}

} // namespace codewheel
