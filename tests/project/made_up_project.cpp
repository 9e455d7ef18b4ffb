// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/project/made_up_project.h"

#include "cams/check_cams.h"
#include "kinds/esc/plan/esc_line_plan.h"
#include "kinds/interbus/gateway/gateway_settings.h"
#include "kinds/interbus/plan/process_addresses.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "kinds/interbus/ring/numbering.h"
#include "kinds/interbus/ring/ring_device.h"
#include "kinds/interbus/words/device_number.h"
#include "tests/support/plans.h"

#include <array>

namespace codewheel {
namespace {

class Maker
{
public:
    explicit Maker(std::mt19937 &random)
        : m_random(random)
    {}

    Project project(std::size_t devices);

private:
    std::int64_t below(std::int64_t limit)
    {
        return std::uniform_int_distribution<std::int64_t>(0, limit - 1)(m_random);
    }
    bool maybe() { return below(2) == 1; }
    QString text();
    Evidence evidence() { return static_cast<Evidence>(below(3)); }
    QDateTime time();
    std::optional<int> address();
    CamProgram cams(unsigned number);
    ProjectDevice device(DeviceNumber before);
    void addValues(ProjectDevice &device);
    void addCams(ProjectDevice &device);
    EscLinePlan line();
    ProjectLink gateway();
    ProjectLink otherLink();
    std::vector<ProjectDevice> encodersOfLine();

