// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/ledger_keeper.h"

#include "catalog/device_description.h"
#include "journal/eeprom_cost.h"
#include "ring/bus_session.h"

namespace codewheel {

LedgerKeeper::LedgerKeeper(BusSession &bus, const DatabasePlace &place, QObject *parent)
    : QObject(parent)
    , m_bus(bus)
{
    open(place);
    connect(&bus, &BusSession::named, this, [this](DeviceNumber number) {
        const std::vector<qint64> unassigned = m_watched[number].unassigned; // it is the same encoder
        watch(number);
        m_watched[number].unassigned = unassigned;
    });
    connect(&bus, &BusSession::structureChanged, this, &LedgerKeeper::watchAll);
    connect(&bus, &BusSession::stateChanged, this, [this] { // connected again, it has other sessions
        for (const DeviceNumber number : m_bus.numbers())
            if (m_watched[number].encoder != m_bus.encoder(number)) {
                watchAll();
                return;
            }
    });
    watchAll();
}

LedgerKeeper::~LedgerKeeper() = default;

// A damaged file is put aside and another one begun; whatever else is wrong with it, it stays as it is.
void LedgerKeeper::open(const DatabasePlace &place)
{
    m_place = place;
    auto opened = Ledger::open(place);
    if (!opened && opened.error().kind == DatabaseError::Kind::broken) {
        const QString aside = putAside(place.name);
        if (!aside.isEmpty()) {
            opened = Ledger::open(place);
            m_problem = Message{.severity = Severity::attention,
                                .id = MessageId::databasePutAside,
                                .arguments = {place.name, aside}};
        }
    }
    if (opened)
        m_ledger = std::move(*opened);
    else
        failed(opened.error());
}

// What is in memory alone goes on being counted.
void LedgerKeeper::failed(const DatabaseError &error)
{
    if (m_place.inMemory && m_ledger)
        return;
    m_problem = Message{.at = m_bus.latest().at,
                        .severity = Severity::attention,
                        .id = MessageId::notKept,
                        .arguments = {m_place.name, error.reason}};
    const bool isOpen = m_ledger.has_value();
    m_place = DatabasePlace::memory();
    auto memory = Ledger::open(m_place);
    m_ledger.reset();
    if (memory) // else the driver is missing: each session counts for itself
        m_ledger = std::move(*memory);
    for (auto &[place, watched] : m_watched) {
        watched.job.reset();
        watched.unassigned.clear();
    }
    if (isOpen)
        Q_EMIT messaged(*m_problem);
}

void LedgerKeeper::setProject(const QString &file)
{
    if (m_project == file)
        return;
    m_project = file;
    for (const auto &[place, watched] : m_watched)
        identify(place);
}

void LedgerKeeper::setLabel(DeviceNumber place, const QString &serialNumber)
{
    QString &label = m_labels[place];
    if (std::exchange(label, serialNumber.trimmed()) != label)
        identify(place);
}

void LedgerKeeper::watchAll()
{
    const auto before = std::exchange(m_watched, {});
    for (const auto &[place, watched] : before)
        if (watched.encoder)
            watched.encoder->disconnect(this);
    for (const DeviceNumber place : m_bus.numbers()) {
        watch(place);
        const auto same = before.find(place);
        if (same != before.end() && same->second.encoder && same->second.encoder == m_watched[place].encoder)
            m_watched[place].job = same->second.job; // the session was kept, with its job
    }
}

void LedgerKeeper::watch(DeviceNumber place)
{
    EncoderSession *encoder = m_bus.encoder(place);
    m_watched[place] = {.encoder = encoder, .identity = {}, .job = {}, .unassigned = {}};
    if (encoder == nullptr)
        return;
    m_watched[place].identity = identity(place);
    connect(encoder, &EncoderSession::jobAboutToStart, this,
            [this, place](const Job &job) { begin(place, job); });
    connect(encoder, &EncoderSession::eepromWritten, this,
            [this, place](int writes) { count(place, writes); });
    connect(encoder, &EncoderSession::finished, this,
            [this, place](const Outcome &outcome) { settle(place, outcome); });
    connect(encoder, &EncoderSession::knownChanged, this, [this, place] { identify(place); });
    showCount(place);
}

EncoderIdentity LedgerKeeper::identity(DeviceNumber place) const
{
    EncoderIdentity identity{
        .by = CountedBy::place, .vendor = {}, .serialNumber = {}, .project = m_project, .place = place};
    const EncoderSession *encoder = m_bus.encoder(place);
    if (encoder == nullptr)
        return identity;
    identity.vendor = encoder->device().vendor;
    const auto serial = encoder->known(Parameter::serialNumber);
    if (serial && serial->evidence == Evidence::read) {
        identity.by = CountedBy::serialNumber;
        identity.serialNumber = QString::number(serial->value);
    } else if (const auto label = m_labels.find(place); label != m_labels.end() && !label->second.isEmpty()) {
        identity.by = CountedBy::labelSerialNumber;
        identity.serialNumber = label->second;
    }
    return identity;
}

void LedgerKeeper::identify(DeviceNumber place)
{
    const auto found = m_watched.find(place);
    if (found == m_watched.end() || !found->second.encoder || !m_ledger)
        return;
    Watched &watched = found->second;
    const EncoderIdentity now = identity(place);
    const EncoderIdentity before = std::exchange(watched.identity, now);
    if (now.key() == before.key() && now.by == before.by)
        return;
    if (before.by == CountedBy::serialNumber)
        watched.unassigned.clear(); // from now on it may be another encoder
    if (now.by != CountedBy::place && !watched.unassigned.empty()) {
        if (auto done = m_ledger->attribute(watched.unassigned, now); !done)
            failed(done.error());
        if (now.by == CountedBy::serialNumber)
            watched.unassigned.clear();
    }
    showCount(place);
}

Ledger::Entry LedgerKeeper::entryAt(const Watched &watched) const
{
    Ledger::Entry entry{.at = m_bus.dateTime(m_bus.latest().at).toUTC(),
                        .identity = watched.identity.key(),
                        .by = watched.identity.by,
                        .place = watched.identity.place,
                        .device = watched.encoder->device().key};
    for (const ParameterDescription &parameter : watched.encoder->device().parameters)
        if (const auto known = watched.encoder->known(parameter.parameter); known && parameter.canBeWritten())
            entry.before.push_back({known->parameter, known->value, known->evidence,
                                    watched.encoder->dateTime(known->at).toUTC()});
    return entry;
}

void LedgerKeeper::note(Watched &watched, qint64 id)
{
    if (watched.identity.by != CountedBy::serialNumber)
        watched.unassigned.push_back(id);
}

void LedgerKeeper::begin(DeviceNumber place, const Job &job)
{
    Watched &watched = m_watched[place];
    const int planned = watched.encoder && m_ledger ? mostEepromWrites(*watched.encoder, job) : 0;
    if (planned == 0)
        return;
    Ledger::Entry entry = entryAt(watched);
    entry.planned = planned;
    auto id = m_ledger->begin(entry);
    if (!id) {
        failed(id.error());
        if (m_ledger)
            id = m_ledger->begin(entry);
    }
    if (!id)
        return;
    watched.job = *id;
    note(watched, *id);
}

// What a job writes is part of it; all else are words by hand.
void LedgerKeeper::count(DeviceNumber place, int writes)
{
    Watched &watched = m_watched[place];
    if (!watched.encoder || !m_ledger)
        return;
    const int before = watched.encoder->eepromCount().atMost();
    if (watched.job)
        if (auto counted = m_ledger->count(*watched.job, writes); !counted)
            failed(counted.error()); // and forgets the job
    if (!watched.job && m_ledger) {
        Ledger::Entry entry = entryAt(watched);
        entry.planned = writes;
        entry.writes = writes;
        entry.settled = true;
        entry.before.clear(); // the words are on the wire already: it may be what they wrote
        const auto id = m_ledger->begin(entry);
        if (id)
            note(watched, *id);
        else
            failed(id.error());
    }
    showCount(place);
    warn(place, before);
}

void LedgerKeeper::settle(DeviceNumber place, const Outcome &outcome)
{
    Watched &watched = m_watched[place];
    const auto job = std::exchange(watched.job, std::nullopt);
    if (!job || !m_ledger)
        return;
    if (auto settled = m_ledger->settle(*job, outcome.written); !settled)
        failed(settled.error());
    showCount(place);
}

// While a job runs, what it may still write is no doubt of the past.
void LedgerKeeper::showCount(DeviceNumber place)
{
    const Watched &watched = m_watched[place];
    if (!watched.encoder || !m_ledger)
        return;
    watched.encoder->setEepromCount(m_ledger->writes(watched.identity, watched.job));
}

void LedgerKeeper::warn(DeviceNumber place, int before)
{
    const EncoderSession &encoder = *m_watched[place].encoder;
    const auto budget = encoder.can().eepromBudget;
    if (!budget)
        return;
    const int now = encoder.eepromCount().atMost();
    const auto passed = [&](int mark) { return before < mark && now >= mark; };
    const auto tell = [&](MessageId id) {
        Q_EMIT messaged({.at = m_bus.latest().at,
                         .place = place,
                         .severity = Severity::attention,
                         .id = id,
                         .arguments = {std::int64_t{now}, std::int64_t{*budget}}});
    };
    if (passed(*budget))
        tell(MessageId::eepromBudgetUsed);
    else if (passed((3 * *budget + 3) / 4))
        tell(MessageId::eepromThreeQuarters);
}

} // namespace codewheel
