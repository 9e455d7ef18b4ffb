// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/message_store.h"

#include <QFileInfo>

#include <algorithm>

namespace codewheel {
namespace {

constexpr std::size_t largestBatch = 5'000;    // one transaction
constexpr qint64 takenAlong = 10'000;          // messages, if the file fails
constexpr qint64 largestInMemory = 50'000'000; // bytes
constexpr qint64 droppedAtOnce = 5'000; // messages per transaction, so that other programs get their turn

} // namespace

MessageStore::MessageStore(Settings settings)
    : m_settings(std::move(settings))
    , m_thread([this](const std::stop_token &stop) { run(stop); })
{}

MessageStore::~MessageStore()
{
    m_thread.request_stop();
    m_thread.join();
}

void MessageStore::add(const Message &message, const QDateTime &at)
{
    StoredMessage stored = storedMessage(message, at);
    const std::lock_guard lock(m_mutex);
    m_waiting.push_back(std::move(stored));
    m_urgent = m_urgent || message.severity == Severity::fault;
    ++m_addedCount;
    m_added.notify_one();
}

void MessageStore::flush()
{
    std::unique_lock lock(m_mutex);
    m_urgent = true;
    m_added.notify_one();
    m_committed.wait(lock, [this, wanted = m_addedCount] { return m_committedCount >= wanted && m_place; });
}

std::optional<DatabasePlace> MessageStore::place() const
{
    const std::lock_guard lock(m_mutex);
    return m_place;
}

void MessageStore::reportBroken(const DatabasePlace &place, const DatabaseError &error)
{
    const std::lock_guard lock(m_mutex);
    if (m_place != place || place.inMemory)
        return;
    m_reported = error;
    m_urgent = true;
    m_added.notify_one();
}

void MessageStore::run(const std::stop_token &stop)
{
    open();
    while (true) {
        Batch batch = nextBatch(stop);
        std::optional<DatabaseError> reported;
        {
            const std::lock_guard lock(m_mutex);
            reported = std::exchange(m_reported, std::nullopt);
        }
        if (reported)
            failed(*reported);
        const std::size_t count = batch.size();
        if (count > 0) {
            write(batch);
            dropOldest();
        }
        const std::lock_guard lock(m_mutex);
        m_committedCount += count;
        m_committed.notify_all();
        if (stop.stop_requested() && m_waiting.empty())
            break;
    }
    m_table.reset();
}

// Waits for a message, and then a little for more.
MessageStore::Batch MessageStore::nextBatch(const std::stop_token &stop)
{
    std::unique_lock lock(m_mutex);
    m_added.wait(lock, stop, [this] { return !m_waiting.empty() || m_reported || m_urgent; });
    m_added.wait_for(lock, stop, gathering, [this] { return m_urgent || m_waiting.size() >= largestBatch; });
    m_urgent = false;
    Batch batch;
    if (m_waiting.size() <= largestBatch) {
        batch.swap(m_waiting);
        return batch;
    }
    const auto end = m_waiting.begin() + largestBatch;
    batch.assign(std::make_move_iterator(m_waiting.begin()), std::make_move_iterator(end));
    m_waiting.erase(m_waiting.begin(), end);
    m_urgent = true;
    return batch;
}

void MessageStore::open()
{
    if (m_settings.file.isEmpty()) {
        openMemory({});
        return;
    }
    if (auto opened = openFile(); !opened)
        failed(opened.error());
}

Stored<void> MessageStore::openFile()
{
    const auto file = DatabasePlace::file(m_settings.file);
    auto table = MessageTable::open(file);
    if (!table)
        return tl::unexpected(table.error());
    m_table = std::move(*table);
    give(file);
    return {};
}

void MessageStore::openMemory(const Batch &newest)
{
    const DatabasePlace memory = DatabasePlace::memory();
    auto table = MessageTable::open(memory);
    m_table.reset();
    if (table) {
        m_table = std::move(*table);
        (void)m_table->copy(newest);
    } else {
        qWarning("codewheel: messages are lost: %s", qUtf8Printable(table.error().reason));
    }
    give(memory);
}

void MessageStore::give(DatabasePlace place)
{
    const std::lock_guard lock(m_mutex);
    m_place = std::move(place);
    m_committed.notify_all();
}

void MessageStore::write(const Batch &batch)
{
    if (!m_table)
        return;
    if (auto written = m_table->append(batch); !written) {
        failed(written.error());
        if (m_table)
            (void)m_table->append(batch);
    }
}

// A damaged file is put aside and another one begun; with any other fault the file stays as it is, and the
// newest messages go on in memory.
void MessageStore::failed(const DatabaseError &error)
{
    Batch newest;
    if (m_table)
        if (const auto span = m_table->span(); span && span->last > 0)
            newest = m_table->read(std::max(span->first, span->last - takenAlong + 1), span->last)
                         .value_or(Batch());
    m_table.reset();
    if (error.kind == DatabaseError::Kind::broken && QFileInfo::exists(m_settings.file)) {
        const QString aside = putAside(m_settings.file);
        if (!aside.isEmpty() && openFile()) {
            tell(MessageId::databasePutAside, Severity::attention, {m_settings.file, aside});
            return;
        }
    }
    openMemory(newest);
    tell(MessageId::notKept, Severity::attention, {m_settings.file, error.reason});
}

void MessageStore::tell(MessageCode id, Severity severity, std::vector<RefusalArgument> arguments)
{
    if (m_table)
        (void)m_table->append(
            {storedMessage({.severity = severity, .id = id, .arguments = std::move(arguments)},
                           QDateTime::currentDateTimeUtc())});
}

void MessageStore::dropOldest()
{
    if (!m_table)
        return;
    const bool inMemory = place().value_or(DatabasePlace()).inMemory;
    const qint64 largest =
        inMemory ? std::min(m_settings.largestSize, largestInMemory) : m_settings.largestSize;
    if (m_table->size() <= largest)
        return;
    const auto span = m_table->span();
    if (!span)
        return;
    const qint64 count = std::max<qint64>((span->last - span->first + 1) / 10, 1);
    qint64 dropped = 0;
    while (dropped < count) {
        const qint64 now = std::min(droppedAtOnce, count - dropped);
        if (const auto done = m_table->dropUpTo(span->first + dropped + now - 1); !done) {
            if (done.error().kind == DatabaseError::Kind::broken)
                failed(done.error());
            return;
        }
        dropped += now;
    }
    tell(MessageId::oldMessagesDropped, Severity::information, {std::int64_t{dropped}});
}

} // namespace codewheel
