// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/canopen/driver/driver_bench.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace codewheel::canopen {
namespace {

constexpr int driverNode = 5;
constexpr std::uint32_t noObject = 0x0602'0000;

std::string octetText(std::uint32_t number, int digits)
{
    return QString::number(number, 16).toUpper().rightJustified(digits, u'0').toStdString();
}

std::string requestedObject(const SdoRequest &request)
{
    return octetText(request.object.index, 4) + ':' + std::to_string(request.object.sub);
}

std::string requestText(const SdoRequest &request)
{
    std::string text = requestedObject(request);
    for (const std::uint8_t octet : request.value.value_or(std::vector<std::uint8_t>()))
        text += ' ' + octetText(octet, 2);
    return text;
}

bool isPolledRow(const std::string &text)
{
    for (const char *object :
         {"1000:0", "6004:0", "6503:0", "6505:0", "1017:0", "1018:4", "1005:0", "1014:0", "1200:1", "1200:2"})
        if (text == object)
            return true;
    return text.starts_with("180") || text.starts_with("1A0");
}

} // namespace

DriverBench::DriverBench(QStringView key)
    : DriverBench(*Catalog::builtIn().find(key))
{}

DriverBench::DriverBench(const DeviceDescription &described)
    : device(described)
    , driver(device, driverNode)
    , has{{"1000:0", {0x96, 1, 2, 0}}, {"1018:1", {0x0D, 1, 0, 0}}, {"1018:4", {0x39, 0x30, 0, 0}},
          {"1017:0", {0, 0}},          {"6000:0", {0x04, 0x10}},    {"6001:0", {0, 0x10, 0, 0}},
          {"6002:0", {0, 0, 0, 1}},    {"6003:0", {0, 0, 0, 0}},    {"6004:0", {0x88, 0x13, 0, 0}},
          {"6500:0", {0x04, 0x10}},    {"6503:0", {0, 0}},          {"6505:0", {0, 0}},
          {"6509:0", {0, 0, 0, 0}},    {"1010:1", {1, 0, 0, 0}},    {"1011:1", {1, 0, 0, 0}}}
{}

void DriverBench::hear(std::uint32_t id, const std::vector<std::uint8_t> &data)
{
    CanFrame frame{.id = id, .length = static_cast<std::uint8_t>(data.size())};
    std::ranges::copy(data, frame.bytes.begin());
    driver.take(frame, now);
    collect();
}

void DriverBench::step(Instant end)
{
    const auto request = driver.next(now);
    if (!request) {
        const auto wakes = driver.wakesAt();
        now = std::min(end, std::max(now + std::chrono::milliseconds(1), wakes.value_or(now)));
        collect();
        return;
    }
    const auto *sdo = std::get_if<SdoRequest>(&*request);
    log.push_back(sdo != nullptr
                      ? requestText(*sdo)
                      : "NMT " + octetText(static_cast<unsigned>(std::get<NmtRequest>(*request).command), 2));
    const std::string text = log.back();
    now += std::chrono::milliseconds(1);
    const SdoOutcome answer =
        sdo != nullptr ? answerTo(*sdo, text) : answerTo(std::get<NmtRequest>(*request));
    driver.answered(*request, answer, now);
    collect();
    if (sdo == nullptr && isRunning && showsAfterStart) {
        now += std::chrono::milliseconds(1);
        hear(0x700 + driverNode, {*showsAfterStart});
    }
}

SdoOutcome DriverBench::answerTo(const SdoRequest &request, const std::string &text)
{
    using Kind = SdoOutcome::Kind;
    const std::string object = requestedObject(request);
    if (const auto fate = fateOf(text)) {
        if (*fate == Fate::unanswered)
            execute(request, object);
        if (*fate != Fate::notSent)
            now += request.timeOut * (request.value ? 1 : 3);
        return {.kind = *fate == Fate::notSent ? Kind::notSent : Kind::noAnswer};
    }
    return execute(request, object);
}

std::optional<DriverBench::Fate> DriverBench::fateOf(const std::string &text)
{
    if (fateOfJobRequest && !isPolledRow(text) && jobLog().size() == fateOfJobRequest->first + 1)
        return fateOfJobRequest->second;
    auto &fates = m_next[text];
    if (fates.empty())
        return std::nullopt;
    const Fate fate = fates.front();
    fates.pop_front();
    return fate;
}

