// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/ledger_keeper.h"

#include "catalog/device_description.h"
#include "journal/eeprom_cost.h"

#include <algorithm>
#include <utility>

namespace codewheel {
namespace {

// The earlier of both, if `more` counts anything.
void countSince(EepromCount &count, const EepromCount &more)
{
    if (more.atMost() > 0 && (!count.since.isValid() || more.since < count.since))
        count.since = more.since;
}

} // namespace

LedgerKeeper::LedgerKeeper(EncoderBus &bus, const DatabasePlace &place, QObject *parent)
    : QObject(parent)
    , m_bus(bus)
    , m_book(std::make_shared<SafeLedger>(place))
{
    listenToBook();
    watchBus();
}

LedgerKeeper::LedgerKeeper(EncoderBus &bus, const LedgerKeeper &other, QObject *parent)
    : QObject(parent)
    , m_bus(bus)
    , m_book(other.m_book)
{
    watchBus();
}

LedgerKeeper::~LedgerKeeper()
{
    for (auto &[place, watched] : m_watched)
        if (watched.byHand && watched.encoder && standsStill(place, *watched.encoder))
            settleByHand(place, watched);
}

// What was reported while it was opened is for whoever calls problem(): nobody is listening yet.
void LedgerKeeper::listenToBook()
{
    m_problem = m_book->problem();
    m_book->onProblem([keeper = QPointer(this)] {
        if (keeper == nullptr)
            return;
        keeper->m_problem = keeper->m_book->problem();
        keeper->m_problem->at = keeper->m_bus.now();
        Q_EMIT keeper->messaged(*keeper->m_problem);
    });
}

void LedgerKeeper::watchBus()
{
    connect(&m_bus, &EncoderBus::nodesChanged, this, &LedgerKeeper::watchDevices);
    connect(&m_bus, &EncoderBus::structureChanged, this, &LedgerKeeper::doubtUnassigned);
    connect(&m_bus, &EncoderBus::meetsAgain, this, &LedgerKeeper::meetAgain);
    connect(&m_bus, &EncoderBus::replaced, this, &LedgerKeeper::leaveToPrevious);
    connect(&m_bus, &EncoderBus::named, this, &LedgerKeeper::watchNamed);
    connect(&m_bus, &EncoderBus::moved, this, &LedgerKeeper::move);
    connect(&m_bus, &EncoderBus::updated, this, qOverload<>(&LedgerKeeper::settleByHand));
    connect(&m_bus, &EncoderBus::writeAboutToBeSent, this, &LedgerKeeper::beginTyped);
    connect(&m_bus, &EncoderBus::typedWriteEnded, this, &LedgerKeeper::settleTyped);
    watchDevices();
}

void LedgerKeeper::setProject(const QString &file)
{
    const QString now = ledgerProject(file);
    if (std::exchange(m_project, now) == now)
        return;
    for (const auto &[place, watched] : m_watched)
        identify(place);
}

void LedgerKeeper::projectSavedAs(const QString &file)
{
    const QString from = std::exchange(m_project, ledgerProject(file));
    if (from == m_project)
        return;
    takeAlong(from);
    for (const auto &[place, watched] : m_watched)
        identify(place);
}

// What was counted while there was no file belongs to the first one, also from before this connection. An
// account in a file carries on there, and is copied; an entry that has not ended can exist only once.
void LedgerKeeper::takeAlong(const QString &from)
{
    std::vector<qint64> without;
    for (const auto &[place, ids] : onTheirWay()) {
        without.insert(without.end(), ids.begin(), ids.end());
        m_book->attribute(ids, identity(place));
    }
    m_book->carryPlaces(from, m_project, m_bus.id(), without);
}

// Entries counted by their place that have not ended.
std::map<Place, std::vector<qint64>> LedgerKeeper::onTheirWay() const
{
    std::map<Place, std::vector<qint64>> entries;
    for (const auto &[place, watched] : m_watched) {
        if (watched.identity.by != CountedBy::place)
            continue;
        if (watched.job)
            entries[place].push_back(*watched.job);
        if (watched.byHand)
            entries[place].push_back(watched.byHand->id);
    }
    for (const auto &[place, requests] : m_strangers)
        for (const ToStranger &request : requests)
            entries[place].push_back(request.id);
    return entries;
}

void LedgerKeeper::setLabel(Place place, const QString &serialNumber)
{
    Label &label = m_labels[place];
    const Label before = std::exchange(label, {.serialNumber = serialNumber.trimmed(), .project = m_project});
    if (before.serialNumber == label.serialNumber) {
        label.isOfPrevious = before.isOfPrevious;
        return;
    }
    identify(place);
    const auto found = m_watched.find(place);
    const bool isTakenBack = before.project == m_project && !before.serialNumber.isEmpty();
    if (found != m_watched.end() && isTakenBack && found->second.identity.by == CountedBy::place) {
        attribute(found->second);
        showCount(place);
    }
}

// Devices were added or removed, or have other sessions; the others are unchanged.
void LedgerKeeper::watchDevices()
{
    const std::vector<Place> there = m_bus.places();
    std::erase_if(m_watched, [&](const auto &entry) {
        const auto &[place, watched] = entry;
        const bool stays =
            std::ranges::find(there, place) != there.end() && watched.encoder == m_bus.encoder(place);
        if (!stays && watched.encoder)
            watched.encoder->disconnect(this);
        return !stays;
    });
    for (const Place place : there)
        if (!m_watched.contains(place))
            watch(place);
}

void LedgerKeeper::watchNamed(Place place)
{
    const Watched before = m_watched[place];
    if (before.encoder)
        before.encoder->disconnect(this);
    watch(place);
    m_watched[place].unassigned = before.unassigned;
    m_watched[place].byHand = before.byHand;
    showCount(place);
}

void LedgerKeeper::doubtUnassigned()
{
    for (auto &[place, watched] : m_watched) {
        watched.unassigned.clear();
        watched.beforeItMet.clear();
    }
}

// Another encoder is at the place: what was written there so far was written to the one before.
void LedgerKeeper::leaveToPrevious(Place place)
{
    if (const auto found = m_watched.find(place); found != m_watched.end()) {
        found->second.unassigned.clear();
        found->second.beforeItMet.clear();
        found->second.doubtful.reset();
    }
}

// Whoever is there now need not be the one that was written to.
void LedgerKeeper::meetAgain()
{
    for (auto &[place, watched] : m_watched) {
        watched.beforeItMet.insert(watched.beforeItMet.end(), watched.unassigned.begin(),
                                   watched.unassigned.end());
        watched.unassigned.clear();
    }
}

void LedgerKeeper::isSame(Place place)
{
    Watched &watched = m_watched[place];
    watched.unassigned.insert(watched.unassigned.begin(), watched.beforeItMet.begin(),
                              watched.beforeItMet.end());
    watched.beforeItMet.clear();
    if (watched.identity.by != CountedBy::place)
        attribute(watched);
}

// What was in doubt about the first stays so.
void LedgerKeeper::isAnother(Place place)
{
    Watched &watched = m_watched[place];
    watched.beforeItMet.clear();
    watched.doubtful.reset();
    leaveCountToPrevious(place);
}

// What the place and the label say is about the previous one; not what was written since the new one is
// there.
void LedgerKeeper::leaveCountToPrevious(Place place)
{
    if (ledger() == nullptr)
        return;
    Watched &watched = m_watched[place];
    EepromCount count = ledger()->writes(ofPlace(place));
    for (const qint64 id : watched.unassigned)
        if (const auto record = ledger()->record(id); record && record->entry.by == CountedBy::place) {
            count.writes -= record->entry.writes;
            count.perhaps -= record->entry.perhaps();
        }
    m_toPrevious[place] = {.project = m_project, .count = count};
    if (const auto label = m_labels.find(place); label != m_labels.end())
        label->second.isOfPrevious = true;
    identify(place);
    if (watched.identity.by == CountedBy::place)
        attribute(watched);
}

// What was counted by its place since the connection was made goes along.
void LedgerKeeper::move(Place from, Place to)
{
    auto node = m_watched.extract(from);
    if (!node || !node.mapped().encoder)
        return;
    const Watched before = node.mapped();
    before.encoder->disconnect(this);
    watch(to);
    Watched &watched = m_watched[to];
    watched.job = before.job;
    watched.progress = before.progress;
    watched.byHand = before.byHand;
    watched.unassigned = before.unassigned;
    if (watched.identity.by == CountedBy::place)
        attribute(watched);
    showCount(to);
}

void LedgerKeeper::watch(Place place)
{
    EncoderSession *encoder = m_bus.encoder(place);
    m_watched[place] = {.encoder = encoder, .identity = {}};
    if (encoder == nullptr)
        return;
    m_watched[place].identity = identity(place);
    noteWhatWasToStranger(place);
    connect(encoder, &EncoderSession::jobAboutToStart, this,
            [this, place](const Job &job) { begin(place, job); });
    connect(encoder, &EncoderSession::progressed, this, [this, place](const Progress &progress) {
        Progress &last = m_watched[place].progress;
        const bool waited = std::exchange(last, progress).waitsForUser;
        if (waited != progress.waitsForUser)
            showCount(place);
    });
    connect(encoder, &EncoderSession::wordAboutToBeSent, this,
            [this, place](Word word) { beginByHand(place, word); });
    connect(encoder, &EncoderSession::restoreAboutToStart, this, [this, place] { planToRestore(place); });
    connect(encoder, &EncoderSession::eepromWritten, this,
            [this, place](int writes) { count(place, writes); });
    connect(encoder, &EncoderSession::finished, this,
            [this, place](const Outcome &outcome) { settle(place, outcome); });
    connect(encoder, &EncoderSession::knownChanged, this, [this, place] {
        settleDoubtful(place);
        identify(place);
    });
    connect(encoder, &EncoderSession::isSameAsBefore, this, [this, place] { isSame(place); });
    connect(encoder, &EncoderSession::isAnotherThanBefore, this, [this, place] { isAnother(place); });
    connect(encoder, &EncoderSession::knownBeforeChanged, this, [this, place] { showCount(place); });
    showCount(place);
}

EncoderIdentity LedgerKeeper::identity(Place place) const
{
    EncoderIdentity identity = ofPlace(place);
    const EncoderSession *encoder = m_bus.encoder(place);
    if (encoder == nullptr)
        return identity;
    identity.vendor = encoder->device().vendor;
    if (const auto serial = reportedSerialNumber(*encoder)) {
        identity.by = CountedBy::serialNumber;
        identity.serialNumber = QString::number(*serial);
    } else if (const auto label = m_labels.find(place); label != m_labels.end() &&
                                                        !label->second.serialNumber.isEmpty() &&
                                                        !label->second.isOfPrevious) {
        identity.by = CountedBy::labelSerialNumber;
        identity.serialNumber = label->second.serialNumber;
    }
    return identity;
}

void LedgerKeeper::identify(Place place)
{
    const auto found = m_watched.find(place);
    if (found == m_watched.end() || !found->second.encoder || ledger() == nullptr)
        return;
    Watched &watched = found->second;
    const EncoderIdentity now = identity(place);
    const EncoderIdentity before = std::exchange(watched.identity, now);
    if (now.key() == before.key() && now.by == before.by)
        return;
    tellOtherSerialNumber(place, now);
    if (before.by == CountedBy::serialNumber)
        watched.unassigned.clear(); // from now on it may be another encoder
    if (now.by != CountedBy::place)
        attribute(watched);
    showCount(place);
}

// A label may yet be corrected; a serial number that was read cannot be.
void LedgerKeeper::attribute(Watched &watched)
{
    if (watched.unassigned.empty())
        return;
    m_book->attribute(watched.unassigned, watched.identity);
    if (watched.identity.by == CountedBy::serialNumber)
        watched.unassigned.clear();
}

// Of the label it was typed; what is no decimal number is not compared.
void LedgerKeeper::tellOtherSerialNumber(Place place, const EncoderIdentity &reported)
{
    const auto label = m_labels.find(place);
    bool isNumber = false;
    const qulonglong typed = label == m_labels.end() ? 0 : label->second.serialNumber.toULongLong(&isNumber);
    if (reported.by != CountedBy::serialNumber || !isNumber || typed == reported.serialNumber.toULongLong())
        return;
    Q_EMIT messaged({.at = m_bus.now(),
                     .place = place,
                     .severity = Severity::attention,
                     .id = MessageId::serialNumberDiffers,
                     .arguments = {label->second.serialNumber, reported.serialNumber}});
}

Ledger::Entry LedgerKeeper::entryAt(const Watched &watched) const
{
    Ledger::Entry entry{.at = m_bus.dateTime(m_bus.now()).toUTC(),
                        .identity = watched.identity.key(),
                        .by = watched.identity.by,
                        .place = watched.identity.place,
                        .device = watched.encoder->device().key};
    for (const ParameterDescription &parameter : watched.encoder->device().parameters)
        if (const auto known = watched.encoder->known(parameter.parameter); known && parameter.canBeWritten)
            entry.before.push_back({known->parameter, known->value, known->evidence,
                                    watched.encoder->dateTime(known->at).toUTC()});
    return entry;
}

void LedgerKeeper::note(Watched &watched, qint64 id)
{
    if (watched.identity.by != CountedBy::serialNumber)
        watched.unassigned.push_back(id);
}

void LedgerKeeper::begin(Place place, const Job &job)
{
    Watched &watched = m_watched[place];
    const int planned = watched.encoder && ledger() ? mostEepromWrites(*watched.encoder, job) : 0;
    watched.progress = {};
    if (planned > 0)
        watched.job = beginEntry(watched, planned);
}

std::optional<qint64> LedgerKeeper::beginEntry(Watched &watched, int planned)
{
    Ledger::Entry entry = entryAt(watched);
    entry.planned = planned;
    const auto id = m_book->begin(entry);
    if (id)
        note(watched, *id);
    return id;
}

// In addition to what the job was to write.
void LedgerKeeper::planToRestore(Place place)
{
    const Watched &watched = m_watched[place];
    const int more = watched.encoder ? mostWritesToRestore(*watched.encoder, watched.progress) : 0;
    if (watched.job && more > 0)
        m_book->plan(*watched.job, more);
}

// What a job writes is part of it; all the rest are words sent by hand.
void LedgerKeeper::count(Place place, int writes)
{
    Watched &watched = m_watched[place];
    if (!watched.encoder || ledger() == nullptr)
        return;
    watched.doubtful.reset(); // what was in doubt may have been stored along, so that this counts it already
    const int before = watched.encoder->eepromCount().atMost();
    const auto noted = watched.job      ? watched.job
                       : watched.byHand ? std::optional(watched.byHand->id)
                                        : std::nullopt;
    if (noted) {
        m_book->count(*noted, writes);
        if (!watched.job)
            watched.byHand->counted += writes;
    } else {
        Ledger::Entry entry = entryAt(watched);
        entry.planned = writes;
        entry.writes = writes;
        entry.settled = true;
        entry.before.clear(); // the words are already on the wire: it may be what they wrote
        if (const auto id = m_book->begin(entry))
            note(watched, *id);
    }
    showCount(place);
    warn(place, before);
}

// A job that was not to write anything may have left something to be stored.
std::optional<qint64> LedgerKeeper::beginDoubtful(Watched &watched, int perhaps)
{
    return perhaps > 0 && watched.encoder && ledger() ? beginEntry(watched, perhaps) : std::nullopt;
}

void LedgerKeeper::settle(Place place, const Outcome &outcome)
{
    Watched &watched = m_watched[place];
    auto job = std::exchange(watched.job, std::nullopt);
    if (!job)
        job = beginDoubtful(watched, outcome.inDoubt.eepromWrites);
    if (!job)
        return;
    std::vector<Ledger::Value> read;
    if (watched.encoder)
        for (const ParameterValue &value : outcome.read)
            if (const auto *known = watched.encoder->device().find(value.parameter);
                known && known->canBeWritten)
                read.push_back(
                    {value.parameter, value.value, Evidence::read, m_bus.dateTime(m_bus.now()).toUTC()});
    m_book->settle(*job, outcome.written, read, outcome.inDoubt.eepromWrites);
    if (outcome.inDoubt.eepromWrites > 0 && !outcome.inDoubt.uncounted.empty())
        watched.doubtful = {*job, outcome, m_bus.now()};
    settleDoubtful(place);
    showCount(place);
}

// Once all that was in doubt has been read. An encoder that is not in operation may have confirmed and stored
// a value that reads as before until it runs. Of other writes in doubt no value tells.
void LedgerKeeper::settleDoubtful(Place place)
{
    Watched &watched = m_watched[place];
    if (!watched.doubtful || !watched.encoder || watched.encoder->knownBefore())
        return;
    const Doubtful &job = *watched.doubtful;
    const InDoubt &doubt = job.outcome.inDoubt;
    ParameterValues written = job.outcome.written;
    int writes = 0;
    for (const ParameterValue &value : doubt.values) {
        const auto known = watched.encoder->known(value.parameter);
        if (!known || known->evidence != Evidence::read || known->at <= job.at)
            return;
        if (known->value != value.value && watched.encoder->latest().state != EncoderState::operation)
            return;
        if (known->value != value.value)
            continue;
        replaceValue(written, value);
        writes += std::ranges::count(doubt.uncounted, value.parameter) > 0 ? 1 : 0;
    }
    const int ofOthers = std::max(doubt.eepromWrites - static_cast<int>(doubt.uncounted.size()), 0);
    m_book->count(job.id, std::min(writes, doubt.eepromWrites));
    m_book->settle(job.id, written, {}, ofOthers);
    watched.doubtful.reset();
    showCount(place);
}

// While a job is under way, what it may still write is no doubt about the past. What stands in OUT, by hand
// or since a job that has sent a value waits for the user, may have been written.
void LedgerKeeper::showCount(Place place)
{
    const Watched &watched = m_watched[place];
    if (!watched.encoder || ledger() == nullptr)
        return;
    std::vector<qint64> running;
    if (watched.job && !(watched.progress.waitsForUser && watched.progress.hasTaken))
        running.push_back(*watched.job);
    if (watched.byHand && watched.byHand->awaited > 0)
        running.push_back(watched.byHand->id);
    EepromCount count = ledger()->writes(watched.identity, running);
    if (count.by != CountedBy::place) {
        addDoubtOfPlace(count, place);
    } else {
        doubtWhatWasToPrevious(count, place);
        addDoubtOfQuestion(count, *watched.encoder);
    }
    watched.encoder->setEepromCount(count);
}

// What was counted by the place before its serial number was known may have been written to this encoder.
void LedgerKeeper::addDoubtOfPlace(EepromCount &count, Place place) const
{
    const EepromCount there = ledger()->writes(ofPlace(place));
    count.atPlace = there.atMost() + writesBeforeItMet(place);
    countSince(count, there);
}

// The user says that it was another encoder, but nothing proves that.
void LedgerKeeper::doubtWhatWasToPrevious(EepromCount &count, Place place) const
{
    const auto previous = m_toPrevious.find(place);
    if (previous == m_toPrevious.end() || previous->second.project != m_project)
        return;
    const EepromCount &its = previous->second.count;
    const int writes = std::min(its.writes, count.writes);
    const int perhaps = std::min(its.perhaps, count.perhaps);
    count.writes -= writes;
    count.perhaps -= perhaps;
    count.atPlace = writes + perhaps;
}

// While it is asked whether it is the one with that serial number.
void LedgerKeeper::addDoubtOfQuestion(EepromCount &count, const EncoderSession &encoder) const
{
    const auto &before = encoder.knownBefore();
    if (!before || !before->serialNumber)
        return;
    const EepromCount its = ledger()->writes({.by = CountedBy::serialNumber,
                                              .vendor = encoder.device().vendor,
                                              .serialNumber = QString::number(*before->serialNumber),
                                              .project = {},
                                              .place = {}});
    count.perhaps += its.atMost();
    countSince(count, its);
}

// As long as nobody has said whether it is the same encoder. What stands under the place as it is called now
// is counted there.
int LedgerKeeper::writesBeforeItMet(Place place) const
{
    const QString now = ofPlace(place).key();
    int most = 0;
    for (const qint64 id : m_watched.at(place).beforeItMet)
        if (const auto record = ledger()->record(id);
            record && record->entry.by == CountedBy::place && record->entry.identity != now)
            most += record->entry.writes + record->entry.perhaps();
    return most;
}

void LedgerKeeper::warn(Place place, int before)
{
    const EncoderSession &encoder = *m_watched[place].encoder;
    const auto budget = encoder.can().eepromBudget;
    if (!budget)
        return;
    const int now = encoder.eepromCount().atMost();
    const auto passed = [&](int mark) { return before < mark && now >= mark; };
    const auto tell = [&](MessageCode id) {
        Q_EMIT messaged({.at = m_bus.now(),
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
