// SPDX-License-Identifier: GPL-3.0-or-later
// The window for hours of accelerated bus time: one frame per second of the bus, while somebody works with
// it. Its memory must not grow after warming up.
//
//   attack_window [--minutes N] [--warm-up MINUTES] [--growth MB] [--seed N]
//
// Prints bus time, memory and frames as it goes, and finally by how much memory has grown; exit code 1 if
// that is more than allowed. Memory is measured once a minute, always with the window in the same state.
#include "app/window/buses/plant.h"
#include "app/window/kinds/training_window.h"
#include "bus/word_channel.h"
#include "kinds/interbus/ring/ring_session.h"
#include "tests/support/places.h"
#include "widgets/monitor/monitor_area.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QTemporaryDir>

#include <chrono>
#include <cstdio>
#include <malloc.h>
#include <random>

namespace {

using namespace codewheel;
using namespace std::chrono_literals;

constexpr Place worked = "1.0"_ring;  // FRABA K3, told and asked
constexpr Place watched = "2.0"_ring; // Baumer K3, which turns
constexpr std::array words{0x0200'00FFU, 0x8000'0000U, 0x0000'0000U};
constexpr std::array sizes{QSize(1600, 1000), QSize(1024, 768), QSize(1280, 900)};
constexpr int lines = 12; // to be printed
constexpr double bytesPerMegabyte = 1e6;
constexpr std::size_t trendMemory = 8 << 20; // bytes
constexpr int lettersOfMessage = 150;        // takes as much memory as a message

// Memory in use, in MB, without what was freed and is kept for later.
double memoryInUse()
{
    const struct mallinfo2 heap = mallinfo2();
    return static_cast<double>(heap.uordblks + heap.hblkhd) / bytesPerMegabyte;
}

// Somebody who sends words, reads parameters, switches between Watch and Operate, cuts the power, resizes the
// window, opens and closes monitors, looks at the trend: each about once a minute.
class Somebody
{
public:
    Somebody(TrainingWindow &shown, unsigned seed)
        : m_shown(shown)
        , m_random(seed)
    {}

    void work()
    {
        switch (std::uniform_int_distribution(0, 59)(m_random)) {
        case 0:
            sendNext();
            break;
        case 1:
            if (!encoder().runningJob())
                (void)encoder().start(ReadParameters{{Parameter::steps, Parameter::serialNumber}});
            break;
        case 2:
            m_shown.controls().powerCycle(watched.node);
            break;
        case 3:
            m_shown.window().resize(sizes[++m_size % sizes.size()]);
            break;
        case 4:
            openAndCloseMonitors();
            break;
        case 5:
            m_shown.bus().setRunning(false);
            m_shown.bus().setRunning(true);
            break;
        case 6:
            m_shown.window().actions().showInTrend->trigger();
            break;
        default:
            break;
        }
    }

    // Brings the window to the state in which memory is measured.
    void lookAsAlways()
    {
        m_shown.window().resize(sizes.front());
        m_shown.window().showMonitors();
        openAndCloseMonitors();
    }

private:
    EncoderSession &encoder() { return *m_shown.bus().encoder(worked); }
    void sendNext()
    {
        WordChannel &channel = *m_shown.bus().channel(worked);
        channel.stage(words[m_word % words.size()]);
        if (channel.write())
            ++m_word;
    }
    void openAndCloseMonitors()
    {
        auto *monitors = m_shown.window().findChild<MonitorArea *>();
        monitors->closeAll();
        for (const Place place : {worked, watched})
            monitors->open(place);
    }

    TrainingWindow &m_shown;
    std::mt19937 m_random;
    std::size_t m_word = 0;
    std::size_t m_size = 0;
};

// A second of the bus and of the line, and a frame.
void letASecondPass(TrainingWindow &shown)
{
    shown.bus().advance(1'000);
    if (EscLineSession *line = shown.line().session())
        line->advance(1s);
    shown.window().showFrame();
    shown.messages().catchUp();
    QCoreApplication::processEvents();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
}

// What is kept for the trend grows up to its limits: they are reached before memory is measured.
void fillTrend(Histories &histories)
{
    histories.setLimit(trendMemory);
    for (std::size_t mark = 0; mark < Histories::mostMarks; ++mark)
        histories.note(Instant(mark), QString(lettersOfMessage, u'x'));
}

struct Soak
{
    int warmUp = 15;   // minutes of the bus, until all bounded storage is full
    int minutes = 480; // of the bus, after the warm-up
    double growth = 1; // MB that are allowed from half to half; what a page takes for a while counts too
    unsigned seed = 0;
};

// The most memory used in each half of the time, in MB.
std::array<double, 2> watchMemory(TrainingWindow &shown, const Soak &soak)
{
    Somebody somebody(shown, soak.seed);
    std::array<double, 2> most{};
    const auto begin = std::chrono::steady_clock::now();
    const int all = soak.warmUp + soak.minutes;
    for (int minute = 0; minute < all; ++minute) {
        for (int second = 0; second < 60; ++second) {
            if (second < 59)
                somebody.work();
            else
                somebody.lookAsAlways();
            letASecondPass(shown);
        }
        const double memory = memoryInUse();
        if (minute >= soak.warmUp) {
            double &ofHalf = most[2 * (minute - soak.warmUp) < soak.minutes ? 0 : 1];
            ofHalf = std::max(ofHalf, memory);
        }
        if ((minute + 1) % std::max(all / lines, 1) == 0) {
            const std::chrono::duration<double> past = std::chrono::steady_clock::now() - begin;
            std::printf("  %3d min of the bus, %6.2f MB in use, %.0f frames a second\n", minute + 1, memory,
                        60 * (minute + 1) / past.count());
            std::fflush(stdout);
        }
    }
    return most;
}

Soak soakOf(const QStringList &arguments)
{
    Soak soak;
    QCommandLineParser options;
    const QCommandLineOption minutes(QStringLiteral("minutes"), QStringLiteral("of the bus"),
                                     QStringLiteral("N"), QString::number(soak.minutes));
    const QCommandLineOption warmUp(QStringLiteral("warm-up"), QStringLiteral("before them"),
                                    QStringLiteral("MINUTES"), QString::number(soak.warmUp));
    const QCommandLineOption seed(QStringLiteral("seed"), QStringLiteral("of what is done"),
                                  QStringLiteral("N"), QString::number(std::random_device()() % 1'000'000));
    const QCommandLineOption growth(QStringLiteral("growth"), QStringLiteral("that is allowed"),
                                    QStringLiteral("MB"), QString::number(soak.growth));
    options.addOptions({minutes, warmUp, growth, seed});
    options.process(arguments);
    soak.minutes = std::max(options.value(minutes).toInt(), 2);
    soak.warmUp = std::max(options.value(warmUp).toInt(), 0);
    soak.growth = std::max(options.value(growth).toDouble(), 0.0);
    soak.seed = options.value(seed).toUInt();
    return soak;
}

} // namespace

int main(int argc, char **argv)
{
    QApplication application(argc, argv);
    QApplication::setDoubleClickInterval(0); // a page that has just come is clicked at once
    const Soak soak = soakOf(QApplication::arguments());
    std::printf("seed %u; again with --seed %u\n", soak.seed, soak.seed);
    const QTemporaryDir folder;
    TrainingWindow shown(folder.filePath(QStringLiteral("attack.ini")), sizes.front());
    fillTrend(shown.plant().histories());
    shown.window().show();
    const std::array<double, 2> most = watchMemory(shown, soak);
    const double growth = most[1] - most[0];
    const bool isFlat = growth <= soak.growth;
    std::printf("window: %d frames in %d min of the bus after warming up, at most %.2f MB in the first half "
                "and %.2f MB in the second. %s: %+.2f MB, allowed %.2f MB.\n",
                60 * soak.minutes, soak.minutes, most[0], most[1], isFlat ? "Flat" : "It grows", growth,
                soak.growth);
    return isFlat ? 0 : 1;
}
