// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/gateway_check.h"

#include "kinds/interbus/gateway/gateway_check_text.h"
#include "kinds/interbus/gateway/gateway_refusals.h"
#include "kinds/interbus/gateway/gateway_texts.h"
#include "kinds/interbus/gateway/map_reading.h"
#include "kinds/interbus/gateway/register_refusal.h"
#include "kinds/interbus/gateway/register_tries.h"
#include "kinds/interbus/gateway/served_ring.h"
#include "kinds/interbus/ring/told_ring.h"
#include "kinds/interbus/words/device_number.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace codewheel {
namespace {

constexpr int readsForSteady = 4; // of a word, until two in a row agree

constexpr std::array stepKeys{"found",  "connected", "answered", "inArea", "outArea",
                              "status", "word",      "map",      "closing"};

RingStructure checkedRing(const std::vector<CheckedDevice> &devices)
{
    RingStructure ring;
    for (const CheckedDevice &device : devices)
        ring.push_back(device.participant);
    return ring;
}

// What is missing is the place itself; any other refusal is about the connection to it.
bool isAboutPlace(RefusalCode id)
{
    return id == RefusalId::hostNotFound || id == RefusalId::portNotFound || id == RefusalId::cancelled;
}

RegisterBlock spanOf(const std::vector<RegisterBlock> &blocks)
{
    return {blocks.front().first, blocks.back().end() - blocks.front().first};
}

} // namespace

Result<GatewayMap> mapOf(const std::vector<CheckedDevice> &devices, const GatewaySettings &settings)
{
    if (devices.empty())
        return refuse(RefusalKind::badInput, GatewayRefusalId::gatewayHasNoDevices);
    return GatewayMap::of(checkedRing(devices), settings);
}

QString gatewayStepKey(GatewayStep step)
{
    return QString::fromLatin1(stepKeys.at(static_cast<std::size_t>(step)));
}

GatewayCheck::GatewayCheck(RegisterPort &port, const GatewaySettings &settings,
                           std::vector<CheckedDevice> devices, std::optional<NodeId> only)
    : m_port(port)
    , m_settings(settings)
    , m_devices(std::move(devices))
    , m_steps{{GatewayStep::found},
              {GatewayStep::connected},
              {GatewayStep::answered},
              {GatewayStep::inArea},
              {GatewayStep::outArea}}
    , m_map(mapOf(m_devices, m_settings))
{
    if (m_settings.statusRegister)
        m_steps.push_back({GatewayStep::status});
    for (std::size_t i = 0; i < m_devices.size(); ++i)
        if (!only || m_devices[i].participant.number == *only)
            m_steps.push_back({GatewayStep::word, i});
    if (!only)
        m_steps.push_back({GatewayStep::map});
}

GatewayCheck::~GatewayCheck()
{
    m_port.close();
}

NodeId GatewayCheck::placeOf(const Step &step) const
{
    return step.step == GatewayStep::word ? m_devices[step.device].participant.number : NodeId();
}

QString GatewayCheck::nextText() const
{
    const Step &step = m_steps[m_next];
    return gatewayStepText(step.step, m_settings.transport, placeOf(step));
}

GatewayFinding GatewayCheck::withOutcome(CheckOutcome outcome, const QString &sentence) const
{
    const Step &step = m_steps[m_next];
    return {step.step, outcome, sentence, placeOf(step)};
}

GatewayFinding GatewayCheck::passed(const QString &sentence) const
{
    return withOutcome(CheckOutcome::passed, sentence);
}

GatewayFinding GatewayCheck::failed(const Refusal &why, const QString &more)
{
    m_isOver |= why.kind == RefusalKind::stopped || why.id == RefusalId::connectionClosed ||
                why.id == GatewayRefusalId::closedUnanswered;
    const QString sentence = refusalText(why);
    GatewayFinding failed =
        withOutcome(CheckOutcome::failed, more.isEmpty() ? sentence : sentence + u' ' + more);
    failed.why = why;
    return failed;
}

GatewayFinding GatewayCheck::skipped(const QString &sentence) const
{
    return withOutcome(CheckOutcome::skipped, sentence);
}

