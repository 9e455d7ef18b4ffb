// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/buses/bus_at_work.h"

#include "app/journal_files.h"
#include "bus/data_check.h"
#include "journal/ledger_keeper.h"
#include "project/bus_kind.h"
#include "widgets/project/project_document.h"

#include <QFileInfo>

namespace codewheel {
namespace {

// Keeps the account informed of the project's file and the serial numbers on its labels. Simulated encoders
// stay the same whatever project is open: their account is in memory, as they are.
void keepAccountOf(ProjectDocument &project, LedgerKeeper &ledger)
{
    const bool isOfProject = !ledger.place().inMemory;
    const auto tell = [&project, &ledger, isOfProject] {
        if (isOfProject)
            ledger.setProject(project.file());
        project.forEachDevice([&ledger](Place place, const ProjectDevice &device) {
            ledger.setLabel(place, device.label.serialNumber);
        });
    };
    QObject::connect(&project, &ProjectDocument::changed, &ledger, tell);
    // A different project has already reported its file with changed().
    if (isOfProject)
        QObject::connect(&project, &ProjectDocument::fileChanged, &ledger,
                         [&project, &ledger] { ledger.projectSavedAs(project.file()); });
    tell();
}

} // namespace

BusAtWork::BusAtWork(BusId id, Surroundings surroundings, QObject *parent)
    : QObject(parent)
    , m_id(id)
    , m_surroundings(std::move(surroundings))
{
    connect(&m_surroundings.project, &ProjectDocument::replaced, &m_known, &KnownKeeper::forget);
    const auto note = [this] { m_file = project().file(); };
    connect(&m_surroundings.project, &ProjectDocument::changed, this, note);
    connect(&m_surroundings.project, &ProjectDocument::fileChanged, this, &BusAtWork::carryAccount);
    note();
}

BusAtWork::~BusAtWork() = default;

bool BusAtWork::isTraining() const
{
    return busKind(kind())->trainingBus() == m_id;
}

QString BusAtWork::nameOfNew() const
{
    return busKind(kind())->nameOfNew();
}

DataChecks BusAtWork::dataChecks(NodeId node) const
{
    const Project &its = project().project();
    if (bus() != nullptr && bus()->state() != BusState::closed)
        return bus()->dataChecks(node, participantsOn(its, m_id));
    const PlannedBus *planned = findBus(its, m_id);
    const BusKind *kindOfIt = busKind(kind());
    const QString link =
        planned != nullptr && kindOfIt != nullptr ? kindOfIt->linkText(planned->settings) : QString();
    return {notConnectedCheck(link, m_whyRefused || bus() == nullptr ? m_whyRefused : bus()->whyRefused())};
}

void BusAtWork::tellMessagesOf(EncoderBus &bus)
{
    connect(&bus, &EncoderBus::messaged, this,
            [this, &bus](const Message &message) { Q_EMIT messaged(message, bus.dateTime(message.at)); });
}

// To the file that the project is in now. While a real bus is connected its LedgerKeeper does so.
void BusAtWork::carryAccount()
{
    const QString from = std::exchange(m_file, project().file());
    const QString file = ledgerFile(m_surroundings.dataFolder);
    const bool isKept = m_ledger && !m_ledger->place().inMemory;
    if (isKept || from == m_file || !QFileInfo::exists(file))
        return;
    SafeLedger ledger(DatabasePlace::file(file));
    ledger.carryPlaces(ledgerProject(from), ledgerProject(m_file), m_id);
    if (ledger.problem())
        Q_EMIT messaged(*ledger.problem(), m_surroundings.clock());
}

void BusAtWork::keepAccount(std::unique_ptr<LedgerKeeper> ledger)
{
    m_ledger = std::move(ledger);
    m_known.watch(*bus());
    const auto tell = [this](const Message &message) { Q_EMIT messaged(message, m_surroundings.clock()); };
    connect(m_ledger.get(), &LedgerKeeper::messaged, this, tell);
    if (m_ledger->problem())
        tell(*m_ledger->problem());
    keepAccountOf(m_surroundings.project, *m_ledger);
}

void BusAtWork::forgetKnown()
{
    m_known.forget();
}

void BusAtWork::forgetSimulated()
{
    m_known.forgetSimulated();
}

void BusAtWork::endAccount()
{
    m_ledger.reset();
}

} // namespace codewheel
