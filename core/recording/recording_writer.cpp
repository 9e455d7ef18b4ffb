// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recording_writer.h"

#include "project/folder_lock.h"

#include <QFile>
#include <QFileInfo>

#include <filesystem>
#include <sys/stat.h>

namespace codewheel {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds composing{100}; // so that memory holds what is packed, not what came
constexpr std::int64_t megabyte = 1'000'000;
constexpr int shareForgotten = 20; // of the time, if the file has its largest size
constexpr Instant leastForgotten = std::chrono::seconds(30);

Refusal refusalOf(const QString &file, const DatabaseError &error)
{
    return {RefusalKind::link, RefusalId::databaseFailed, {file, error.reason}};
}

Instant steadyNow()
{
    return std::chrono::duration_cast<Instant>(Clock::now().time_since_epoch());
}

} // namespace

std::int64_t freeBytesAt(const QString &file)
{
    std::error_code error;
    const auto space =
        std::filesystem::space(std::filesystem::path(QFileInfo(file).absolutePath().toStdString()), error);
    return error ? 0 : static_cast<std::int64_t>(space.available);
}

Result<std::unique_ptr<RecordingWriter>> RecordingWriter::begin(const RecordingSettings &settings)
{
    const QString &file = settings.file;
    const FolderLock lock(file);
    if (lock.isRefused())
        return tl::unexpected(refusalOf(file, Database::locked()));
    if (QFileInfo::exists(file) || QFileInfo(file).isSymLink())
        return refuse(RefusalKind::badInput, RefusalId::recordingExists, {file});
    const auto made = RecordingStore::create(file, {.program = settings.program,
                                                    .zone = settings.zone,
                                                    .begun = settings.begun,
                                                    .until = settings.begun});
    if (!made) {
        QFile::remove(file); // half of it
        return tl::unexpected(refusalOf(file, made.error()));
    }
    return std::unique_ptr<RecordingWriter>(new RecordingWriter(settings));
}

RecordingWriter::RecordingWriter(RecordingSettings settings)
    : m_settings(std::move(settings))
    , m_identity(identityOf(m_settings.file))
    , m_since(m_settings.begun)
    , m_thread([this](const std::stop_token &stop) { run(stop); })
{}

RecordingWriter::~RecordingWriter()
{
    (void)RecordingWriter::end();
}

RecordingStatus RecordingWriter::end()
{
    m_thread.request_stop();
    if (m_thread.joinable())
        m_thread.join();
    const std::lock_guard lock(m_mutex);
    m_status.hasEnded = true;
    return m_status;
}

void RecordingWriter::add(RecordingEntry entry)
{
    if (auto *traffic = std::get_if<RecordedTraffic>(&entry))
        traffic->row.meaning = {}; // belongs to the thread of its bus
    const std::lock_guard lock(m_mutex);
    if (m_status.hasEnded || m_waitingBytes + m_keptBytes > m_settings.mostWaiting) {
        lose(entry);
        return;
    }
    if (const auto *values = std::get_if<RecordedValues>(&entry))
        tellLost(values->place);
    put(std::move(entry));
}

void RecordingWriter::put(RecordingEntry entry)
{
    m_waitingBytes += bytesOf(entry);
    m_waiting.push_back(std::move(entry));
    ++m_addedCount;
}

void RecordingWriter::lose(const RecordingEntry &entry)
{
    const std::uint64_t count = valuesOf(entry);
    m_status.lost += count;
    const auto *values = std::get_if<RecordedValues>(&entry);
    const Instant since =
        values != nullptr && !values->values.empty() ? values->values.front().at : m_status.written;
    Lost &lost =
        m_lost.try_emplace(values != nullptr ? values->place : Place(), Lost{since, 0}).first->second;
    lost.count += count;
}

// There is a gap in their place.
void RecordingWriter::tellLost(Place place)
{
    const auto node = m_lost.extract(place);
    if (node.empty())
        return;
    put(RecordedInterruption{place, node.mapped().since});
    put(RecordedLoss{node.mapped().since, {}, node.mapped().count});
}

void RecordingWriter::tellAllLost()
{
    while (!m_lost.empty())
        tellLost(m_lost.begin()->first);
}

void RecordingWriter::flush()
{
    std::unique_lock lock(m_mutex);
    m_mustWrite = true;
    m_added.notify_one();
    m_done.wait(lock, [this, wanted = m_addedCount] {
        return (m_doneCount >= wanted && !m_mustWrite) || m_status.hasEnded;
    });
}

RecordingStatus RecordingWriter::status() const
{
    const std::lock_guard lock(m_mutex);
    return m_status;
}

