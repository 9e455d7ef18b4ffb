// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/label_key.h"

#include "catalog/catalog.h"
#include "catalog/protocol_rules.h"

#include <QCoreApplication>

#include <algorithm>
#include <functional>

namespace codewheel {
namespace {

// What was typed, reduced to capital letters and digits, with a mapping back to the text as typed.
class TypedKey
{
public:
    explicit TypedKey(QStringView typed)
        : m_typed(typed)
    {
        for (qsizetype i = 0; i < typed.size(); ++i)
            if (typed[i].isLetterOrNumber()) {
                m_letters += typed[i].toUpper();
                m_places.push_back(i);
            }
    }

    qsizetype size() const { return m_letters.size(); }
    QStringView from(qsizetype place) const { return QStringView(m_letters).sliced(place); }
    // `count` letters or digits from `place`, as typed; fewer at the end.
    QString asTyped(qsizetype place, qsizetype count) const
    {
        const qsizetype behind = std::min(place + count, size());
        if (place >= behind)
            return {};
        const qsizetype first = m_places[static_cast<std::size_t>(place)];
        const qsizetype last = m_places[static_cast<std::size_t>(behind - 1)];
        return m_typed.sliced(first, last - first + 1).toString();
    }

private:
    QStringView m_typed;
    QString m_letters;
    std::vector<qsizetype> m_places; // in m_typed, of each letter
};

QString expectedText(const OrderingKey::Part &part)
{
    QStringList codes;
    for (const OrderingKey::Code &code : part.codes)
        codes << QStringLiteral("%1 (%2)").arg(code.code, code.meaning.toString());
    if (part.any > 0)
        codes << QCoreApplication::translate("codewheel::LabelKey", "any letters or digits, %1 in all")
                     .arg(part.any);
    return QStringLiteral("%1: %2").arg(part.name.toString(), codes.join(QStringLiteral(", ")));
}

qsizetype longestCode(const OrderingKey::Part &part)
{
    qsizetype longest = part.any;
    for (const OrderingKey::Code &code : part.codes)
        longest = std::max(longest, code.code.size());
    return longest;
}

const OrderingKey::Code *codeAt(const OrderingKey::Part &part, QStringView letters)
{
    const auto found = std::ranges::find_if(
        part.codes, [&](const OrderingKey::Code &code) { return letters.startsWith(code.code); });
    return found == part.codes.end() ? nullptr : &*found;
}

// A K1 or K2 uses all bits of IN for the position, a K3 25 of them (FRABA manual 2.1).
bool holdsItsPositions(const LabelMatch &match)
{
    const DeviceDescription &device = *match.device;
    const int bits = protocolRules(device.profile).positionBits(device);
    const std::int64_t positions = std::int64_t{match.turns} * match.stepsPerTurn;
    return !device.hasWords() || positions <= std::int64_t{1} << bits;
}

Refusal refusalAbout(const QString &typed, const std::vector<LabelProblem> &problems)
{
    const auto farthest = std::ranges::max_element(problems, {}, &LabelProblem::understood);
    QStringList expected;
    QString written;
    if (farthest != problems.end()) {
        for (const LabelProblem &problem : problems)
            if (problem.understood == farthest->understood && !expected.contains(problem.expected))
                expected << problem.expected;
        written = farthest->written;
    }
    return {RefusalKind::badInput,
            RefusalId::labelKeyNotUnderstood,
            {typed, written, expected.join(QStringLiteral("; "))}};
}

} // namespace

tl::expected<LabelReading, LabelProblem> readLabelKey(const OrderingKey &key, QStringView typed)
{
    const TypedKey letters(typed);
    LabelReading reading;
    qsizetype place = 0;
    for (const OrderingKey::Part &part : key.parts) {
        const QStringView rest = letters.from(place);
        if (part.optional && rest.isEmpty())
            break;
        const OrderingKey::Code *code = codeAt(part, rest);
        const qsizetype length = code ? code->code.size() : part.any;
        if ((!code && part.any == 0) || rest.size() < length)
            return tl::unexpected(
                LabelProblem{place, letters.asTyped(place, longestCode(part)), expectedText(part)});
        reading.parts.push_back(
            {part.name, letters.asTyped(place, length), code ? code->meaning : LocalText{}});
        if (code && code->turns)
            reading.turns = code->turns;
        if (code && code->stepsPerTurn)
            reading.stepsPerTurn = code->stepsPerTurn;
        place += length;
    }
    if (place < letters.size())
        return tl::unexpected(LabelProblem{place, letters.asTyped(place, letters.size()), {}});
    return reading;
}

DeviceDescription describedDevice(const LabelMatch &match)
{
    DeviceDescription device = *match.device;
    device.physicalTurns = match.turns;
    device.physicalStepsPerTurn = match.stepsPerTurn;
    return device;
}

Result<std::vector<LabelMatch>> findByLabel(const Catalog &catalog, const QString &typed)
{
    std::vector<LabelMatch> matches;
    std::vector<LabelProblem> problems;
    for (const DeviceDescription &device : catalog.devices()) {
        if (!device.orderingKey)
            continue;
        auto reading = readLabelKey(*device.orderingKey, typed);
        if (!reading) {
            problems.push_back(reading.error());
            continue;
        }
        LabelMatch match{&device, std::move(*reading), 0, 0};
        match.turns = match.reading.turns.value_or(device.physicalTurns);
        match.stepsPerTurn = match.reading.stepsPerTurn.value_or(device.physicalStepsPerTurn);
        matches.push_back(std::move(match));
    }
    if (std::ranges::any_of(matches, holdsItsPositions))
        std::erase_if(matches, std::not_fn(holdsItsPositions));
    if (matches.empty())
        return tl::unexpected(refusalAbout(typed, problems));
    return matches;
}

} // namespace codewheel
