// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/interbus/master/ring_comparison.h"

#include "kinds/interbus/plan/project_take_over.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/ring/send_permission.h"
#include "kinds/interbus/ring/take_over.h"
#include "vocabulary/refusal_text.h"
#include "widgets/look/describe.h"
#include "widgets/look/inline_message.h"

#include <QFileInfo>
#include <QGridLayout>
#include <QPushButton>

#include <utility>

namespace codewheel {
namespace {

QString keptName(const KeptConfiguration &kept)
{
    return kept.fileName.isEmpty() ? RingComparison::tr("a configuration without a name") : kept.fileName;
}

} // namespace

RingComparison::RingComparison(ProjectDocument &document, RingSession &bus, QWidget *parent)
    : ComparisonPage(document, bus.catalog(), bus.id(), QString::fromLatin1(interbusKind), parent)
    , m_document(document)
    , m_ring(bus)
    , m_readIn(describe(new QPushButton(lineIcon(Icon::read), tr("&Read in the ring"), this), "readIn",
                        tr("The master finds the devices of the ring again; data cycles stop meanwhile")))
    , m_lineIntoMaster(describe(new QPushButton(tr("Chosen lines into the &master"), this), "linesIntoMaster",
                                tr("Downloads the connected ring with the chosen lines as they are planned; "
                                   "the master keeps it")))
    , m_allIntoMaster(describe(new QPushButton(tr("Project into the mas&ter"), this), "allIntoMaster",
                               tr("Downloads the planned ring, which the master keeps, and loads it back")))
    , m_keptIntoProject(describe(
          new QPushButton(tr("What the master &keeps into the project"), this), "keptIntoProject",
          tr("Loads the configuration that the master keeps, and plans the ring as it says; can be undone")))
{
    top().addWidget(m_readIn);
    buttons().addWidget(m_lineIntoMaster, 1, 0);
    buttons().addWidget(m_allIntoMaster, 1, 1);
    buttons().addWidget(m_keptIntoProject, 2, 0, 1, 2);
    connect(m_readIn, &QPushButton::clicked, this, [this] {
        if (mayChangeRing())
            Q_EMIT readInRequested();
    });
    connect(m_lineIntoMaster, &QPushButton::clicked, this, &RingComparison::takeIntoMaster);
    connect(m_allIntoMaster, &QPushButton::clicked, this, [this] {
        keep({QFileInfo(m_document.file()).fileName(), configured()});
    });
    connect(m_keptIntoProject, &QPushButton::clicked, this, &RingComparison::loadBack);
    connect(&message(), &InlineMessage::actionTriggered, this, [this] {
        if (m_before)
            keep(*m_before);
    });
    connect(&bus, &RingSession::structureChanged, this, &RingComparison::compare);
    connect(&bus, &RingSession::readInEnded, this, &RingComparison::compare);
    connect(&bus, &RingSession::named, this, &RingComparison::compare);
    connect(&bus, &RingSession::keptConfigurationTold, this, &RingComparison::showKept);
    setBus(&bus);
}

QString RingComparison::effect() const
{
    return tr("Changes the project, or the master, as you choose; the master only in Operate.");
}

RingStructure RingComparison::configured() const
{
    return structureOf(m_document.project(), m_ring.id());
}

void RingComparison::showState()
{
    m_kept.reset();
    m_before.reset();
    ComparisonPage::showState();
    if (isConnected() && m_ring.master() != nullptr)
        m_ring.askKeptConfiguration();
}

int RingComparison::differencesOf(const KeptConfiguration &kept)
{
    return codewheel::differences(compareRings(configured(), kept.structure));
}

void RingComparison::loadBack()
{
    const KeptConfiguration kept = *m_kept;
    const Comparison lines = compareRings(configured(), kept.structure);
    edits().takeOver({participantsOf(kept.structure), {}}, lines, allLines(lines),
                     tr("Load the configuration of the master"));
    message().showMessage(Role::running, tr("The ring is planned as the master keeps it: %1, %n devices.",
                                            nullptr, static_cast<int>(kept.structure.size()))
                                             .arg(keptName(kept)));
}

void RingComparison::takeIntoMaster()
{
    keep({QFileInfo(m_document.file()).fileName(),
          takenOver(m_ring.structure(), configured(), mirrored(comparison()), selectedLines())});
}

bool RingComparison::mayChangeRing()
{
    const auto allowed = codewheel::mayChangeRing(m_ring.latest());
    if (!allowed)
        message().showMessage(Role::attention, refusalText(allowed.error()),
                              m_before ? tr("Take back") : QString());
    return allowed.has_value();
}

// Downloads it, then loads back what the master keeps. By value, since taking back passes m_before itself.
// NOLINTNEXTLINE(performance-unnecessary-value-param)
void RingComparison::keep(KeptConfiguration configuration)
{
    if (!mayChangeRing())
        return;
    m_before = m_kept;
    m_isDownloading = true;
    message().withdraw();
    m_ring.keepConfiguration(configuration);
    m_ring.askKeptConfiguration();
}

void RingComparison::showKept(const std::optional<KeptConfiguration> &configuration)
{
    m_kept = configuration;
    showWhatIsPossible();
    if (!std::exchange(m_isDownloading, false) || !m_kept)
        return;
    const int others = differencesOf(*m_kept);
    const QString kept =
        tr("The master keeps %1 with %n devices.", nullptr, static_cast<int>(m_kept->structure.size()))
            .arg(keptName(*m_kept));
    const QString loaded = others == 0
                               ? tr("Loaded back, it is the project's.")
                               : tr("Loaded back, %n lines differ from the project.", nullptr, others);
    message().showMessage(others == 0 ? Role::running : Role::attention, kept + QLatin1Char(' ') + loaded,
                          m_before ? tr("Take back") : QString());
}

void RingComparison::showWhatIsPossible()
{
    ComparisonPage::showWhatIsPossible();
    const bool hasMaster = isConnected() && m_ring.master() != nullptr;
    m_readIn->setEnabled(hasMaster);
    m_lineIntoMaster->setEnabled(hasMaster && !selectedLines().empty());
    m_allIntoMaster->setEnabled(hasMaster && !configured().empty());
    m_keptIntoProject->setEnabled(isConnected() && m_kept && differencesOf(*m_kept) > 0);
}

} // namespace codewheel
