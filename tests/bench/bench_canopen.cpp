// SPDX-License-Identifier: GPL-3.0-or-later
// What a full CAN bus costs: read alone, and decoded, kept as traffic and recorded, beside python-can at the
// same adapter. And, in the time of a simulated bus, the search for nodes and reads of objects.
//
//   bench_canopen FOLDER [SECONDS]
#include "can/can_bits.h"
#include "can/can_link_argument.h"
#include "can/simulator/simulated_can_link.h"
#include "catalog/catalog.h"
#include "history/histories.h"
#include "kinds/canopen/bus/canopen_session.h"
#include "kinds/canopen/simulator/simulated_canopen_plant.h"
#include "links/serial_port_link.h"
#include "links/slcan_link.h"
#include "recording/bus_recorder.h"
#include "tests/bench/processor_time.h"
#include "tests/bench/slcan_feeder.h"

#include <QCoreApplication>
#include <QDir>
#include <QProcess>

#include <cstdio>
#include <thread>

namespace {

using namespace codewheel;
using namespace codewheel::bench;
using namespace std::chrono_literals;
using Start = CanopenSession::Start;
using Drive = CanopenSession::Drive;

constexpr int fullRate = 1'000'000;
constexpr auto betweenPumps = 33ms; // a window looks 30 times a second

std::unique_ptr<SlcanLink> linkTo(const SlcanFeeder &feeder)
{
    return std::make_unique<SlcanLink>(
        std::make_unique<SerialPortLink>(QString::fromStdString(feeder.port())), fullRate,
        CanLinkArgument::usualBaudRate);
}

// us of processor time a frame.
double readAlone(const std::vector<TimedFrame> &frames, SlcanFeeder::Pace pace)
{
    const SlcanFeeder feeder(frames, pace);
    const auto link = linkTo(feeder);
    if (!link->open(CanUse::watch))
        return 0;
    std::size_t count = 0;
    const double seconds = processorSecondsOf([&] {
        while (count < frames.size()) {
            const auto news = link->receive(link->now() + 2s);
            if (!news || (news->frames.empty() && news->fates.empty()))
                break;
            for (const CanFrame &frame : news->frames)
                count += frame.isError || !frame.time ? 0 : 1;
        }
    });
    std::printf("  read with their times: %zu of %zu frames, %.2f us a frame\n", count, frames.size(),
                1e6 * seconds / static_cast<double>(count));
    return 1e6 * seconds / static_cast<double>(count);
}

// The session as the program has it, with its thread, its traffic kept, and all of it recorded.
double atWork(const std::vector<TimedFrame> &frames, const QString &folder, int seconds)
{
    const SlcanFeeder feeder(frames, SlcanFeeder::Pace::real);
    const Catalog catalog = Catalog::builtIn();
    CanopenSession session(linkTo(feeder), catalog, QDateTime::currentDateTime());
    session.takeUsualMapping();
    std::vector<TrafficRow> kept;
    kept.reserve(frames.size());
    std::size_t count = 0;
    QObject::connect(&session, &EncoderBus::trafficPassed, &session, [&](const TrafficRow &row) {
        kept.push_back(row);
        count += row.kind == TrafficKind::answer ? 1 : 0;
    });
    Buses buses;
    buses.add(session);
    Histories histories(buses);
    double used = 0;
    if (!session.open({.link = QStringLiteral("slcan:bench"), .rate = fullRate}, Start::watching,
                      Drive::byThread))
        return 0;
    for (int node = 1; node <= 64; ++node)
        if (!session.add(node, QStringLiteral("canopen-406-multi-turn")))
            return 0;
    RecordingPlan plan;
    plan.settings.file = folder + QStringLiteral("/bus.cwrec");
    plan.settings.leastFree = 0;
    const auto recorder =
        BusRecorder::begin(buses, histories, plan, [] { return QDateTime::currentDateTimeUtc(); });
    if (!recorder)
        return 0;
    const double before = processorSeconds();
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(seconds + 3);
    while (std::chrono::steady_clock::now() < end && count < frames.size()) {
        std::this_thread::sleep_for(betweenPumps);
        session.pump();
    }
    (*recorder)->end();
    used = processorSeconds() - before;
    int positions = 0;
    for (const Place place : session.places())
        positions += session.encoder(place)->latest().position ? 1 : 0;
    std::printf("  decoded, kept and recorded for %d s: %zu of %zu frames, %d positions, %.1f %% of a core, "
                "%.2f us a "
                "frame\n",
                seconds, count, frames.size(), positions, 100 * used / seconds,
                1e6 * used / static_cast<double>(count));
    return 1e6 * used / static_cast<double>(count);
}

// us of processor time a frame, as it says itself; 0: it is not there.
double byPythonCan(const std::vector<TimedFrame> &frames, SlcanFeeder::Pace pace)
{
    const SlcanFeeder feeder(frames, pace);
    QProcess python;
    python.start(QStringLiteral("/usr/bin/python3"),
                 {QStringLiteral(CODEWHEEL_PYTHON_CAN_READER), QString::fromStdString(feeder.port()),
                  QString::number(frames.size() - 1)});
    python.waitForFinished(300'000);
    const QByteArrayList told = python.readAllStandardOutput().trimmed().split(' ');
    if (told.size() < 2) {
        std::printf("python3-can is not there: %s\n", python.readAllStandardError().right(200).constData());
        return 0;
    }
    std::printf("  python-can reads %s of them, %.1f us a frame\n", told[0].constData(), told[1].toDouble());
    return told[1].toDouble();
}

void compare(const char *what, double ours, double pythons, int aim)
{
    if (pythons > 0)
        std::printf("  %s: 1/%.0f of python-can (aim: 1/%d)\n", what, pythons / ours, aim);
}

void fullBusOn(const QString &folder, int seconds)
{
    using Pace = SlcanFeeder::Pace;
    const std::vector<TimedFrame> frames = fullBus(seconds);
    const std::vector<TimedFrame> some = fullBus(2); // python-can takes its time
    std::printf("full bus of 1 Mbit/s, %.0f frames a second, at its pace:\n",
                static_cast<double>(frames.size()) / seconds);
    const double working = atWork(frames, folder, seconds);
    const double reading = readAlone(frames, Pace::real);
    const double python = byPythonCan(some, Pace::real);
    compare("decoded, kept and recorded", working, python, 20);
    compare("read with their times", reading, python, 200);
    std::printf("the same frames, as fast as they are read:\n");
    const double readingFast = readAlone(frames, Pace::asFastAsRead);
    compare("read with their times", readingFast, byPythonCan(some, Pace::asFastAsRead), 200);
}

std::vector<canopen::CanopenEncoderPlan> nodes(std::initializer_list<int> numbers)
{
    std::vector<canopen::CanopenEncoderPlan> plans;
    for (const int number : numbers)
        plans.push_back({.node = number});
    return plans;
}

double secondsOf(Instant time)
{
    return std::chrono::duration<double>(time).count();
}

// Until `isDone`, in the time of the bus.
void pass(CanopenSession &session, const bool &isDone)
{
    for (const Instant end = session.now() + 600s; !isDone && session.now() < end;)
        session.advance(1ms);
}

std::unique_ptr<CanopenSession> simulated(const Catalog &catalog, std::initializer_list<int> numbers)
{
    auto session = std::make_unique<CanopenSession>(
        std::make_unique<SimulatedCanLink>(canopen::SimulatedCanopenPlant(nodes(numbers)).bus()), catalog,
        QDateTime::currentDateTimeUtc());
    (void)session->open({}, Start::operating, Drive::byHand);
    session->advance(500ms); // they have told of their boot-up
    session->setOperate(true);
    session->advance(10ms);
    return session;
}

void scan(const Catalog &catalog)
{
    const auto session = simulated(catalog, {5, 6, 40, 99, 127});
    bool isDone = false;
    std::size_t found = 0;
    QObject::connect(session.get(), &CanopenSession::scanned, session.get(), [&](const NodesScanned &some) {
        isDone = some.isDone;
        found = some.found.size();
    });
    const Instant begin = session->now();
    session->scan();
    pass(*session, isDone);
    std::printf("127 numbers asked, %zu nodes at 125 kBd: %.2f s of bus time\n", found,
                secondsOf(session->now() - begin));
}

// What line and peer allow: both frames, the time that the node takes, and what is left between two
// dialogues.
double shortestRead(const std::vector<CanFrame> &passed)
{
    constexpr double bit = 1.0 / 125'000;
    int bits = canIntermission;
    for (const CanFrame &frame : passed)
        bits += canBits(frame);
    return bits * bit + secondsOf(canopen::SimulatedNode::answerDelay);
}

void readObjects(const Catalog &catalog)
{
    constexpr int reads = 2'000;
    const auto session = simulated(catalog, {5});
    int ended = 0;
    int right = 0;
    bool isDone = false;
    std::vector<CanFrame> last;
    QObject::connect(session.get(), &CanopenSession::passed, session.get(), [&](const CanopenRow &row) {
        if (last.size() == 2)
            last.clear();
        last.push_back(row.frame);
    });
    QObject::connect(session.get(), &CanopenSession::transferEnded, session.get(),
                     [&](const TransferEnded &one) {
                         right += one.outcome.kind == canopen::SdoOutcome::Kind::read ? 1 : 0;
                         isDone = ++ended == reads;
                     });
    const canopen::SdoRequest request{.node = 5, .object = {0x6001, 0}};
    const Instant begin = session->now();
    for (int i = 0; i < reads; ++i)
        session->transfer(request);
    pass(*session, isDone);
    const double each = secondsOf(session->now() - begin) / reads;
    const double allowed = shortestRead(last);
    std::printf("%d of %d objects read, every %.3f ms: %.1f %% of what line and node allow (%.3f ms)\n",
                right, reads, 1e3 * each, 100 * allowed / each, 1e3 * allowed);
}

} // namespace

int main(int argc, char **argv)
{
    const QCoreApplication application(argc, argv);
    if (argc < 2)
        return std::fputs("bench_canopen FOLDER [SECONDS]\n", stderr), 2;
    const Catalog catalog = Catalog::builtIn();
    fullBusOn(QString::fromLocal8Bit(argv[1]), argc > 2 ? std::max(1, std::atoi(argv[2])) : 20);
    scan(catalog);
    readObjects(catalog);
    return 0;
}