GatewayFinding GatewayCheck::next()
{
    const Step step = m_steps[m_next];
    GatewayFinding finding = skipped(GatewayTexts::tr("Not tested, because of what failed before."));
    if (!m_isOver) {
        switch (step.step) {
        case GatewayStep::found:
            finding = find();
            break;
        case GatewayStep::connected:
            finding = connect();
            break;
        case GatewayStep::answered:
            finding = ask();
            break;
        case GatewayStep::inArea:
            finding = checkIn();
            break;
        case GatewayStep::outArea:
            finding = checkOut();
            break;
        case GatewayStep::status:
            finding = readStatus();
            break;
        case GatewayStep::word:
            finding = checkWord(step.device);
            break;
        case GatewayStep::map:
            finding = checkMap();
            break;
        case GatewayStep::closing:
            finding = closing();
            break;
        }
    }
    ++m_next;
    if (isDone() && tellsClosing())
        m_steps.push_back({GatewayStep::closing});
    if (isDone())
        m_port.close();
    return finding;
}

bool GatewayCheck::tellsClosing() const
{
    return !m_isOver && m_steps.back().step != GatewayStep::closing && m_port.noticed().keepsNone;
}

// A habit that costs time only.
GatewayFinding GatewayCheck::closing() const
{
    return passed(closingText(m_port.noticed().renewals + 1));
}

// A port looks for the place and connects in one call.
GatewayFinding GatewayCheck::find()
{
    m_opened = m_port.open();
    m_isOver = !m_opened && isAboutPlace(m_opened.error().id);
    return m_isOver ? failed(m_opened.error()) : passed(foundText(m_settings));
}

GatewayFinding GatewayCheck::connect()
{
    m_isOver = !m_opened;
    return m_opened ? passed(sentence(GatewayTexts::tr("Connected with %1."), {m_port.name()}))
                    : failed(m_opened.error());
}

Result<void> GatewayCheck::read(RegisterArea area, const RegisterBlock &block, std::vector<Register> &to)
{
    to.assign(static_cast<std::size_t>(block.count), 0);
    bool mayBeLate = false; // the answer, to the request before, which was repeated
    for (RegisterTries tries(m_port, m_settings);;) {
        auto done = m_port.read(area, block.first, to);
        if (done && !mayBeLate)
            return {};
        mayBeLate = !done && !isBusy(done.error());
        if (!done && !tries.goOn(done))
            return tl::unexpected(
                registerRefusal(done.error(), m_port.name(), readFunction(area), block, tries.sent()));
    }
}

Result<void> GatewayCheck::readAll(RegisterArea area, const std::vector<RegisterBlock> &blocks)
{
    std::vector<Register> registers;
    for (const RegisterBlock &block : blocks)
        if (auto done = read(area, block, registers); !done)
            return done;
    return {};
}

// A unit that refuses a register is there.
GatewayFinding GatewayCheck::ask()
{
    std::vector<Register> registers;
    const Instant begun = m_port.now();
    const auto answered = read(m_settings.inArea, {m_settings.inFirst, 1}, registers);
    if (answered || isOfMap(answered.error()))
        return passed(answeredText(m_settings.unit, m_port.now() - begun));
    m_isOver = true;
    return failed(answered.error());
}

// The first device whose registers cannot be read, found by halving: a gateway has one end.
QString GatewayCheck::whereItEnds(RegisterArea area, Blocks of)
{
    std::vector<std::size_t> there;
    for (std::size_t i = 0; i < m_devices.size(); ++i)
        if (((*m_map).*of)(i).count > 0)
            there.push_back(i);
    std::vector<Register> registers;
    const auto first = std::ranges::partition_point(
        there, [&](std::size_t device) { return read(area, ((*m_map).*of)(device), registers).has_value(); });
    if (first == there.end() || first == there.begin())
        return {};
    return endsBeforeText(m_devices[*first].participant.number, ((*m_map).*of)(*first));
}

// The most registers that it moves in one read, found by halving. Empty: not even those of one word.
std::optional<int> GatewayCheck::mostInRead(RegisterArea area, const std::vector<RegisterBlock> &blocks)
{
    const RegisterBlock &longest = *std::ranges::max_element(blocks, {}, &RegisterBlock::count);
    std::vector<Register> registers;
    int most = 0;
    int tooMany = longest.count;
    while (tooMany - most > 1) {
        const int middle = std::midpoint(most, tooMany);
        (read(area, {longest.first, middle}, registers) ? most : tooMany) = middle;
    }
    return most < gateway_limits::mostRead.least ? std::nullopt : std::optional(most);
}

