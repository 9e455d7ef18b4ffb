// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "catalog/explain_word.h"
#include "catalog/json_object.h"
#include "catalog/label_key.h"
#include "catalog/protocol_rules.h"
#include "cli/call/json.h"
#include "cli/call/texts.h"
#include "cli/commands.h"
#include "cli/encoder/parameter_arguments.h"
#include "cli/kinds/link_kind.h"
#include "jobs/protocol.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"

#include <array>

namespace codewheel {
namespace {

constexpr const char *explainExamples[] = {
    "explain 020000FF --device fraba-ocd-ib --direction out",
    "explain A0002000 --device fraba-ocd-ib --direction in --other 20210001",
    "explain 40000000 --device fraba-ocd-ib --direction out --mode cam",
    "explain 00003039 --device baumer-gxp6w --direction in --coding gray-cw",
    "explain 01FFFFFF --label OCD-IBA1B-1213-C100-PRI --device fraba-ocd-ib-k2 --direction in",
    "explain 03GP00005200 --device kuebler-esc-rs485",
    "explain 00001235 --device kuebler-esc-rs485 --other 05P",
};

constexpr std::array explainOptions{
    Option{"--device", "NAME", QT_TRANSLATE_NOOP("codewheel::CommandLine", "whose word it is (see devices)")},
    Option{"--label", "KEY",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "the key on the label of the encoder: it says how many bits a position has")},
    Option{"--direction", "in|out",
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "out: master to encoder; in: encoder to master")},
    Option{"--mode", "position|cam|velocity",
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "the mode the encoder is in, if it has several")},
    Option{"--other", "WORD",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "the word that stands the other way; of an answer its request")},
    Option{"--coding", "N",
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "how positions are coded: 1 to 6, or its name")},
};

constexpr NamedValue<WordDirection> directions[] = {{"in", WordDirection::in}, {"out", WordDirection::out}};
constexpr NamedValue<Mode> modes[] = {
    {"position", Mode::position}, {"cam", Mode::cam}, {"velocity", Mode::velocity}};

// One of a few keys; empty if the option is not given.
template <typename T, std::size_t n>
Checked<std::optional<T>> keyword(const Call &call, const char *option, const NamedValue<T> (&names)[n])
{
    const auto given = call.arguments.value(option);
    if (!given)
        return std::optional<T>();
    QStringList keys;
    for (const NamedValue<T> &name : names) {
        if (*given == QLatin1String(name.name))
            return std::optional(name.value);
        keys << QString::fromLatin1(name.name);
    }
    return badInput("optionNotAllowed", CommandLine::tr("%1 cannot be \"%2\". Allowed are: %3."),
                    {QString::fromLatin1(option), *given, keys.join(QStringLiteral(", "))});
}

Checked<QString> required(const Call &call, const char *option, const QString &values)
{
    if (const auto given = call.arguments.value(option))
        return *given;
    return badInput("missingOption", CommandLine::tr("%1 is missing. Give one of: %2."),
                    {QString::fromLatin1(option), values});
}

// With the turns and steps of its label, if given. The key may name the device too.
Checked<DeviceDescription> labelledDevice(const Call &call, const QString &label,
                                          const std::optional<QString> &name)
{
    const auto matches = findByLabel(call.catalog, label);
    if (!matches)
        return tl::unexpected(complaintAbout(matches.error()));
    QStringList keys;
    for (const LabelMatch &match : *matches) {
        if (name ? match.device->key == *name : matches->size() == 1)
            return describedDevice(match);
        keys << match.device->key;
    }
    if (!name)
        return tl::unexpected(required(call, "--device", keys.join(QStringLiteral(", "))).error());
    return badInput("labelOfOther",
                    CommandLine::tr("The key \"%1\" is not that of %2. It may be that of: %3."),
                    {label, *name, keys.join(QStringLiteral(", "))});
}

Checked<DeviceDescription> deviceMeant(const Call &call)
{
    const auto name = call.arguments.value("--device");
    if (name)
        if (const auto known = deviceNamed(call.catalog, *name); !known)
            return tl::unexpected(known.error());
    if (const auto label = call.arguments.value("--label"))
        return labelledDevice(call, *label, name);
    const auto key = required(call, "--device", listed(call.catalog.devices(), &DeviceDescription::key));
    if (!key)
        return tl::unexpected(key.error());
    return **deviceNamed(call.catalog, *key);
}

