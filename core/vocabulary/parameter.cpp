// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/parameter.h"

#include "vocabulary/enumeration_rows.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <compare>
#include <deque>
#include <mutex>
#include <shared_mutex>

namespace codewheel {
namespace {

struct ParameterRow
{
    Parameter parameter;
    const char *key;
    const char *name;
    const char *nameInText;
};

struct ParameterTexts
{
    Q_DECLARE_TR_FUNCTIONS(Parameter)

public:
    static constexpr auto all = std::to_array<ParameterRow>({
        {Parameter::steps, "steps", QT_TR_NOOP("Steps"), QT_TR_NOOP("steps")},
        {Parameter::revolutions, "revolutions", QT_TR_NOOP("Revolutions"), QT_TR_NOOP("revolutions")},
        {Parameter::direction, "direction", QT_TR_NOOP("Direction"), QT_TR_NOOP("direction")},
        {Parameter::coding, "coding", QT_TR_NOOP("Coding"), QT_TR_NOOP("coding")},
        {Parameter::preset, "preset", QT_TR_NOOP("Preset"), QT_TR_NOOP("preset")},
        {Parameter::zeroOffset, "zero-offset", QT_TR_NOOP("Zero offset"), QT_TR_NOOP("zero offset")},
        {Parameter::offset, "offset", QT_TR_NOOP("Offset"), QT_TR_NOOP("offset")},
        {Parameter::measuringRange, "measuring-range", QT_TR_NOOP("Measuring range"),
         QT_TR_NOOP("measuring range")},
        {Parameter::measuringLength, "measuring-length", QT_TR_NOOP("Measuring length in steps"),
         QT_TR_NOOP("measuring length in steps")},
        {Parameter::externalPreset, "external-preset", QT_TR_NOOP("External preset"),
         QT_TR_NOOP("external preset")},
        {Parameter::rodLength, "rod-length", QT_TR_NOOP("Rod length"), QT_TR_NOOP("rod length")},
        {Parameter::lowerLimit, "lower-limit", QT_TR_NOOP("Lower limit"), QT_TR_NOOP("lower limit")},
        {Parameter::upperLimit, "upper-limit", QT_TR_NOOP("Upper limit"), QT_TR_NOOP("upper limit")},
        {Parameter::scaling, "scaling", QT_TR_NOOP("Scaling"), QT_TR_NOOP("scaling")},
        {Parameter::scalingFactor, "scaling-factor", QT_TR_NOOP("Scaling factor"),
         QT_TR_NOOP("scaling factor")},
        {Parameter::lineAddress, "address", QT_TR_NOOP("Address"), QT_TR_NOOP("address")},
        {Parameter::baudRate, "baud-rate", QT_TR_NOOP("Baud rate"), QT_TR_NOOP("baud rate")},
        {Parameter::serialNumber, "serial-number", QT_TR_NOOP("Serial number"), QT_TR_NOOP("serial number")},
        {Parameter::presetFlag, "preset-flag", QT_TR_NOOP("Preset flag"), QT_TR_NOOP("preset flag")},
        {Parameter::softwareVersion, "software-version", QT_TR_NOOP("Software version"),
         QT_TR_NOOP("software version")},
        {Parameter::operatingTime, "operating-time", QT_TR_NOOP("Operating time"),
         QT_TR_NOOP("operating time")},
        {Parameter::startUpMode, "start-up-mode", QT_TR_NOOP("Start-up mode"), QT_TR_NOOP("start-up mode")},
        {Parameter::multiTurnAndStepsMinusOne, "multi-turn-steps-minus-1",
         QT_TR_NOOP("Multi-turn and steps minus 1"), QT_TR_NOOP("multi-turn and steps minus 1")},
        {Parameter::temperature, "temperature", QT_TR_NOOP("Temperature"), QT_TR_NOOP("temperature")},
        {Parameter::errorStatus, "error-status", QT_TR_NOOP("Error status"), QT_TR_NOOP("error status")},
        {Parameter::operatingParameters, "operating-parameters", QT_TR_NOOP("Operating parameters"),
         QT_TR_NOOP("operating parameters")},
        {Parameter::alarms, "alarms", QT_TR_NOOP("Alarms"), QT_TR_NOOP("alarms")},
        {Parameter::warnings, "warnings", QT_TR_NOOP("Warnings"), QT_TR_NOOP("warnings")},
        {Parameter::deviceCode, "device-code", QT_TR_NOOP("Device code"), QT_TR_NOOP("device code")},
    });
};

// The number that begins at `at`, which moves behind it.
std::uint64_t takeNumber(QStringView text, qsizetype &at)
{
    std::uint64_t number = 0;
    for (; at < text.size() && text[at].isDigit(); ++at)
        number = number * 10 + static_cast<unsigned>(text[at].digitValue());
    return number;
}

// "register-9" before "register-10".
std::strong_ordering inOrderOfNumbers(QStringView one, QStringView other)
{
    for (qsizetype i = 0, k = 0; i < one.size() && k < other.size();) {
        const bool areNumbers = one[i].isDigit() && other[k].isDigit();
        const auto order = areNumbers ? takeNumber(one, i) <=> takeNumber(other, k)
                                      : one[i++].unicode() <=> other[k++].unicode();
        if (std::is_neq(order))
            return order;
    }
    const int rest = one.compare(other); // "01" and "1", or one begins the other
    return rest <=> 0;
}

// What only some encoders have, named by their descriptions. Its ids follow those of the table.
class NamedParameters
{
public:
    std::size_t of(QStringView key, const LocalText &name)
    {
        const std::unique_lock lock(m_mutex);
        const auto found = std::ranges::find(m_rows, key, &Row::key);
        if (found == m_rows.end()) {
            const std::size_t id = m_rows.size();
            m_rows.push_back({key.toString(), name, false});
            putInOrder(id);
            return id;
        }
        found->hasSeveralNames |= !name.isEmpty() && !found->name.isEmpty() && found->name != name;
        if (found->name.isEmpty())
            found->name = name;
        return static_cast<std::size_t>(found - m_rows.begin());
    }
    std::optional<std::size_t> find(QStringView key) const
    {
        const std::shared_lock lock(m_mutex);
        const auto found = std::ranges::find(m_rows, key, &Row::key);
        return found == m_rows.end() ? std::nullopt : std::optional<std::size_t>(found - m_rows.begin());
    }
    QString key(std::size_t id) const
    {
        const std::shared_lock lock(m_mutex);
        return m_rows.at(id).key;
    }
    QString name(std::size_t id) const
    {
        const std::shared_lock lock(m_mutex);
        const Row &row = m_rows.at(id);
        return row.name.isEmpty() || row.hasSeveralNames ? row.key : row.name.toString();
    }
    // By their keys.
    std::vector<std::size_t> inOrder() const
    {
        const std::shared_lock lock(m_mutex);
        return m_inOrder;
    }

private:
    struct Row
    {
        QString key;
        LocalText name;
        bool hasSeveralNames = false;
    };

