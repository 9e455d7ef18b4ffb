// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/comparison/comparison_page.h"

#include "encoder/refusal_text.h"
#include "project/project_take_over.h"
#include "ring/bus_session.h"
#include "ring/send_permission.h"
#include "ring/take_over.h"
#include "widgets/comparison/comparison_model.h"
#include "widgets/look/describe.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"

#include <QCheckBox>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include <numeric>

namespace codewheel {
namespace {

std::vector<std::size_t> allOf(const Comparison &comparison)
{
    std::vector<std::size_t> lines(comparison.size());
    std::iota(lines.begin(), lines.end(), 0U);
    return lines;
}

QString keptName(const KeptConfiguration &kept)
{
    return kept.fileName.isEmpty() ? ComparisonPage::tr("a configuration without a name") : kept.fileName;
}

} // namespace

ComparisonPage::ComparisonPage(ProjectDocument &document, BusSession &bus, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
    , m_bus(bus)
    , m_model(new ComparisonModel(this))
    , m_table(describe(new QTableView(this), "comparison", tr("Configured and connected ring"),
                       tr("Choose the lines that are to be taken over.")))
    , m_summary(new QLabel(this))
    , m_onlyDifferences(describe(new QCheckBox(tr("On&ly differences"), this), "onlyDifferences",
                                 tr("Hides the lines that are the same")))
    , m_readIn(describe(new QPushButton(lineIcon(Icon::read), tr("&Read in the ring"), this), "readIn",
                        tr("The master finds the devices of the ring anew; data cycles stop meanwhile")))
    , m_lineIntoProject(describe(new QPushButton(tr("Chosen lines into the &project"), this),
                                 "linesIntoProject",
                                 tr("Plans the chosen lines as they are connected; can be undone")))
    , m_allIntoProject(describe(new QPushButton(tr("&All into the project"), this), "allIntoProject",
                                tr("Plans the whole ring as it is connected; can be undone")))
    , m_lineIntoMaster(describe(new QPushButton(tr("Chosen lines into the &master"), this), "linesIntoMaster",
                                tr("Downloads the connected ring with the chosen lines as they are planned; "
                                   "the master keeps it")))
    , m_allIntoMaster(describe(new QPushButton(tr("Project into the mas&ter"), this), "allIntoMaster",
                               tr("Downloads the planned ring, which the master keeps, and loads it back")))
    , m_keptIntoProject(describe(
          new QPushButton(tr("What the master &keeps into the project"), this), "keptIntoProject",
          tr("Loads the configuration that the master keeps, and plans the ring as it says; can be undone")))
    , m_message(new InlineMessage(this))
    , m_empty(new EmptyState(Icon::compare, tr("No ring is connected."),
                             tr("Connect to compare it with the project."), this))
{
    m_summary->setObjectName(QStringLiteral("comparisonSummary"));
    m_summary->setWordWrap(true);
    m_message->setObjectName(QStringLiteral("comparisonMessage"));
    m_table->setModel(m_model);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setTabKeyNavigation(false);
    m_table->setIconSize({grid::smallIcon, grid::smallIcon});
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setMinimumSectionSize(m_table->verticalHeader()->defaultSectionSize());
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents); // nothing is cut off
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    setFocusProxy(m_table);
    arrange();
    connect(m_onlyDifferences, &QCheckBox::toggled, this, &ComparisonPage::compare);
    connect(m_readIn, &QPushButton::clicked, this, [this] {
        if (mayChangeRing())
            Q_EMIT readInRequested();
    });
    connect(&bus, &BusSession::stateChanged, this, [this] {
        if (m_isRefused && m_bus.isOperating() && !m_before)
            m_message->withdraw();
    });
    connect(m_lineIntoProject, &QPushButton::clicked, this, [this] { takeIntoProject(selectedLines()); });
    connect(m_allIntoProject, &QPushButton::clicked, this,
            [this] { takeIntoProject(allOf(m_model->comparison())); });
    connect(m_lineIntoMaster, &QPushButton::clicked, this, [this] { takeIntoMaster(selectedLines()); });
    connect(m_allIntoMaster, &QPushButton::clicked, this, [this] {
        keep({QFileInfo(m_document.file()).fileName(), structureOf(m_document.project(), m_bus.id())});
    });
    connect(m_keptIntoProject, &QPushButton::clicked, this, &ComparisonPage::loadBack);
    connect(m_message, &InlineMessage::actionTriggered, this, [this] {
        if (m_before)
            keep(*m_before);
    });
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &ComparisonPage::showWhatIsPossible);
    connect(&document, &ProjectDocument::changed, this, &ComparisonPage::compare);
    connect(&bus, &BusSession::structureChanged, this, &ComparisonPage::compare);
    connect(&bus, &BusSession::readInEnded, this, &ComparisonPage::compare);
    connect(&bus, &BusSession::named, this, &ComparisonPage::compare);
    connect(&bus, &BusSession::keptConfigurationTold, this, &ComparisonPage::showKept);
    setConnected(false);
}

void ComparisonPage::arrange()
{
    auto *top = new QHBoxLayout;
    top->setSpacing(grid::groupGap);
    top->addWidget(m_summary, 1);
    top->addWidget(m_onlyDifferences);
    top->addWidget(m_readIn);
    auto *buttons = new QGridLayout;
    buttons->setSpacing(grid::unit);
    buttons->addWidget(m_lineIntoProject, 0, 0);
    buttons->addWidget(m_allIntoProject, 0, 1);
    buttons->addWidget(m_lineIntoMaster, 1, 0);
    buttons->addWidget(m_allIntoMaster, 1, 1);
    buttons->addWidget(m_keptIntoProject, 2, 0, 1, 2);
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(grid::margin, grid::margin, grid::margin, grid::margin);
    rows->setSpacing(grid::unit);
    rows->addLayout(top);
    rows->addWidget(m_message);
    rows->addWidget(m_empty, 1);
    rows->addWidget(m_table, 1);
    rows->addLayout(buttons);
}