void RecordingWriter::run(const std::stop_token &stop)
{
    auto lastWrite = Clock::now();
    std::uint64_t taken = 0;
    while (!m_hasEnded) {
        bool mustWrite = false;
        const auto entries = nextEntries(stop, mustWrite);
        for (const RecordingEntry &entry : entries)
            m_composer.add(entry);
        taken += entries.size();
        const bool isStopping = stop.stop_requested();
        if (!mustWrite && !isStopping && Clock::now() - lastWrite < gathering)
            continue;
        commit();
        lastWrite = Clock::now();
        const std::lock_guard lock(m_mutex);
        m_doneCount = taken;
        m_mustWrite = m_mustWrite && !mustWrite;
        m_done.notify_all();
        if (isStopping && m_waiting.empty() && m_lost.empty())
            break;
    }
    if (m_store && !m_hasEnded)
        (void)m_store->end(status().written);
    m_store.reset();
}

std::vector<RecordingEntry> RecordingWriter::nextEntries(const std::stop_token &stop, bool &mustWrite)
{
    std::unique_lock lock(m_mutex);
    m_added.wait_for(lock, stop, composing, [this] { return m_mustWrite; });
    mustWrite = m_mustWrite;
    if (stop.stop_requested())
        tellAllLost();
    m_waitingBytes = 0;
    return std::exchange(m_waiting, {});
}

void RecordingWriter::commit()
{
    const RecordingChanges &changes = m_composer.gathered();
    if (changes.isEmpty())
        return;
    std::optional<Refusal> problem = obstacle();
    if (!problem && !m_hasEnded) {
        const auto written = m_store->write(changes).and_then([&] { return keepLimits(changes.until); });
        if (!written) {
            problem = refusalOf(m_settings.file, written.error());
            m_hasEnded = written.error().kind == DatabaseError::Kind::broken;
        }
    }
    tell(changes, problem, m_hasEnded);
    if (!problem)
        m_composer.forgetWritten();
}

// Why it need not even be tried.
std::optional<Refusal> RecordingWriter::obstacle()
{
    if (identityOf(m_settings.file) != m_identity) {
        m_hasEnded = true;
        return Refusal{RefusalKind::link, RefusalId::recordingGone, {m_settings.file}};
    }
    const std::int64_t free = freeBytesAt(m_settings.file);
    if (free < m_settings.leastFree)
        return Refusal{RefusalKind::link,
                       RefusalId::diskAlmostFull,
                       {m_settings.file, free / megabyte, m_settings.leastFree / megabyte}};
    if (m_store)
        return {};
    auto store = RecordingStore::open(m_settings.file); // also again, where another program had locked it
    if (!store)
        return refusalOf(m_settings.file, store.error());
    m_store = std::move(*store);
    return {};
}

// The room of what is forgotten is used again, so the file stays as large as it is.
Stored<void> RecordingWriter::keepLimits(Instant until)
{
    Instant from = m_since;
    if (m_settings.keptFor > Instant(0) && until - m_since > m_settings.keptFor + leastForgotten)
        from = until - m_settings.keptFor;
    if (m_settings.largestSize > 0 && m_store->usedBytes() > m_settings.largestSize)
        from = std::max(from, m_since + (until - m_since) / shareForgotten);
    if (from == m_since)
        return {};
    return m_store->forgetBefore(from).map([&] { m_since = from; });
}

void RecordingWriter::tell(const RecordingChanges &changes, const std::optional<Refusal> &problem,
                           bool hasEnded)
{
    const std::int64_t bytes = m_store ? m_store->usedBytes() : 0;
    const std::int64_t free = freeBytesAt(m_settings.file);
    m_growth.add(steadyNow(), bytes);
    std::int64_t left = free - m_settings.leastFree;
    if (m_settings.largestSize > 0)
        left = std::min(left, m_settings.largestSize - bytes);
    const std::size_t kept = problem ? changes.bytes() : 0;
    const std::lock_guard lock(m_mutex);
    m_keptBytes = kept;
    m_status.problem = problem;
    m_status.hasEnded = hasEnded;
    m_status.bytes = bytes;
    m_status.freeBytes = free;
    m_status.timeUntilFull = m_growth.timeUntilFull(left);
    if (!problem)
        m_status.written = changes.until;
}

std::optional<RecordingWriter::FileIdentity> RecordingWriter::identityOf(const QString &path)
{
    struct stat told = {};
    if (::stat(QFile::encodeName(path).constData(), &told) != 0)
        return {};
    return FileIdentity{told.st_dev, told.st_ino};
}

} // namespace codewheel
