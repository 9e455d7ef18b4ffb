// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/safe_ledger.h"

#include "journal/journal_texts.h"
#include "project/folder_lock.h"

#include <QFileInfo>

namespace codewheel {

SafeLedger::SafeLedger(const DatabasePlace &place)
    : m_place(place)
{
    open();
}

// A damaged file is put aside and another one begun; with any other fault the file stays as it is.
void SafeLedger::open()
{
    auto opened = Ledger::open(m_place);
    if (!opened && opened.error().kind == DatabaseError::Kind::broken) {
        const FolderLock lock(m_place.name);
        opened = Ledger::open(m_place); // another program may have done so
        const bool isDamaged = !opened && opened.error().kind == DatabaseError::Kind::broken;
        if (const QString aside = isDamaged ? putAside(m_place.name) : QString(); !aside.isEmpty()) {
            opened = Ledger::open(m_place);
            tell(MessageId::databasePutAside, {m_place.name, aside});
        }
    }
    const bool isOurs = opened || opened.error().kind != DatabaseError::Kind::foreign;
    if (!m_place.inMemory && isOurs && Database::isAvailable())
        m_waiting = std::make_unique<WaitingEntries>(m_place.name);
    if (opened)
        m_ledger = std::move(*opened);
    else
        goOnInMemory(opened.error());
}

// Counts stay available and go on.
void SafeLedger::goOnInMemory(const DatabaseError &why)
{
    const bool canBeRead = m_ledger && why.kind != DatabaseError::Kind::locked;
    const auto past = canBeRead ? m_ledger->records().value_or(std::vector<Ledger::Record>())
                                : std::vector<Ledger::Record>();
    m_ledger.reset();
    m_isInMemory = true;
    if (auto memory = Ledger::open(DatabasePlace::memory())) { // otherwise the driver is missing
        (void)memory->copy(past);
        for (const auto &[id, record] : m_begun)
            (void)memory->copy({record});
        m_ledger = std::move(*memory);
    }
    if (m_waiting && m_waiting->isThere())
        tell(MessageId::keptBeside, {m_place.name, why.reason, m_waiting->path()});
    else
        tell(MessageId::notKept, {m_place.name, why.reason});
}

void SafeLedger::tell(MessageCode id, std::vector<RefusalArgument> arguments)
{
    m_problem = Message{.severity = Severity::attention, .id = id, .arguments = std::move(arguments)};
    if (m_told)
        m_told();
}

// What the file refuses is done in memory; requires a ledger.
template <typename What>
auto SafeLedger::safely(What what)
{
    auto done = what(*m_ledger);
    if (!done && !m_isInMemory && !m_place.inMemory) {
        goOnInMemory(done.error());
        if (m_ledger)
            done = what(*m_ledger);
    }
    return done;
}

// As it is now.
void SafeLedger::remember(qint64 id)
{
    if (m_place.inMemory || !m_ledger)
        return;
    const auto now = m_ledger->record(id);
    if (!now)
        return;
    if (m_isInMemory)
        keepBeside(*now);
    m_begun.insert_or_assign(id, *now);
}

void SafeLedger::keepBeside(const Ledger::Record &record)
{
    m_hasUncounted = true;
    if (m_waiting && m_waiting->isThere() && !m_waiting->add(record)) { // it has taken all there was room for
        const QString file = m_waiting->path();
        m_waiting.reset();
        tell(MessageId::notKept, {file, Journal::tr("the disk is full.")});
    }
}

std::optional<qint64> SafeLedger::begin(const Ledger::Entry &entry)
{
    if (!m_ledger)
        return std::nullopt;
    const auto id = safely([&](Ledger &ledger) { return ledger.begin(entry); });
    if (!id)
        return std::nullopt;
    remember(*id);
    return *id;
}

void SafeLedger::count(qint64 id, int writes)
{
    if (m_ledger)
        (void)safely([&](Ledger &ledger) { return ledger.count(id, writes); });
    remember(id);
}

void SafeLedger::plan(qint64 id, int more)
{
    if (m_ledger)
        (void)safely([&](Ledger &ledger) { return ledger.plan(id, more); });
    remember(id);
}

void SafeLedger::settle(qint64 id, const ParameterValues &written,
                        const std::vector<Ledger::Value> &readBefore, int perhaps)
{
    if (m_ledger)
        (void)safely([&](Ledger &ledger) { return ledger.settle(id, written, readBefore, perhaps); });
    remember(id);
}

void SafeLedger::attribute(const std::vector<qint64> &ids, const EncoderIdentity &identity)
{
    if (m_ledger)
        (void)safely([&](Ledger &ledger) { return ledger.attribute(ids, identity); });
    for (const qint64 id : ids)
        remember(id);
}

void SafeLedger::carryPlaces(const QString &from, const QString &to, BusId bus,
                             const std::vector<qint64> &without)
{
    if (m_ledger)
        (void)safely([&](Ledger &ledger) {
            return from.isEmpty() ? ledger.movePlaces(to, bus) : ledger.copyPlaces(from, to, bus, without);
        });
}

} // namespace codewheel