    void putInOrder(std::size_t id)
    {
        const auto isBefore = [](QStringView one, QStringView other) {
            return std::is_lt(inOrderOfNumbers(one, other));
        };
        const auto keyOf = [this](std::size_t row) { return QStringView(m_rows[row].key); };
        m_inOrder.insert(std::ranges::upper_bound(m_inOrder, keyOf(id), isBefore, keyOf), id);
    }

    mutable std::shared_mutex m_mutex;
    std::deque<Row> m_rows;
    std::vector<std::size_t> m_inOrder;
};

NamedParameters &named()
{
    static NamedParameters all;
    return all;
}

} // namespace

// The table of what everybody knows, and behind it what descriptions name.
struct ParameterRows
{
    static constexpr std::size_t known = ParameterTexts::all.size();
    static constexpr bool areInOrder()
    {
        for (std::size_t i = 0; i < known; ++i)
            if (ParameterTexts::all[i].parameter.m_id != i)
                return false;
        return true;
    }

    static const ParameterRow *row(Parameter parameter)
    {
        return parameter.m_id < known ? &ParameterTexts::all[parameter.m_id] : nullptr;
    }
    static std::size_t idOfNamed(Parameter parameter) { return parameter.m_id - known; }
    static Parameter named(std::size_t id) { return Parameter(static_cast<std::uint16_t>(known + id)); }
};

static_assert(ParameterRows::areInOrder());

Parameter Parameter::of(QStringView key, const LocalText &name)
{
    if (const ParameterRow *row = rowByKey(ParameterTexts::all, key))
        return row->parameter;
    return ParameterRows::named(named().of(key, name));
}

std::strong_ordering operator<=>(Parameter one, Parameter other)
{
    if (one == other || ParameterRows::row(one) != nullptr || ParameterRows::row(other) != nullptr)
        return one.m_id <=> other.m_id;
    return inOrderOfNumbers(parameterKey(one), parameterKey(other));
}

QString parameterKey(Parameter parameter)
{
    if (const ParameterRow *row = ParameterRows::row(parameter))
        return QString::fromLatin1(row->key);
    return named().key(ParameterRows::idOfNamed(parameter));
}

std::optional<Parameter> parameterFromKey(QStringView key)
{
    if (const ParameterRow *row = rowByKey(ParameterTexts::all, key))
        return row->parameter;
    const auto id = named().find(key);
    return id ? std::optional(ParameterRows::named(*id)) : std::nullopt;
}

std::vector<Parameter> commonParameters()
{
    std::vector<Parameter> common;
    common.reserve(std::size(ParameterTexts::all));
    for (const ParameterRow &row : ParameterTexts::all)
        common.push_back(row.parameter);
    return common;
}

std::vector<Parameter> allParameters()
{
    std::vector<Parameter> all = commonParameters();
    for (const std::size_t id : named().inOrder())
        all.push_back(ParameterRows::named(id));
    return all;
}

QString parameterName(Parameter parameter)
{
    if (const ParameterRow *row = ParameterRows::row(parameter))
        return ParameterTexts::tr(row->name);
    return named().name(ParameterRows::idOfNamed(parameter));
}

QString parameterNameInText(Parameter parameter)
{
    if (const ParameterRow *row = ParameterRows::row(parameter))
        return ParameterTexts::tr(row->nameInText);
    return parameterName(parameter);
}

void replaceValue(ParameterValues &values, ParameterValue value)
{
    std::erase_if(values, [&](const ParameterValue &other) { return other.parameter == value.parameter; });
    values.push_back(value);
}

std::optional<Value> findValue(const ParameterValues &values, Parameter parameter)
{
    const auto found = std::ranges::find(values, parameter, &ParameterValue::parameter);
    return found == values.end() ? std::nullopt : std::optional(found->value);
}

std::optional<std::int64_t> valueOf(const ParameterValues &values, Parameter parameter)
{
    const auto value = findValue(values, parameter);
    return value ? value->asNumber() : std::nullopt;
}

} // namespace codewheel
