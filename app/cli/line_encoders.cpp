// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/line_encoders.h"

#include "catalog/catalog.h"
#include "catalog/label_key.h"
#include "cli/device_text.h"
#include "cli/stop_signals.h"
#include "cli/texts.h"
#include "encoder/hex.h"

#include <algorithm>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr Instant longestLook = 1s; // for what the encoder shows after a job

const QString usualDevice = QStringLiteral("kuebler-esc-rs485"); // what is sent to both makes is the same

bool isTwoHexDigits(const QString &text)
{
    return text.size() == 2 && parseHexDigits(text, 2);
}

bool isForLines(const DeviceDescription *device)
{
    return device != nullptr && device->profile == Profile::esc;
}

QString deviceOf(const Call &call, const ProjectDevice *planned)
{
    const bool isUsable = planned != nullptr && isForLines(call.catalog.find(planned->participant.deviceKey));
    return isUsable ? planned->participant.deviceKey : usualDevice;
}

// As far as the project tells: at the master address all encoders of a line would be meant.
Checked<void> checkIsAlone(const Call &call, Place number)
{
    const LineAddress address = LineAddress::of(number.node);
    if (!address.isMaster() || call.project == nullptr || devicesOn(*call.project, number.bus).size() < 2)
        return {};
    QStringList others;
    for (const ProjectDevice &encoder : devicesOn(*call.project, number.bus))
        others << encoder.place().toString();
    return tl::unexpected(complaintAbout({RefusalKind::badInput,
                                          RefusalId::lineAddressNotAlone,
                                          {address.shown(), others.join(QStringLiteral(", "))}}));
}

// So that the position is one of after the job.
void lookAgain(LineAccess &line, const EncoderSession &encoder, Instant jobEnd)
{
    const auto isNew = [&] {
        return encoder.latest().at > jobEnd || encoder.latest().state == EncoderState::silent;
    };
    for (Instant waited{}; !isNew() && waited < longestLook; waited += LineAccess::lookInterval)
        if (!line.advance(LineAccess::lookInterval))
            return;
}

} // namespace

bool isOnLine(const Call &call, const QString &place)
{
    if (call.line == nullptr)
        return false;
    return call.bus == nullptr || place.startsWith(linePrefix) || isTwoHexDigits(place);
}

Checked<QString> deviceOnLine(const Call &call, LineAddress address)
{
    const auto typed = call.arguments.value("--device");
    if (!typed)
        return deviceOf(call,
                        call.project != nullptr ? findDevice(*call.project, placeOnLine(address)) : nullptr);
    if (isForLines(call.catalog.find(*typed)))
        return *typed;
    if (const auto matches = findByLabel(call.catalog, *typed)) {
        const auto match =
            std::ranges::find_if(*matches, [](const LabelMatch &one) { return isForLines(one.device); });
        if (match != matches->end())
            return match->device->key;
    } else if (call.catalog.find(*typed) == nullptr) {
        return tl::unexpected(deviceNamed(call.catalog, *typed).error());
    }
    return badInput(QStringLiteral("deviceOnBus"),
                    CommandLine::tr("\"%1\" is a device on INTERBUS: it cannot be one on a serial line."),
                    {*typed});
}

Checked<EncoderSession *> encoderOnLine(const Call &call, const QString &place)
{
    if (call.whyNotOnLine != nullptr)
        return badInput(QStringLiteral("notOnSerialLine"), CommandLine::tr(call.whyNotOnLine));
    const auto number = Place::parse(place);
    if (number && !number->isOnLine())
        return badInput(QStringLiteral("placeOnBus"),
                        CommandLine::tr("%1 is a place on INTERBUS, and the link is a serial line. Give the "
                                        "address of an encoder as two hexadecimal digits, as 05."),
                        {place});
    if (!number)
        return tl::unexpected(complaintAbout({RefusalKind::badInput, RefusalId::lineAddressWrong, {place}}));
    if (const auto alone = checkIsAlone(call, *number); !alone)
        return tl::unexpected(alone.error());
    const LineAddress address = LineAddress::of(number->node);
    const auto device = deviceOnLine(call, address);
    if (!device)
        return tl::unexpected(device.error());
    return call.line->encoder(address, *device);
}

Checked<void> contactOnLine(const Call &call, const ProjectDevice &planned)
{
    const Place place = planned.place();
    const auto there = call.line->encoder(LineAddress::of(place.node), deviceOf(call, &planned));
    LineSession &line = call.line->bus();
    if (planned.swapsWarningBytes)
        line.setSwapsWarningBytes(place, true);
    const EncoderSession *encoder = line.encoder(place);
    const bool isSilent = encoder != nullptr && encoder->latest().state == EncoderState::silent;
    return there || isSilent ? Checked<void>() : tl::unexpected(there.error());
}

FinishedJob runOnLine(LineAccess &access, const AllowedJob &allowed)
{
    EncoderSession &encoder = allowed.encoder();
    FinishedJob finished;
    LineSession &line = **access.session();
    if (!std::holds_alternative<ReadParameters>(allowed.job())) {
        line.setOperate(true);
        access.advance(LineAccess::lookInterval);
    }
    const LineTrace trace(line);
    const auto started = encoder.start(allowed.job());
    if (!started) {
        finished.outcome.result = tl::unexpected(started.error());
        return finished;
    }

    bool running = true;
    QObject scope;
    QObject::connect(&encoder, &EncoderSession::progressed, &scope,
                     [&](const Progress &progress) { finished.lastStep = progress; });
    QObject::connect(&encoder, &EncoderSession::finished, &scope, [&](const Outcome &outcome) {
        running = outcome.job != *started;
        finished.outcome = outcome;
    });
    StopSignals stop;
    while (running) {
        if (stop.came())
            encoder.cancel(OnCancel::leaveAsIs);
        access.advance(LineAccess::lookInterval);
    }
    finished.passed = trace.rows();
    lookAgain(access, encoder, line.latest().at);
    return finished;
}

} // namespace codewheel
