// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/project/transfer_text.h"

#include "bus/buses.h"
#include "cli/bus/places.h"
#include "cli/call/json.h"
#include "cli/call/keys.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "cli/encoder/cam_text.h"
#include "cli/encoder/parameter_text.h"
#include "jobs/step_text.h"
#include "jobs/write_plan.h"
#include "journal/eeprom_cost.h"
#include "transfer/transfer_words.h"
#include "vocabulary/hex.h"
#include "vocabulary/known_words.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "vocabulary/value_json.h"

namespace codewheel {
namespace {

constexpr NamedValue<Became> becameKeys[] = {
    {"notDone", Became::notDone},   {"written", Became::written},     {"alreadyThere", Became::alreadyThere},
    {"restored", Became::restored}, {"stored", Became::stored},       {"confirmed", Became::confirmed},
    {"unknown", Became::unknown},   {"notActive", Became::notActive},
};

const DeviceDescription *deviceAt(const Buses &buses, Place place)
{
    const EncoderSession *encoder = buses.encoder(place);
    return encoder ? &encoder->device() : nullptr;
}

QString known(const DeviceDescription *device, Parameter parameter, const std::optional<Known> &known)
{
    return known ? QStringLiteral("%1 (%2)").arg(typedValue(device, {parameter, known->value}),
                                                 known_words::word(known))
                 : known_words::word(known);
}

QString programName(unsigned program)
{
    return sentence(CommandLine::tr("cam program %1"), {QString::number(program)});
}

// "1.0  FRABA OCD-IB K3  Crane 1, hoist"
template <typename Encoder>
QString heading(const Encoder &encoder)
{
    QStringList parts{encoder.place.shown()};
    for (const QString &part : {encoder.device, encoder.station})
        if (!part.isEmpty())
            parts << part;
    return parts.join(QStringLiteral("  ")) + u'\n';
}

QString tableOf(const Call &call, const EncoderPlan &plan)
{
    const DeviceDescription *device = deviceAt(call.buses, plan.place);
    TextTable table;
    for (const WriteRow &row : plan.write.rows)
        table.add({parameterKey(row.wanted.parameter), known(device, row.wanted.parameter, row.known),
                   typedValue(device, row.wanted),
                   row.isThere ? CommandLine::tr("left out: already there")
                   : row.step  ? sentText(*row.step)
                               : QString()});
    for (const TransferCamRow &row : plan.cams)
        table.add({programName(row.wanted.number),
                   {},
                   {},
                   row.isThere ? CommandLine::tr("left out: already there") : QString()});
    return table.toString(2);
}

QJsonObject valueJsonOf(const DeviceDescription *device, const ParameterValue &value)
{
    const ParameterDescription *parameter = device ? device->find(value.parameter) : nullptr;
    if (parameter)
        return valueJson(*parameter, value.value);
    return {{QStringLiteral("parameter"), parameterKey(value.parameter)},
            {QStringLiteral("value"), valueToJson(value.value)}};
}

// A word, or the command of a serial encoder.
void addSent(QJsonObject &json, const std::optional<Step> &step)
{
    const bool isRequest = step && !step->line.isEmpty();
    json.insert(QStringLiteral("word"), step && !isRequest ? wordJson(step->out) : QJsonValue());
    if (isRequest)
        json.insert(QStringLiteral("command"), sentText(*step));
}

QJsonValue noteJson(const std::optional<ValueNote> &note)
{
    return note ? QJsonValue(QJsonObject{{QStringLiteral("key"), noteKey(note->id)},
                                         {QStringLiteral("text"), noteText(*note)}})
                : QJsonValue();
}

QString positionLine(const EncoderAccount &encoder)
{
    if (!encoder.positionWanted)
        return {};
    const QString wanted = QString::number(*encoder.positionWanted);
    const QString pattern = encoder.positionSet ? CommandLine::tr("Position: set to %1.")
                            : encoder.positionUnknown
                                ? CommandLine::tr("Position: it is not known whether it was set to %1.")
                                : CommandLine::tr("Position: not set to %1.");
    return QStringLiteral("  ") + sentence(pattern, {wanted}) + u'\n';
}

} // namespace

QJsonValue refusalJson(const std::optional<Refusal> &refusal)
{
    return refusal ? QJsonValue(QJsonObject{{QStringLiteral("key"), refusalKey(refusal->id)},
                                            {QStringLiteral("text"), refusalText(*refusal)}})
                   : QJsonValue();
}

QString planText(const Call &call, const TransferPlan &plan)
{
    QString text;
    for (const EncoderPlan &encoder : plan) {
        text += heading(encoder) + tableOf(call, encoder);
        for (const QString &note : transfer_words::notes(encoder))
            text += QStringLiteral("  ") + note + u'\n';
        text += QStringLiteral("  ") + transfer_words::summary(encoder) + u'\n';
    }
    return text;
}

QJsonArray planJson(const Call &call, const TransferPlan &plan)
{
    QJsonArray encoders;
    for (const EncoderPlan &encoder : plan) {
        const DeviceDescription *device = deviceAt(call.buses, encoder.place);
        QJsonArray rows;
        for (const WriteRow &row : encoder.write.rows) {
            QJsonObject json = valueJsonOf(device, row.wanted);
            addKnown(json, row.known);
            addSent(json, row.step);
            json.insert(QStringLiteral("leftOut"), row.isThere);
            if (row.isInStepOfOthers())
                json.insert(QStringLiteral("goesAlong"), true);
            rows.append(json);
        }
        QJsonArray cams;
        for (const TransferCamRow &row : encoder.cams)
            cams.append(QJsonObject{{QStringLiteral("program"), static_cast<int>(row.wanted.number)},
                                    {QStringLiteral("leftOut"), row.isThere}});
        encoders.append(
            placeJson(call, encoder.place,
                      {{QStringLiteral("device"), device ? QJsonValue(device->key) : QJsonValue()},
                       {QStringLiteral("hindrance"), refusalJson(encoder.hindrance)},
                       {QStringLiteral("values"), rows},
                       {QStringLiteral("cams"), cams},
                       {QStringLiteral("eepromWritesAtMost"), encoder.eepromWrites}}));
    }
    return encoders;
}

QString accountText(const Call &call, const TransferAccount &account)
{
    QString text;
    for (const EncoderAccount &encoder : account.encoders) {
        const DeviceDescription *device = deviceAt(call.buses, encoder.place);
        TextTable table;
        for (const AccountRow &row : encoder.rows)
            table.add({parameterKey(row.wanted.parameter),
                       QStringLiteral("= %1").arg(typedValue(device, row.wanted)),
                       transfer_words::became(row)});
        for (const AccountCamRow &row : encoder.cams)
            table.add({programName(row.program), {}, transfer_words::became(row)});
        text += heading(encoder) + table.toString(2) + positionLine(encoder) + QStringLiteral("  ") +
                transfer_words::outcome(encoder) + u'\n';
        if (encoder.notInForce)
            text += QStringLiteral("  ") + noteText(*encoder.notInForce) + u'\n';
        if (encoder.isBegun)
            text += QStringLiteral("  ") +
                    sentence(CommandLine::tr("EEPROM writes: %1. Afterwards: %2."),
                             {eepromWritesText(encoder.eepromWrites, encoder.eepromWritesPerhaps),
                              transfer_words::leftIn(encoder)}) +
                    u'\n';
    }
    if (const int stored = account.count(Became::stored); stored > 0)
        text += sentence(CommandLine::tr("Stored, in force before: %1."), {QString::number(stored)}) + u'\n';
    return text +
           sentence(CommandLine::tr("Written: %1. Already there: %2. EEPROM writes: %3."),
                    {QString::number(account.count(Became::written)),
                     QString::number(account.count(Became::alreadyThere)),
                     eepromWritesText(account.eepromWrites(), account.eepromWritesPerhaps())}) +
           u'\n';
}

QJsonArray accountJson(const Call &call, const TransferAccount &account)
{
    QJsonArray encoders;
    for (const EncoderAccount &encoder : account.encoders) {
        const DeviceDescription *device = deviceAt(call.buses, encoder.place);
        QJsonArray rows;
        for (const AccountRow &row : encoder.rows) {
            QJsonObject json = valueJsonOf(device, row.wanted);
            addKnown(json, row.after);
            json.insert(QStringLiteral("became"), keyOf(becameKeys, row.became));
            rows.append(json);
        }
        QJsonArray cams;
        for (const AccountCamRow &row : encoder.cams)
            cams.append(QJsonObject{{QStringLiteral("program"), static_cast<int>(row.program)},
                                    {QStringLiteral("became"), keyOf(becameKeys, row.became)}});
        QJsonArray outLeft;
        for (const Word word : encoder.outLeft)
            outLeft.append(hexWord(word));
        encoders.append(placeJson(call, encoder.place,
                                  {{QStringLiteral("begun"), encoder.isBegun},
                                   {QStringLiteral("why"), refusalJson(encoder.why)},
                                   {QStringLiteral("values"), rows},
                                   {QStringLiteral("notInForce"), noteJson(encoder.notInForce)},
                                   {QStringLiteral("cams"), cams},
                                   {QStringLiteral("eepromWrites"), encoder.eepromWrites},
                                   {QStringLiteral("eepromWritesPerhaps"), encoder.eepromWritesPerhaps},
                                   {QStringLiteral("positionWanted"), numberJson(encoder.positionWanted)},
                                   {QStringLiteral("positionSet"), encoder.positionSet},
                                   {QStringLiteral("positionUnknown"), encoder.positionUnknown},
                                   {QStringLiteral("positionBefore"), numberJson(encoder.positionBefore)},
                                   {QStringLiteral("positionAfter"), numberJson(encoder.positionAfter)},
                                   {QStringLiteral("leftIn"), stateKey(encoder.leftIn)},
                                   {QStringLiteral("outLeft"), outLeft}}));
    }
    return encoders;
}

QJsonObject differencesJson(const ReplacementDifferences &differences)
{
    const auto pair = [](const std::optional<std::pair<int, int>> &change) {
        return change ? QJsonValue(QJsonObject{{QStringLiteral("before"), change->first},
                                               {QStringLiteral("now"), change->second}})
                      : QJsonValue();
    };
    QJsonArray notTaken;
    for (const ParameterValue &value : differences.notTaken)
        notTaken.append(QJsonObject{{QStringLiteral("parameter"), parameterKey(value.parameter)},
                                    {QStringLiteral("value"), valueToJson(value.value)}});
    return {{QStringLiteral("stepsPerTurn"), pair(differences.stepsPerTurn)},
            {QStringLiteral("turns"), pair(differences.turns)},
            {QStringLiteral("notTaken"), notTaken},
            {QStringLiteral("camsNotTaken"), differences.camsNotTaken}};
}

} // namespace codewheel