void ComparisonPage::setConnected(bool isConnected)
{
    m_isConnected = isConnected;
    m_empty->setVisible(!isConnected);
    m_table->setVisible(isConnected);
    m_message->withdraw();
    m_kept.reset();
    m_before.reset();
    compare();
    if (isConnected && m_bus.master() != nullptr)
        m_bus.askKeptConfiguration();
}

int ComparisonPage::differences() const
{
    return m_model->differences();
}

void ComparisonPage::compare()
{
    if (!m_isConnected) {
        m_summary->clear();
        showWhatIsPossible();
        return;
    }
    m_model->compare(structureOf(m_document.project(), m_bus.id()), m_bus.structure(), m_bus.catalog(),
                     m_onlyDifferences->isChecked());
    const int differences = m_model->differences();
    m_summary->setText(differences == 0 ? tr("The ring is as it is configured.")
                                        : tr("%n lines differ.", nullptr, differences));
    showWhatIsPossible();
}

std::vector<std::size_t> ComparisonPage::selectedLines() const
{
    std::vector<std::size_t> lines;
    for (const QModelIndex &index : m_table->selectionModel()->selectedRows())
        lines.push_back(m_model->rowAt(index.row()).line);
    return lines;
}

void ComparisonPage::takeIntoProject(const std::vector<std::size_t> &lines)
{
    plan(m_bus.structure(), m_model->comparison(), lines, tr("Take over from the ring"));
}

// As `ring` has it, in these lines of the comparison of the project with it. By value: the page compares anew
// while the project changes.
// NOLINTNEXTLINE(performance-unnecessary-value-param)
void ComparisonPage::plan(RingStructure ring, Comparison comparison, const std::vector<std::size_t> &lines,
                          const QString &what)
{
    ProjectDocument::Origins origins;
    for (const TakenDevice &device : takeOver(comparison, lines))
        origins.push_back(device.own);
    m_document.edit(takenOver(m_document.project(), ring, comparison, lines, m_bus.id()), m_bus.id(), origins,
                    what);
}

void ComparisonPage::loadBack()
{
    const Comparison comparison =
        compareRings(structureOf(m_document.project(), m_bus.id()), m_kept->structure);
    plan(m_kept->structure, comparison, allOf(comparison), tr("Load the configuration of the master"));
    m_message->showMessage(Role::running, tr("The ring is planned as the master keeps it: %1, %n devices.",
                                             nullptr, static_cast<int>(m_kept->structure.size()))
                                              .arg(keptName(*m_kept)));
}

void ComparisonPage::takeIntoMaster(const std::vector<std::size_t> &lines)
{
    const RingStructure configured = structureOf(m_document.project(), m_bus.id());
    keep({QFileInfo(m_document.file()).fileName(),
          takenOver(m_bus.structure(), configured, mirrored(m_model->comparison()), lines)});
}

bool ComparisonPage::mayChangeRing()
{
    const auto allowed = codewheel::mayChangeRing(m_bus.latest());
    m_isRefused = !allowed;
    if (m_isRefused)
        m_message->showMessage(Role::attention, refusalText(allowed.error()),
                               m_before ? tr("Take back") : QString());
    return !m_isRefused;
}

// Downloads it, and loads back what the master keeps then. By value: taking back passes m_before itself.
// NOLINTNEXTLINE(performance-unnecessary-value-param)
void ComparisonPage::keep(KeptConfiguration configuration)
{
    if (!mayChangeRing())
        return;
    m_before = m_kept;
    m_isDownloading = true;
    m_message->withdraw();
    m_bus.keepConfiguration(configuration);
    m_bus.askKeptConfiguration();
}

void ComparisonPage::showKept(const std::optional<KeptConfiguration> &configuration)
{
    m_kept = configuration;
    showWhatIsPossible();
    if (!std::exchange(m_isDownloading, false) || !m_kept)
        return;
    const int others = codewheel::differences(
        compareRings(structureOf(m_document.project(), m_bus.id()), m_kept->structure));
    const QString kept =
        tr("The master keeps %1 with %n devices.", nullptr, static_cast<int>(m_kept->structure.size()))
            .arg(keptName(*m_kept));
    const QString loaded = others == 0
                               ? tr("Loaded back, it is the project's.")
                               : tr("Loaded back, %n lines differ from the project.", nullptr, others);
    m_message->showMessage(others == 0 ? Role::running : Role::attention, kept + QLatin1Char(' ') + loaded,
                           m_before ? tr("Take back") : QString());
}

void ComparisonPage::showWhatIsPossible()
{
    const bool hasMaster = m_isConnected && m_bus.master() != nullptr;
    const bool isSelected = m_isConnected && m_table->selectionModel()->hasSelection();
    m_readIn->setEnabled(hasMaster);
    m_lineIntoProject->setEnabled(isSelected);
    m_allIntoProject->setEnabled(m_isConnected && m_model->differences() > 0);
    m_lineIntoMaster->setEnabled(isSelected && hasMaster);
    m_allIntoMaster->setEnabled(hasMaster && !devicesOn(m_document.project(), m_bus.id()).empty());
    m_keptIntoProject->setEnabled(m_isConnected && m_kept &&
                                  codewheel::differences(compareRings(
                                      structureOf(m_document.project(), m_bus.id()), m_kept->structure)) > 0);
}

} // namespace codewheel