GatewayFinding GatewayCheck::failedArea(const Refusal &why, RegisterArea area, Blocks of,
                                        const std::vector<RegisterBlock> &blocks)
{
    if (!isOfMap(why))
        return failed(why);
    if (const QString end = whereItEnds(area, of); !end.isEmpty())
        return failed(why, end);
    const auto most = mostInRead(area, blocks);
    if (!most)
        return failed(why);
    m_settings.mostRead = *most;
    m_map = mapOf(m_devices, m_settings);
    GatewayFinding found = withOutcome(CheckOutcome::failed, mostInReadText(*most));
    found.proposed = {{QStringLiteral("most-read"), QString::number(*most)}};
    return found;
}

GatewayFinding GatewayCheck::checkIn()
{
    if (!m_map)
        return failed(m_map.error());
    if (m_map->inBlocks().empty())
        return skipped(GatewayTexts::tr("No device of the project has IN words."));
    const auto done = readAll(m_settings.inArea, m_map->inBlocks());
    if (done) {
        auto found = passed(readableText(readFunction(m_settings.inArea), spanOf(m_map->inBlocks())));
        recognise(found);
        return found;
    }
    return failedArea(done.error(), m_settings.inArea, &GatewayMap::in, m_map->inBlocks());
}

GatewayFinding GatewayCheck::checkOut()
{
    if (!m_map)
        return skipped(GatewayTexts::tr("Not tested, because of what failed before."));
    if (m_map->readBackBlocks().empty())
        return skipped(GatewayTexts::tr("No device of the project has OUT words."));
    if (!m_settings.readsBack)
        return skipped(GatewayTexts::tr("OUT is not read back, as the settings say, so nothing tells whether "
                                        "its registers are there or who writes them."));
    const auto done = readAll(RegisterArea::holding, m_map->readBackBlocks());
    if (done)
        return passed(readableText(readFunction(RegisterArea::holding), spanOf(m_map->readBackBlocks())));
    return failedArea(done.error(), RegisterArea::holding, &GatewayMap::out, m_map->readBackBlocks());
}

GatewayFinding GatewayCheck::readStatus()
{
    std::vector<Register> registers;
    const auto done = read(m_settings.inArea, {*m_settings.statusRegister, 1}, registers);
    return done ? judgedStatus(registers.front()) : failed(done.error());
}

GatewayFinding GatewayCheck::judgedStatus(Register status)
{
    const QString shown = sentence(GatewayTexts::tr("The status register is %1."), {registerText(status)});
    auto told = toldRing(m_settings, status);
    if (told && told->hasFailed && m_settings.placeRegister) {
        std::vector<Register> place;
        if (read(m_settings.inArea, {*m_settings.placeRegister, 1}, place))
            told->place = place.front();
    }
    if (!told)
        return passed(
            shown + u' ' +
            GatewayTexts::tr("What its bits mean is not set, so nothing tells whether the ring runs."));
    return told->stands() ? failed(told->whyItStands())
                          : passed(shown + u' ' + GatewayTexts::tr("The ring runs."));
}

// Another Codewheel that offers a ring tells whether it runs. Of other gateways nothing is claimed.
void GatewayCheck::recognise(GatewayFinding &finding)
{
    if (m_settings.statusRegister || !isOfCodewheel())
        return;
    finding.sentence += u' ' + GatewayTexts::tr("They are those of a ring that Codewheel offers; its status "
                                                "register tells whether it runs.");
    const auto set = settingTexts(m_settings);
    for (const auto &[name, text] : settingTexts(servedSettings(m_settings)))
        if (!set.contains(name) || set.at(name) != text)
            finding.proposed[name] = text;
}

// Its status registers are in both areas, nothing is behind them, and IN is among the holding registers, too.
bool GatewayCheck::isOfCodewheel()
{
    using namespace served_registers;
    if (!m_map || m_map->inBlocks().empty() || m_settings.inArea != RegisterArea::input ||
        m_settings.inFirst != in)
        return false;
    const auto canRead = [this](RegisterArea area, int first, int count) {
        std::vector<Register> registers;
        return read(area, {first, count}, registers).has_value();
    };
    return canRead(RegisterArea::input, status, end - status) &&
           canRead(RegisterArea::holding, status, end - status) &&
           canRead(RegisterArea::holding, inAsHolding, 1) && !canRead(RegisterArea::input, end, 1) &&
           !canRead(RegisterArea::holding, end, 1) && !m_isOver;
}