SdoOutcome DriverBench::execute(const SdoRequest &request, const std::string &object)
{
    using Kind = SdoOutcome::Kind;
    const auto found = has.find(object);
    if (found == has.end())
        return {.kind = Kind::aborted, .abortCode = noObject};
    if (!request.value)
        return {.kind = Kind::read, .value = found->second};
    if (const auto code = refuses.find(object); code != refuses.end())
        return {.kind = Kind::aborted, .abortCode = code->second};
    if (refusesWhileRunning && isRunning)
        return {.kind = Kind::aborted, .abortCode = 0x0800'0022};
    if (!object.starts_with("101"))
        found->second = *request.value;
    if (object == "6003:0" && !ignoresPresets)
        has["6004:0"] = *request.value;
    if (object == "6000:0")
        has["6500:0"] = *request.value;
    return {.kind = Kind::written};
}

SdoOutcome DriverBench::answerTo(const NmtRequest &request)
{
    EXPECT_EQ(request.node, driverNode);
    isRunning = request.command == NmtCommand::start;
    const bool isBoot = request.command == NmtCommand::resetNode;
    if (isBoot && bootsAfterReset)
        hear(0x700 + driverNode, {0x00});
    return {.kind = SdoOutcome::Kind::written};
}

void DriverBench::run(Instant duration)
{
    for (const Instant end = now + duration; now < end;)
        step(end);
}

void DriverBench::settle()
{
    run(std::chrono::seconds(1));
    hear(0x700 + driverNode,
         {static_cast<std::uint8_t>(isRunning ? NmtState::operational : NmtState::preOperational)});
    log.clear();
    messages.clear();
}

Result<void> DriverBench::begin(const Job &job, Pace pace)
{
    outcome.reset();
    return driver.begin(++m_job, job, pace, now);
}

const Outcome &DriverBench::finish(const Job &job, Pace pace)
{
    if (const auto begun = begin(job, pace); !begun) {
        outcome.emplace();
        outcome->result = begun;
        return *outcome;
    }
    return finish();
}

const Outcome &DriverBench::finish()
{
    constexpr int mostSteps = 2000;
    for (int i = 0; i < mostSteps && !outcome; ++i)
        step();
    static const Outcome none;
    EXPECT_TRUE(outcome.has_value()) << "the job has no end";
    return outcome ? *outcome : none;
}

void DriverBench::collect()
{
    for (const Event &event : driver.takeEvents()) {
        if (const auto *its = std::get_if<Outcome>(&event))
            outcome = *its;
        if (const auto *its = std::get_if<Progress>(&event))
            progress = *its;
        if (const auto *its = std::get_if<KnowledgeChanged>(&event)) {
            for (const Known &one : its->known)
                known[one.parameter] = one;
            for (const Parameter parameter : its->noLongerKnown)
                known.erase(parameter);
            for (const KnownCams &one : its->cams)
                cams = {one};
            if (!its->camsNoLongerKnown.empty())
                cams.clear();
            eepromWrites += its->eepromWrites;
        }
    }
    for (Message &message : driver.takeMessages())
        messages.push_back(std::move(message));
}

std::vector<std::string> DriverBench::jobLog() const
{
    std::vector<std::string> rows;
    std::ranges::copy_if(log, std::back_inserter(rows),
                         [](const std::string &row) { return !isPolledRow(row); });
    return rows;
}

int DriverBench::countOf(MessageCode id) const
{
    return static_cast<int>(std::ranges::count(messages, id, &Message::id));
}

std::optional<std::int64_t> DriverBench::value(Parameter parameter) const
{
    const auto found = known.find(parameter);
    return found == known.end() ? std::nullopt : found->second.value.asNumber();
}

std::optional<Kept> DriverBench::kept(Parameter parameter) const
{
    const auto found = known.find(parameter);
    return found == known.end() ? std::nullopt : std::optional(found->second.kept);
}

std::optional<RefusalCode> DriverBench::refusal() const
{
    return outcome && !outcome->result ? std::optional(outcome->result.error().id) : std::nullopt;
}

} // namespace codewheel::canopen