    std::mt19937 &m_random;
};

QString Maker::text()
{
    const std::array texts{QString(),
                           QStringLiteral("Crane 1, hoist"),
                           QStringLiteral("Geber \"Hubwerk\" \\ 2"),
                           QStringLiteral("two\nlines\twith\ra tab"),
                           QStringLiteral("  spaces  "),
                           QStringLiteral("Ä\u2028€\U0001D11E"),
                           QString(u'\u0001') + QChar(u'\0') + u'\u007F'};
    return texts[static_cast<std::size_t>(below(std::ssize(texts)))];
}

QDateTime Maker::time()
{
    return maybe() ? QDateTime::fromMSecsSinceEpoch(below(4'000'000'000'000), Qt::UTC) : QDateTime();
}

std::optional<int> Maker::address()
{
    return below(4) == 0 ? std::optional(static_cast<int>(below(largestAddress + 1))) : std::nullopt;
}

CamProgram Maker::cams(unsigned number)
{
    CamProgram program{.number = number, .cam = {}, .shift = static_cast<unsigned>(below(26))};
    for (Cam &cam : program.cam)
        cam = {below(largestCamPosition + 1), below(largestCamPosition + 1), maybe(),
               maybe() ? below(largestCamPosition + 1) : 0, maybe()};
    return program;
}

ProjectDevice Maker::device(DeviceNumber before)
{
    const unsigned codes[] = {0x0237, 0x0236, 0x0136, 0x0233, 0x000C, 0x81BE};
    ProjectDevice device;
    RingDevice participant;
    participant.number = nextNumber(before, before.segment > 0 && below(4) == 0).node();
    participant.level = static_cast<int>(below(16));
    participant.deviceCode = codes[static_cast<std::size_t>(below(std::ssize(codes)))];
    participant.inWords = static_cast<int>(below(3));
    participant.outWords = static_cast<int>(below(3));
    participant.deviceKey = maybe() ? QStringLiteral("fraba-ocd-ib") : QString();
    device.participant = participant;
    device.station = text();
    device.group = text();
    device.note = text();
    device.label = {maybe() ? 4096 : 0, maybe() ? 8192 : 0, text()};
    device.set(GivenAddresses{.in = address(), .out = address()});
    addValues(device);
    addCams(device);
    return device;
}

void Maker::addValues(ProjectDevice &device)
{
    for (const Parameter parameter : allParameters()) {
        if (below(6) == 0)
            device.wanted.push_back({parameter, below(1 << 25)});
        if (below(6) == 0)
            device.stored.push_back({parameter, -below(1 << 25), evidence(), time()});
    }
}

void Maker::addCams(ProjectDevice &device)
{
    for (unsigned number = 1; number <= CamProgram::programs; ++number) {
        if (below(16) == 0)
            device.wantedCams.push_back(cams(number));
        if (below(16) == 0)
            device.storedCams.push_back({cams(number), evidence(), time()});
        if (below(2) == 0)
            device.lastPosition = {below(1 << 25), QDateTime({2026, 3, 1}, QTime(14, 2, 0, 7), Qt::UTC),
                                   device.wanted};
    }
}

EscLinePlan Maker::line()
{
    using std::chrono::milliseconds;
    EscLinePlan line;
    EscLineSettings &wish = line.settings;
    wish.port = text();
    wish.serial = {static_cast<int>(1 + below(10'000'000)), maybe() ? 7 : 8,
                   static_cast<SerialSettings::Parity>(below(3)), maybe() ? 1 : 2, maybe()};
    wish.timing.character = wish.serial.timeOf(1);
    wish.timing.answerTimeOut = milliseconds(1 + below(10'000));
    wish.timing.retries = static_cast<int>(below(11));
    wish.timing.quietAfterWrite = milliseconds(below(10'001));
    wish.pollInterval = milliseconds(10 + below(1'000));
    wish.fractionBits = static_cast<int>(17 + below(14));
    wish.topSpeed = static_cast<double>(1 + below(20'000)) / 2 + 1;
    line.adapter = {static_cast<int>(below(0x10000)), static_cast<int>(below(0x10000)), text(), text()};
    return line;
}

std::vector<ProjectDevice> Maker::encodersOfLine()
{
    std::vector<ProjectDevice> encoders;
    for (std::uint8_t address = 1; address <= EscLineAddress::last; ++address) {
        if (below(8) != 0)
            continue;
        ProjectDevice encoder;
        encoder.standAt(placeOnLine({address}));
        encoder.participant.deviceKey = QStringLiteral("kuebler-esc-rs485");
        encoder.station = text();
        encoder.label = {0, 0, text()};
        encoder.set(EscEncoderSettings{.swapsWarningBytes = maybe()});
        addValues(encoder);
        encoders.push_back(std::move(encoder));
    }
    return encoders;
}

ProjectLink Maker::gateway()
{
    GatewaySettings settings;
    settings.transport = maybe() ? GatewaySettings::Transport::tcp : GatewaySettings::Transport::rtu;
    if (settings.transport == GatewaySettings::Transport::tcp)
        settings.host = text();
    else
        settings.serialPort = text();
    settings.unit = static_cast<int>(1 + below(247));
    settings.highWordFirst = maybe();
    settings.inFirst = static_cast<int>(below(65'536));
    if (maybe())
        settings.statusRegister = static_cast<int>(below(65'536));
    return {linkKindOf(settings), linkTexts(settings)};
}

// The training, or of a newer program.
ProjectLink Maker::otherLink()
{
    ProjectLink link;
    link.kind = maybe() ? QStringLiteral("training") : QStringLiteral("opc-ua");
    for (std::int64_t n = below(3); n > 0; --n)
        link.settings[text()] = text();
    return link;
}

Project Maker::project(std::size_t devices)
{
    Project project;
    project.title = text();
    project.note = text();
    RingPlan ring;
    ring.link = maybe() ? gateway() : otherLink();
    ring.addresses = {maybe() ? AddressRules::Unit::byte : AddressRules::Unit::word,
                      static_cast<int>(below(512)), maybe()};
    ring.cableKilometres = static_cast<double>(below(12'800)) / 1000;
    setRingPlan(project, firstBus, std::move(ring));
    DeviceNumber before;
    for (std::size_t n = 0; n < devices; ++n) {
        project.devices.push_back(device(before));
        before = DeviceNumber::of(project.devices.back().participant.number);
    }
    for (std::int64_t n = below(4); n > 0; --n) {
        WordList list{.words = {}, .holdCycles = static_cast<int>(1 + below(WordList::longestHold))};
        for (std::int64_t word = below(20); word > 0; --word)
            list.words.push_back(static_cast<Word>(m_random()));
        project.sequences.push_back({text(), list});
    }
    if (maybe())
        setLinePlan(project, firstLine, line());
    if (linePlan(project, firstLine))
        setDevicesOn(project, firstLine, encodersOfLine());
    return project;
}

} // namespace

Project madeUpProject(std::mt19937 &random, std::size_t devices)
{
    return Maker(random).project(devices);
}

} // namespace codewheel