// The coding is parameter 3 of encoders that have it; for an unknown make it is assumed to be so.
Checked<std::optional<PositionCoding>> codingOf(const Call &call, const DeviceDescription &device)
{
    const auto given = call.arguments.value("--coding");
    if (!given)
        return std::optional<PositionCoding>();
    if (protocolRules(device.profile).hasOneCoding(device))
        return badInput("oneCodingOnly", CommandLine::tr("The %1 has one coding only. Leave --coding out."),
                        {device.fullName()});
    const DeviceDescription *withCoding = &device;
    for (const DeviceDescription &other : call.catalog.devices())
        if (!withCoding->find(Parameter::coding))
            withCoding = &other;
    const auto value = numberFrom(*withCoding->find(Parameter::coding), *given);
    if (!value)
        return tl::unexpected(value.error());
    return protocolOf(*withCoding).codingFor(*withCoding, *value);
}

Checked<WordDirection> directionOf(const Call &call)
{
    const auto given = required(call, "--direction", QStringLiteral("in, out"));
    if (!given)
        return tl::unexpected(given.error());
    const auto direction = keyword(call, "--direction", directions);
    if (!direction)
        return tl::unexpected(direction.error());
    return **direction;
}

Checked<WordContext> contextOf(const Call &call, const DeviceDescription &device)
{
    WordContext context;
    const auto direction = directionOf(call);
    if (!direction)
        return tl::unexpected(direction.error());
    context.direction = *direction;
    const auto mode = keyword(call, "--mode", modes);
    if (!mode)
        return tl::unexpected(mode.error());
    context.mode = *mode;
    const auto coding = codingOf(call, device);
    if (!coding)
        return tl::unexpected(coding.error());
    context.coding = *coding;
    if (const auto other = call.arguments.value("--other")) {
        const auto word = wordFrom(*other);
        if (!word)
            return tl::unexpected(word.error());
        context.counterpart = *word;
    }
    return context;
}

// What was not given and might narrow down the meanings.
QString whatMayHelp(const DeviceDescription &device, const WordContext &context)
{
    QStringList missing;
    if (device.isGeneric())
        missing << QStringLiteral("--device");
    if (device.mayHaveModes() && !context.mode)
        missing << QStringLiteral("--mode");
    const bool isIn = context.direction == WordDirection::in;
    if (isIn && !context.counterpart)
        missing << QStringLiteral("--other");
    if (isIn && !protocolRules(device.profile).hasOneCoding(device) && !context.coding)
        missing << QStringLiteral("--coding");
    return missing.isEmpty() ? QString()
                             : sentence(CommandLine::tr("One of these. To narrow it down: %1."),
                                        {missing.join(QStringLiteral(", "))}) +
                                   u'\n';
}

Checked<Answer> runExplain(const Call &call)
{
    const DeviceDescription *named = call.catalog.find(call.arguments.value("--device").value_or(QString()));
    for (const LinkKind *kind : linkKinds())
        if (auto explained = named != nullptr ? kind->explain(call, *named) : std::nullopt)
            return *std::move(explained);
    const auto word = wordFrom(call.arguments.rest.front());
    if (!word)
        return tl::unexpected(word.error());
    const auto device = deviceMeant(call);
    if (!device)
        return tl::unexpected(device.error());
    const auto context = contextOf(call, *device);
    if (!context)
        return tl::unexpected(context.error());

    const Explanation explanation = explainWord(*device, *word, *context);
    const bool isOut = context->direction == WordDirection::out;
    QString text =
        QStringLiteral("%1 %2, %3\n")
            .arg(isOut ? QStringLiteral("OUT") : QStringLiteral("IN"), hexWord(*word), device->fullName());
    for (const Meaning &meaning : explanation)
        text += QStringLiteral("  ") + explanationText(*device, meaning) + u'\n';
    if (!explanation.isUnique())
        text += whatMayHelp(*device, *context);
    return Answer{text,
                  {{QStringLiteral("word"), wordJson(*word)},
                   {QStringLiteral("direction"), isOut ? QStringLiteral("out") : QStringLiteral("in")},
                   {QStringLiteral("device"), device->key},
                   {QStringLiteral("meanings"), meaningsJson(explanation)}}};
}

} // namespace

const Subcommand explainCommand{
    .name = "explain",
    .usage =
        "WORD --device NAME [--label KEY] --direction in|out [--mode position|cam|velocity] [--other WORD] "
        "[--coding N]",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine", "explain what a word means"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "Tells what a 32-bit word means to an encoder. Every word gets an answer. What "
        "is not told\n(mode, coding, the word the other way) widens it to all meanings "
        "the word can have.\nA K1 or K2 counts as the standard one, unless its --label tells "
        "otherwise.\n\nOf an encoder on a serial line it explains a "
        "request (03GP00005200), or, with --other REQUEST,\nthe answer to it: its digits, or "
        "CRLF for a bare line end. Of several lines of the link it goes by\nthe one named before the request "
        "(\"Gate 2/05P\"), else by the only one that has its address.\n\nNeeds no bus and sends nothing."),
    .examples = explainExamples,
    .options = explainOptions,
    .arguments = {1},
    .needsLinks = true,
    .run = runExplain,
};

} // namespace codewheel
