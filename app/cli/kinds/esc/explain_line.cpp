// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/device_description.h"
#include "cli/bus/places.h"
#include "cli/call/texts.h"
#include "cli/kinds/esc/esc_line_access.h"
#include "cli/kinds/esc/esc_line_link_kind.h"
#include "cli/kinds/esc/esc_line_trace.h"
#include "kinds/esc/line/typed_request.h"
#include "kinds/esc/protocol/esc_frame.h"
#include "kinds/esc/protocol/esc_scaling.h"
#include "vocabulary/sentence.h"

namespace codewheel {
namespace {

const QString out = QStringLiteral("out");
const QString in = QStringLiteral("in");
const QString acceptedWord = QStringLiteral("CRLF");
const QString outOfRangeKey = QStringLiteral("outOfRange");

bool isOutOfRange(const esc::Request &request, std::uint32_t value, const esc::ExplainOptions &options)
{
    return !esc::valueRange(request.command, options.fractionBits).holds(value);
}

Checked<esc::Request> requestFrom(const QString &typed)
{
    const auto request = readRequest(typed);
    if (!request)
        return tl::unexpected(
            Complaint{ExitCode::badInput, QStringLiteral("notARequest"), request.error(), {typed}});
    return *request;
}

// What is between its line ends, as it comes over the line.
QByteArray answerBytes(const QString &typed, const esc::Request &request)
{
    if (typed == acceptedWord)
        return esc::lineEnd;
    const QByteArray text = typed.toLatin1();
    const bool isRefusal = text == "03" || text == "05";
    const bool isBareRefusal = isRefusal && (esc::shapeOf(request.command).writes ||
                                             esc::shapeOf(request.command).digits != text.size());
    return (isBareRefusal ? QByteArray() : QByteArray(esc::lineEnd)) + text + esc::lineEnd;
}

Answer explained(const QString &line, const QString &meaning, const DeviceDescription &device,
                 QJsonObject json)
{
    json.insert(QStringLiteral("device"), device.key);
    return {QStringLiteral("%1, %2\n  %3\n").arg(line, device.fullName(), meaning), json};
}

Answer explainRequest(const esc::Request &request, const DeviceDescription &device,
                      const esc::ExplainOptions &options)
{
    QJsonObject json = requestJson(request);
    json.insert(QStringLiteral("direction"), out);
    json.insert(QStringLiteral("bytes"), byteText(request.bytes()));
    if (esc::shapeOf(request.command).writes)
        json.insert(outOfRangeKey, isOutOfRange(request, request.data, options));
    return explained(QString::fromLatin1(request.text()) +
                         QStringLiteral(" (%1)").arg(byteText(request.bytes())),
                     esc::requestText(request, options), device, json);
}

Checked<Answer> explainAnswer(const QString &typed, const esc::Request &request,
                              const DeviceDescription &device, const esc::ExplainOptions &options)
{
    const auto answer = answerIn(answerBytes(typed, request), request.command);
    if (!answer)
        return badInput(
            "notAnAnswer",
            CommandLine::tr("\"%1\" is not an answer to %2. A read is answered with its digits, a write with "
                            "a bare line end (type CRLF), either with 03 or 05 where it is refused."),
            {typed, QString::fromLatin1(request.text())});
    QJsonObject json = answerJson(request, *answer, options);
    json.insert(QStringLiteral("direction"), in);
    if (answer->kind == esc::Answer::Kind::value)
        json.insert(outOfRangeKey, isOutOfRange(request, answer->value, options));
    json.insert(QStringLiteral("request"), requestJson(request));
    return explained(typed, esc::exchangeText(request, *answer, options), device, json);
}

// Only words have a mode and a coding, and what a label tells is about those.
Checked<void> checkOptions(const Arguments &arguments)
{
    for (const char *option : {"--mode", "--coding", "--label"})
        if (arguments.has(option))
            return badInput(
                "optionOfWords",
                CommandLine::tr("%1 is for words of process data; an encoder on a serial line has "
                                "none. Leave it out."),
                {QString::fromLatin1(option)});
    return {};
}

Checked<bool> isAnswer(const Arguments &arguments)
{
    const bool hasRequest = arguments.has("--other");
    const QString direction = arguments.value("--direction").value_or(hasRequest ? in : out);
    if (direction != in && direction != out)
        return badInput("optionNotAllowed", CommandLine::tr("%1 cannot be \"%2\". Allowed are: %3."),
                        {QStringLiteral("--direction"), direction, QStringLiteral("in, out")});
    if (direction == in && !hasRequest)
        return badInput(
            "requestMissing",
            CommandLine::tr("An answer means nothing without its request. Give it with --other, as "
                            "--other 05P."));
    if (direction == out && hasRequest)
        return badInput("requestTooMuch",
                        CommandLine::tr("A request needs no --other. Leave it out, or give --direction in to "
                                        "explain an answer."));
    return direction == in;
}

// A request, and the line it is for if that is typed before it: "Gate 2/05P".
struct TypedRequest
{
    QString bus; // with its slash: "Gate 2/"
    esc::Request request;
};

Checked<TypedRequest> typedRequestIn(const QString &typed)
{
    const qsizetype begin = typed.indexOf(u'/') + 1;
    return requestFrom(typed.sliced(begin)).map([&](const esc::Request &request) {
        return TypedRequest{typed.first(begin), request};
    });
}

// The line that has the place the request is for; null: the link leads to no line.
Checked<const EscLineAccess *> lineFor(const Call &call, const TypedRequest &typed)
{
    const std::vector<BusAccess *> lines = busesOf(call, QString::fromLatin1(escKind));
    if (lines.empty() && typed.bus.isEmpty())
        return nullptr;
    const auto place = lines.size() == 1 && typed.bus.isEmpty()
                           ? lines.front()->bus().placeOf(typed.request.to.node())
                           : placeMeant(call, nullptr, typed.bus + typed.request.to.node().toString());
    if (place)
        return static_cast<const EscLineAccess *>(call.findBus(place->bus)); // of its kind
    Complaint complaint = place.error();
    if (complaint.key == QStringLiteral("placeNotUnique"))
        complaint.text += u' ' + sentence(CommandLine::tr("Name the line before the request, as %1/%2."),
                                          {lines.front()->name(), QString::fromLatin1(typed.request.text())});
    return tl::unexpected(complaint);
}

} // namespace

Checked<Answer> explainLine(const Call &call, const DeviceDescription &device)
{
    if (const auto checked = checkOptions(call.arguments); !checked)
        return tl::unexpected(checked.error());
    const auto isOfAnswer = isAnswer(call.arguments);
    if (!isOfAnswer)
        return tl::unexpected(isOfAnswer.error());
    const QString &typed = call.arguments.rest.front();
    const auto asked = typedRequestIn(*isOfAnswer ? *call.arguments.value("--other") : typed);
    if (!asked)
        return tl::unexpected(asked.error());
    const auto line = lineFor(call, *asked);
    if (!line)
        return tl::unexpected(line.error());
    const esc::ExplainOptions options = (*line != nullptr ? (*line)->link() : EscLineLink()).explainOptions();
    auto answer = *isOfAnswer ? explainAnswer(typed, asked->request, device, options)
                              : explainRequest(asked->request, device, options);
    if (answer && *line != nullptr)
        addBus(answer->json, **line);
    return answer;
}

} // namespace codewheel
