// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/esc/driver/esc_bench.h"

#include "tests/kinds/interbus/words/driver_table.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr Instant answerTime = 10'300us; // 18 characters of 11 bits at 19200 Bd
constexpr Instant timeOut = 110ms;

std::string hex(std::uint32_t value, int digits)
{
    return QString::number(value, 16).toUpper().rightJustified(digits, u'0').toStdString();
}

esc::ExchangeResult silence(bool writes)
{
    const int tries = writes ? 1 : 3;
    return {.answer = {}, .sent = tries, .timeOuts = tries};
}

esc::ExchangeResult resultOf(const std::string &text, const esc::Request &request)
{
    esc::Answer answer;
    answer.text = QByteArray::fromStdString(text);
    if (text == "03")
        answer.kind = esc::Answer::Kind::unknownCommand;
    else if (text == "05")
        answer.kind = esc::Answer::Kind::outOfRange;
    else if (text.empty())
        answer.kind = esc::Answer::Kind::accepted;
    else if (request.command == esc::Command::version)
        answer.kind = esc::Answer::Kind::text;
    else
        answer.value = QByteArray::fromStdString(text).toUInt(nullptr, 16);
    return {.answer = answer, .sent = 1, .answerTime = answerTime};
}

// The command that reads back each write.
const std::map<std::string, std::string> readBy{{"GR", "D"}, {"GM", "U"}, {"GT", "M"}, {"GL", "L"},
                                                {"GH", "H"}, {"GF", "F"}, {"GP", "S"}};

} // namespace

std::string lettersOf(const std::string &line)
{
    return line.at(2) == 'G' ? line.substr(2, 2) : line.substr(2, 1);
}

EscBench::EscBench(EscSettings settings, EscLineAddress place, QStringView device)
    : driver(describe(device), place, settings)
    , has{{"O", "7005"},     {"V", "5882 HW 1.0 SW 2.04"},
          {"M", "02000000"}, {"D", "2000"},
          {"S", "00000001"}, {"A", "0000"},
          {"E", "8000"},     {"T", "00002710"},
          {"C", "00000000"}, {"N", "00A1B2C3"},
          {"H", "00100000"}, {"L", "00000100"},
          {"F", "20000000"}, {"B", "8000"},
          {"U", "1000"},     {"P", "00001235"}}
    , address(place)
{
    driver.setLineBaudRate(baudRate);
}

void EscBench::answerNext(const std::string &letters, const std::string &answer)
{
    m_next[letters].emplace_back(answer);
}

void EscBench::next(const std::string &letters, Fate fate)
{
    m_next[letters].emplace_back(fate);
}

std::string EscBench::execute(const esc::Request &request)
{
    const esc::CommandShape &shape = esc::shapeOf(request.command);
    const std::string letters(shape.letters);
    if (letters == "P" && position)
        return hex(position(now), 8);
    if (!shape.writes)
        return has.at(letters);
    const std::string data = request.text().toStdString().substr(2 + letters.size());
    const auto setBit = [&](unsigned bit) {
        const auto bits = static_cast<unsigned>(std::stoul(has.at("O"), nullptr, 16)) & ~(1U << bit);
        has.at("O") = hex(bits | request.data << bit, 4);
    };
    if (letters == "GD")
        setBit(0);
    else if (letters == "GS")
        setBit(2);
    else if (letters == "X")
        address = {static_cast<std::uint8_t>(std::stoul(data, nullptr, readsAddressAsDecimal ? 10 : 16))};
    else if (letters == "Y")
        baudRate = std::array{19200, 9600, 4800}.at(request.data);
    else
        has.at(readBy.at(letters)) = hex(request.data, static_cast<int>(has.at(readBy.at(letters)).size()));
    if (letters == "GP")
        has.at("P") = data;
    if (letters == "GR")
        has.at("U") = "1000"; // manual, GR: number of revolutions is 4096
    return {};
}

