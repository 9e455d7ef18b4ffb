// SPDX-License-Identifier: GPL-3.0-or-later
// What a recording costs: bytes of a value on disk, processor time at 512 values a millisecond, into a file
// and on a server, and the time to the first picture of a large one that is in no cache.
//
//   bench_recording FOLDER [SECONDS]
#include "recording/recording_reader.h"
#include "recording/recording_writer.h"
#include "tests/recording/postgres_server.h"

#include <QCoreApplication>
#include <QDir>
#include <QDirIterator>
#include <QFile>

#include <cmath>
#include <cstdio>
#include <ctime>
#include <fcntl.h>
#include <functional>
#include <random>
#include <unistd.h>

namespace {

using namespace codewheel;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr Instant begun = std::chrono::hours(24 * 365 * 56);

double secondsSince(Clock::time_point begin)
{
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

double processorTime(clockid_t clock)
{
    timespec time = {};
    ::clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Place placeOf(int number)
{
    return {firstBus, NodeId(std::to_string(number) + ".0")};
}

// The times of a bus cycle on a computer that is not of real time.
class Jitter
{
public:
    Instant next() { return Instant(static_cast<std::int64_t>(std::abs(m_normal(m_random)))); }

private:
    std::mt19937 m_random{16};
    std::normal_distribution<double> m_normal{0, 20};
};

// Bytes a sample of the file, without what it has from the beginning.
double bytesASample(const QString &file, Instant cycle, const std::function<std::int64_t(std::size_t)> &value)
{
    constexpr std::size_t samples = 1'000'000;
    QFile::remove(file);
    (void)RecordingStore::create(file, {.program = {}, .zone = {}});
    auto store = RecordingStore::open(file);
    const std::int64_t before = store->usedBytes();
    RecordingComposer composer;
    Jitter jitter;
    const auto perSecond = static_cast<std::size_t>(Instant(1s) / cycle);
    RecordedValues values{placeOf(1), {}};
    for (std::size_t i = 0; i < samples; ++i) {
        values.values.push_back(
            {.at = begun + cycle * static_cast<std::int64_t>(i) + jitter.next(), .position = value(i)});
        if ((i + 1) % perSecond != 0)
            continue;
        composer.add(std::exchange(values, RecordedValues{placeOf(1), {}}));
        (void)composer.gathered();
        if ((i + 1) % (50 * perSecond) == 0) {
            (void)store->write(composer.gathered());
            composer.forgetWritten();
        }
    }
    (void)store->write(composer.gathered());
    return static_cast<double>(store->usedBytes() - before) / static_cast<double>(samples);
}

void measureSizes(const QString &file)
{
    std::mt19937 random(17);
    const auto noise = [&random](unsigned most) {
        return static_cast<std::int64_t>(random() % (2 * most + 1)) - most;
    };
    const auto turning = [](std::size_t i, double steps) {
        return static_cast<std::int64_t>(static_cast<double>(i) * steps) & 0xFFFFFF;
    };
    const auto swinging = [](std::size_t i) {
        return static_cast<std::int64_t>(500'000 + 400'000 * std::sin(static_cast<double>(i) / 1'000));
    };
    const auto gray = [&turning](std::size_t i) {
        const std::int64_t position = turning(i, 34.13);
        return position ^ (position >> 1);
    };
    std::printf("bytes a sample on disk (4 or less turning, 0.1 or less standing):\n");
    const auto say = [&file](const char *what, Instant cycle, const auto &value) {
        std::printf("  %-52s %.3f\n", what, bytesASample(file, cycle, value));
    };
    say("standing", 1ms, [](std::size_t) { return 4'711; });
    say("turning evenly, 500 rpm of 4096 steps", 1ms, [&](std::size_t i) { return turning(i, 34.13); });
    say("turning with noise of 2 steps", 1ms, [&](std::size_t i) { return turning(i, 34.13) + noise(2); });
    say("turning fast with noise of 20 steps", 1ms,
        [&](std::size_t i) { return turning(i, 3'413.3) + noise(20); });
    say("swinging with noise of 2 steps", 1ms, [&](std::size_t i) { return swinging(i) + noise(2); });
    say("a word in Gray code, turning", 1ms, gray);
    say("answers of a line, each 20 ms, turning", 20ms, [&](std::size_t i) { return turning(i, 34.13); });
    say("answers of a line, each 100 ms, turning", 100ms, [&](std::size_t i) { return turning(i, 34.13); });
    QFile::remove(file);
}

// Of another recording than the one that is being sent.
bool isLeft(const QString &folder)
{
    int files = 0;
    for (QDirIterator all(folder, {QStringLiteral("*.cwrec")}, QDir::Files, QDirIterator::Subdirectories);
         all.hasNext(); all.next())
        ++files;
    return files > 1;
}

// 128 devices with four channels each, in frames, as fast as a bus would.
RecordingStatus measureLoad(const RecordingSettings &settings, int seconds)
{
    constexpr int devices = 128;
    constexpr int frame = 32; // ms
    auto writer = RecordingTarget::begin(settings);
    if (!writer)
        return {};
    Jitter jitter;
    double adding = 0;
    const auto begin = Clock::now();
    const double before = processorTime(CLOCK_PROCESS_CPUTIME_ID);
    const double mineBefore = processorTime(CLOCK_THREAD_CPUTIME_ID);
    for (int at = 0; at < 1'000 * seconds; at += frame) {
        std::vector<RecordedValues> all;
        for (int device = 0; device < devices; ++device) {
            all.push_back({placeOf(device + 1), {}});
            for (int cycle = at; cycle < at + frame; ++cycle) {
                const std::int64_t position = (1LL * cycle * (20 + device)) & 0xFFFFFF;
                all.back().values.push_back(
                    {.at = begun + 1ms * cycle + jitter.next(),
                     .position = position,
                     .cams = static_cast<std::uint8_t>(position >> 4),
                     .words = ExchangedWords{static_cast<Word>(position), static_cast<Word>(position * 2)}});
            }
        }
        const double beforeAdding = processorTime(CLOCK_THREAD_CPUTIME_ID);
        for (RecordedValues &values : all)
            (*writer)->add(std::move(values));
        adding += processorTime(CLOCK_THREAD_CPUTIME_ID) - beforeAdding;
        std::this_thread::sleep_until(begin + std::chrono::milliseconds(at + frame));
    }
    const double mine = processorTime(CLOCK_THREAD_CPUTIME_ID) - mineBefore;
    const RecordingStatus status = (*writer)->end();
    const double writing = processorTime(CLOCK_PROCESS_CPUTIME_ID) - before - mine;
    std::printf("512 values a millisecond for %d s (half a core or less, none lost): %.1f %% of a core for "
                "writing, %.1f %% for adding, %llu lost",
                seconds, 100 * writing / seconds, 100 * adding / seconds,
                static_cast<unsigned long long>(status.lost));
    return status;
}

void measureFileLoad(const QString &file, int seconds)
{
    QFile::remove(file);
    const RecordingStatus status = measureLoad({.file = file, .begun = begun, .leastFree = 0}, seconds);
    std::printf(", %.2f bytes each\n", static_cast<double>(status.bytes) / (512e3 * seconds));
    QFile::remove(file);
}

// The server works besides. Then: how long what waited for as long takes to follow.
void measureServerLoad(const QString &folder, int seconds)
{
    test::PostgresServer *server = test::PostgresServer::shared();
    if (server == nullptr) {
        std::printf("No server is installed (Debian: postgresql, libqt6sql6-psql): not measured on one.\n");
        return;
    }
    RecordingSettings settings{.server = server->newDatabase(), .begun = begun, .leastFree = 0};
    settings.unsentFolder = folder;
    std::printf("on a server: ");
    const RecordingStatus status = measureLoad(settings, seconds);
    std::printf(", %.1f MB not sent\n",
                status.server ? 1e-6 * static_cast<double>(status.server->waitingBytes) : 0);
    server->stop();
    std::printf("while it is away: ");
    (void)measureLoad(settings, seconds);
    server->start();
    const auto begin = Clock::now();
    const auto next = RecordingTarget::begin(settings);
    while (next && isLeft(folder))
        (*next)->flush();
    std::printf("; what waited follows in %.1f s\n", secondsSince(begin));
}

void fill(const QString &file, int channels, std::size_t samples)
{
    QFile::remove(file);
    (void)RecordingStore::create(file, {.program = {}, .zone = {}, .begun = begun});
    auto store = RecordingStore::open(file);
    RecordingComposer composer;
    for (std::size_t second = 0; second < samples / 1'000; ++second) {
        for (int channel = 0; channel < channels; ++channel) {
            RecordedValues values{placeOf(channel + 1), {}};
            for (std::size_t i = second * 1'000; i < (second + 1) * 1'000; ++i)
                values.values.push_back({.at = begun + 1ms * i + Instant((i * 7'919) % 23),
                                         .position = static_cast<std::int64_t>((i * 34 + i % 3) & 0xFFFFFF)});
            composer.add(values);
        }
        (void)composer.gathered();
        if (second % 50 == 49) {
            (void)store->write(composer.gathered());
            composer.forgetWritten();
        }
    }
    (void)store->write(composer.gathered());
}

// None of it is in memory any more.
void forget(const QString &file)
{
    const int opened = ::open(QFile::encodeName(file).constData(), O_RDONLY | O_CLOEXEC);
    (void)::fsync(opened);
    (void)::posix_fadvise(opened, 0, 0, POSIX_FADV_DONTNEED);
    (void)::close(opened);
}

void measureFirstPicture(const QString &file, int channels)
{
    constexpr std::size_t all = 100'000'000;
    fill(file, channels, all / static_cast<std::size_t>(channels));
    forget(file);
    const auto begin = Clock::now();
    const auto reader = RecordingReader::open(file);
    const auto devices = reader->devices();
    std::size_t columns = 0;
    for (const auto &device : *devices) {
        auto channel = reader->channel(device, Channel::position);
        columns += channel->look(*channel->span(), 1'000)->columns.size();
    }
    const double first = secondsSince(begin);
    const auto again = Clock::now();
    auto channel = reader->channel(devices->front(), Channel::position);
    const Instant from = channel->span()->from + (channel->span()->to - channel->span()->from) / 3;
    (void)channel->look({from, from + 1h}, 1'000);
    const double hour = secondsSince(again);
    const auto then = Clock::now();
    (void)channel->look({from, from + 10s}, 1'000);
    std::printf(
        "100 million samples in %d channel%s, %.0f MB, in no cache: first picture of all, %zu columns, after "
        "%.0f ms (1000 or less); then an hour of one %.0f ms, 10 s of it %.1f ms\n",
        channels, channels == 1 ? "" : "s", static_cast<double>(QFile(file).size()) / 1e6, columns,
        1e3 * first, 1e3 * hour, 1e3 * secondsSince(then));
    QFile::remove(file);
}

} // namespace

int main(int argc, char **argv)
{
    const QCoreApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.size() < 2)
        return 2;
    const QString file = QDir(arguments[1]).filePath(QStringLiteral("bench.cwrec"));
    measureSizes(file);
    const int seconds = arguments.size() > 2 ? arguments[2].toInt() : 20;
    measureFileLoad(file, seconds);
    measureServerLoad(QDir(arguments[1]).filePath(QStringLiteral("unsent")), seconds);
    measureFirstPicture(file, 8);
    measureFirstPicture(file, 1);
    return 0;
}
