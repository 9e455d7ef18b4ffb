// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/esc_line_checks.h"

#include "bus/bus_outline.h"
#include "kinds/esc/line/esc_line_check.h"
#include "kinds/esc/line/esc_line_session.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>

namespace codewheel {
namespace {

// The translation context of these texts.
struct EscLineCheckText
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::EscLineChecks)
};

double millisecondsOf(Instant time)
{
    return std::chrono::duration<double, std::milli>(time).count();
}

std::optional<Fault> standstillOf(const EscLineSession &line)
{
    const std::vector<Fault> faults = lineFaults(line);
    const auto found = std::ranges::find(faults, Fault::Extent::standstill, &Fault::extent);
    return found == faults.end() ? std::nullopt : std::optional(*found);
}

DataCheck lineLinkCheck(const EscLineSession &line)
{
    DataCheck check = linkCheck(line, lineText(line.linkName(), line.settings()));
    if (line.state() != BusState::lost)
        return check;
    check.remedy = standstillOf(line)->text;
    check.why = line.latest().whyLost;
    return check;
}

DataCheck pollingCheck(const EscLineSession &line)
{
    const DataStep step{DataCheck::Id::running, EscLineCheckText::tr("Asking for positions"),
                        EscLineCheckText::tr("runs")};
    if (line.isRunning())
        return step.passed(line.outline().state().word);
    return step.failed(line.outline().state().word,
                       EscLineCheckText::tr("Nobody asks for positions: that was stopped. Start it."),
                       DataCheck::Action::start);
}

// Of one encoder, or of all.
SinceAnswer missingOf(const EscLineSession &line, const std::vector<Place> &places)
{
    SinceAnswer all;
    for (const Place place : places)
        if (const EscLineSnapshot::Device *device = line.shown(place)) {
            all.requests += device->figures.sinceAnswer.requests;
            all.strayBytes += device->figures.sinceAnswer.strayBytes;
            all.isEchoed = all.isEchoed || device->figures.sinceAnswer.isEchoed;
        }
    return all;
}

bool answers(const EscLineSession &line, Place place)
{
    const EscLineSnapshot::Device *device = line.shown(place);
    return device != nullptr && device->figures.answers > 0 && device->figures.sinceAnswer.requests == 0;
}

bool isSilent(const EscLineSession &line, Place place)
{
    return line.encoder(place)->latest().state == EncoderState::silent;
}

// All of them share what is wrong with the line.
QString nothingText(const EscLineSession &line)
{
    const auto fault = standstillOf(line);
    return fault ? fault->text : EscLineCheck::silenceText(0, false);
}

void addBytes(DataChecks &checks, const EscLineSession &line, const std::vector<Place> &asked)
{
    const SinceAnswer missing = missingOf(line, asked);
    const bool isMissing = std::ranges::any_of(asked, [&](Place place) { return isSilent(line, place); });
    const auto places = line.places();
    const bool someAnswer = std::ranges::any_of(places, [&](Place place) { return answers(line, place); });
    const bool isDead = isMissing && !someAnswer;
    const QString requests =
        EscLineCheckText::tr("none for %n requests", nullptr, static_cast<int>(missing.requests));
    const DataStep bytes{DataCheck::Id::bytes, EscLineCheckText::tr("Bytes"),
                         EscLineCheckText::tr("some after each request")};
    if (isDead && missing.strayBytes == 0 && !missing.isEchoed)
        checks.push_back(bytes.failed(requests, nothingText(line), DataCheck::Action::connection));
    else
        checks.push_back(bytes.passed(EscLineCheckText::tr("they come")));

    const auto stray = static_cast<int>(missing.strayBytes);
    const DataStep sense{DataCheck::Id::sense, EscLineCheckText::tr("Rate and format"),
                         lineText({}, line.settings())};
    const QString strayText = EscLineCheckText::tr("%n bytes that are no answer", nullptr, stray);
    checks.push_back(isMissing && stray > 0
                         ? sense.failed(strayText, EscLineCheck::silenceText(stray, missing.isEchoed),
                                        DataCheck::Action::connection)
                         : sense.passed(EscLineCheckText::tr("the bytes make sense")));

    const DataStep echo{DataCheck::Id::echo, EscLineCheckText::tr("More than the echo"),
                        EscLineCheckText::tr("answers")};
    checks.push_back(isDead && missing.isEchoed
                         ? echo.failed(EscLineCheckText::tr("only the request came back"),
                                       EscLineCheck::silenceText(0, true), DataCheck::Action::connection)
                         : echo.passed());
}

DataCheck answerCheck(const EscLineSession &line, Place place)
{
    const DataStep step{DataCheck::Id::answer, EscLineCheckText::tr("Answer of the encoder"),
                        EscLineCheckText::tr("to each request")};
    const EscLineSnapshot::Device *device = line.shown(place);
    const SinceAnswer missing = device != nullptr ? device->figures.sinceAnswer : SinceAnswer{};
    if (isSilent(line, place))
        return step.failed(
            EscLineCheckText::tr("none for %n requests", nullptr, static_cast<int>(missing.requests)),
            refusalText({RefusalKind::device, RefusalId::encoderSilent, {place.shown()}}),
            DataCheck::Action::connection);
    if (device == nullptr || !device->figures.answerTime)
        return step.passed(EscLineCheckText::tr("none yet"));
    return step.passed(
        sentence(EscLineCheckText::tr("after %1 ms"),
                 {QLocale().toString(millisecondsOf(device->figures.answerTime->median), 'f', 1)}));
}

// What the encoder says about itself.
DataCheck alarmCheck(const EscLineSession &line, Place place)
{
    const DataStep step{DataCheck::Id::alarms, EscLineCheckText::tr("Alarms and warnings"),
                        EscLineCheckText::tr("none")};
    const std::vector<Fault> faults = lineFaults(line);
    const auto fault = std::ranges::find(faults, place.node, &Fault::node);
    if (fault == faults.end() || isSilent(line, place))
        return step.passed();
    return step.faulty(*fault);
}

void addOfEncoder(DataChecks &checks, const EscLineSession &line, Place place,
                  const std::vector<Participant> &planned)
{
    if (line.encoder(place) != nullptr) {
        addBytes(checks, line, {place});
        checks.push_back(answerCheck(line, place));
    }
    checks.push_back(kindCheck(line, place.node, planned));
    if (line.encoder(place) == nullptr)
        return;
    checks.push_back(upToDateCheck(line, place.node));
    checks.push_back(alarmCheck(line, place));
    checks.push_back(positionCheck(line, place.node));
}

} // namespace

QString lineText(const QString &port, const SerialSettings &settings)
{
    const QString rate =
        QStringLiteral("%1 Bd, %2").arg(QString::number(settings.baudRate), settings.format());
    return port.isEmpty() ? rate : QStringLiteral("%1, %2").arg(port, rate);
}

DataChecks lineChecks(const EscLineSession &line, NodeId node, const std::vector<Participant> &planned)
{
    DataChecks checks{lineLinkCheck(line)};
    if (!line.isOpen())
        return checks;
    checks.push_back(pollingCheck(line));
    if (!node.isEmpty()) {
        addOfEncoder(checks, line, line.placeOf(node), planned);
    } else {
        if (const auto asked = line.places(); !asked.empty())
            addBytes(checks, line, asked);
        checks.push_back(devicesCheck(line));
    }
    checks.push_back(writingCheck(line));
    return asFarAsKnown(std::move(checks));
}

} // namespace codewheel