// A word that moves is never the same twice; the last read counts then.
Result<void> GatewayCheck::readSteady(const RegisterBlock &block, DeviceRegisters &to)
{
    std::vector<Register> before;
    for (int reads = 0; reads < readsForSteady && !to.stoodStill; ++reads) {
        before = to.inNow;
        if (auto done = read(m_settings.inArea, block, to.inNow); !done)
            return done;
        to.stoodStill = before == to.inNow;
    }
    return {};
}

GatewayFinding GatewayCheck::checkWord(std::size_t device)
{
    if (!m_map)
        return skipped(GatewayTexts::tr("Not tested, because of what failed before."));
    const CheckedDevice &its = m_devices[device];
    DeviceRegisters shown{
        .place = its.participant.number, .in = m_map->in(device), .out = m_map->out(device)};
    const auto read = shown.in.count > 0 ? readSteady(shown.in, shown) : Result<void>();
    if (read && m_settings.readsBack && shown.out.count > 0 &&
        !this->read(RegisterArea::holding, shown.out, shown.outNow))
        shown.outNow.clear();
    if (!read)
        shown.inNow.clear(); // nobody knows them
    GatewayFinding finding = read ? judged(shown, its.sender) : failed(read.error());
    if (!finding.shown)
        finding.shown = shown;
    return finding;
}

GatewayFinding GatewayCheck::judged(DeviceRegisters shown, const SendingEncoder &sender) const
{
    shown.readings = wordReadings(shown.inNow, sender);
    GatewayFinding judged = withOutcome(wordOutcome(shown, m_settings), wordText(shown, m_settings, false));
    judged.shown = std::move(shown);
    return judged;
}

// The IN area as it is set; or, where that ends too early, as it would be a register lower.
Result<std::vector<Register>> GatewayCheck::readIn(int lower)
{
    const int first = spanOf(m_map->inBlocks()).first;
    std::vector<Register> registers;
    std::vector<Register> part;
    for (const RegisterBlock &block : m_map->inBlocks()) {
        if (auto done = read(m_settings.inArea, {block.first - lower, block.count}, part); !done)
            return tl::unexpected(done.error());
        registers.resize(static_cast<std::size_t>(block.first - first)); // between devices
        registers.insert(registers.end(), part.begin(), part.end());
    }
    return registers;
}

// With a register before and behind it where there is one.
Result<std::vector<Register>> GatewayCheck::readAround(int &first)
{
    const RegisterBlock area = spanOf(m_map->inBlocks());
    first = area.first;
    auto registers = readIn(0);
    if (!registers && isOfMap(registers.error()) && area.first > 0) {
        --first;
        auto lower = readIn(1);
        return lower ? lower : registers;
    }
    if (!registers)
        return registers;
    std::vector<Register> part;
    if (read(m_settings.inArea, {area.end(), 1}, part))
        registers->push_back(part.front());
    if (first > 0 && read(m_settings.inArea, {first - 1, 1}, part)) {
        registers->insert(registers->begin(), part.front());
        --first;
    }
    return registers;
}

// A map that is off by one may show words that seem right, and OUT would go out beside them.
GatewayFinding GatewayCheck::checkMap()
{
    if (!m_map || m_map->inBlocks().empty())
        return skipped(GatewayTexts::tr("Not tested, because of what failed before."));
    int first = 0;
    const auto registers = readAround(first);
    if (!registers)
        return failed(registers.error());
    const MapReadings readings = readMaps(m_devices, m_settings, first, *registers);
    GatewayFinding finding = withOutcome(mapOutcome(readings, m_settings), mapText(readings, m_settings));
    const auto fitting = fittingMaps(readings);
    if (finding.outcome == CheckOutcome::failed && fitting.size() == 1)
        finding.proposed = {{QStringLiteral("in"), QString::number(fitting.front().in)},
                            {QStringLiteral("order"),
                             fitting.front().highWordFirst ? QStringLiteral("high") : QStringLiteral("low")}};
    return finding;
}

} // namespace codewheel