esc::ExchangeResult EscBench::answerTo(const esc::Request &request)
{
    const bool writes = esc::shapeOf(request.command).writes;
    const int rate = driver.wantedBaudRate().value_or(19200);
    if (!isOn || rate != baudRate || (request.to != address && !request.to.isMaster()))
        return silence(writes);
    const std::string letters(esc::shapeOf(request.command).letters);
    std::optional<std::variant<std::string, Fate>> wanted;
    if (auto &queue = m_next[letters]; !queue.empty()) {
        wanted = queue.front();
        queue.pop_front();
    } else if (const auto found = m_always.find(letters); found != m_always.end()) {
        wanted = found->second;
    }
    if (!wanted)
        return resultOf(execute(request), request);
    if (const auto *answer = std::get_if<std::string>(&*wanted))
        return resultOf(*answer, request);
    if (std::get<Fate>(*wanted) == Fate::unanswered)
        execute(request);
    return silence(writes);
}

esc::ExchangeResult EscBench::exchange(const esc::Request &request)
{
    log.push_back(request.text().toStdString());
    times.push_back(now);
    esc::ExchangeResult result = answerTo(request);
    now += result.answer ? answerTime : timeOut * result.sent;
    return result;
}

void EscBench::step()
{
    if (const auto request = driver.next(now)) {
        const esc::ExchangeResult result = exchange(*request);
        driver.answered(*request, result, now);
    } else {
        const auto wakes = driver.wakesAt();
        ASSERT_TRUE(wakes);
        now = std::max(now + 100us, *wakes);
    }
    collect();
}

void EscBench::run(Instant duration)
{
    const Instant end = now + duration;
    while (now < end)
        step();
}

void EscBench::runUntil(const std::function<bool()> &isReached)
{
    const Instant end = now + 60s;
    while (!isReached() && now < end)
        step();
    EXPECT_TRUE(isReached()) << "not within a minute";
}

esc::Request EscBench::goOnTo(esc::Command command)
{
    for (const Instant end = now + 60s; now < end; now += 100us) {
        const auto request = driver.next(now);
        if (request && request->command == command)
            return *request;
        if (request)
            driver.answered(*request, exchange(*request), now);
        collect();
    }
    ADD_FAILURE() << "not within a minute";
    return {};
}

void EscBench::settle()
{
    run(500ms);
    log.clear();
    times.clear();
}

Result<void> EscBench::begin(const Job &job, Pace pace)
{
    outcome.reset();
    return driver.begin(++m_job, job, pace, now);
}

const Outcome &EscBench::finish(const Job &job, Pace pace)
{
    if (const auto taken = begin(job, pace); !taken) {
        ADD_FAILURE() << "refused: " << taken.error().id.row().key;
        outcome.emplace();
        return *outcome;
    }
    runUntil([&] { return outcome.has_value(); });
    return *outcome;
}

void EscBench::collect()
{
    for (const Event &event : driver.takeEvents()) {
        if (const auto *done = std::get_if<Outcome>(&event))
            outcome = *done;
        if (const auto *at = std::get_if<Progress>(&event))
            progress = *at;
        if (const auto *change = std::get_if<KnowledgeChanged>(&event)) {
            eepromWrites += change->eepromWrites;
            for (const Parameter gone : change->noLongerKnown)
                known.erase(gone);
            for (const Known &fresh : change->known)
                known[fresh.parameter] = fresh;
        }
    }
    for (const Message &message : driver.takeMessages())
        messages.push_back(message);
}

std::vector<std::string> EscBench::jobLog()
{
    std::vector<std::string> lines;
    std::ranges::copy_if(log, std::back_inserter(lines), [](const std::string &line) {
        const std::string letters = lettersOf(line);
        return letters != "P" && letters != "E" && letters != "A";
    });
    return lines;
}

int EscBench::count(const std::string &letters) const
{
    return static_cast<int>(
        std::ranges::count_if(log, [&](const std::string &line) { return lettersOf(line) == letters; }));
}

int EscBench::countOf(MessageCode id) const
{
    return static_cast<int>(std::ranges::count(messages, id, &Message::id));
}

std::optional<std::int64_t> EscBench::value(Parameter parameter) const
{
    const auto found = known.find(parameter);
    return found == known.end() ? std::nullopt : found->second.value.asNumber();
}

} // namespace codewheel
