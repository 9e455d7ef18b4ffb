// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/meaning/meaning_parts.h"

#include "catalog/explain_word.h"
#include "kinds/interbus/words/k3_cam_word.h"
#include "kinds/interbus/words/k3_explain.h"
#include "kinds/interbus/words/la66_word.h"
#include "kinds/interbus/words/position_code.h"
#include "kinds/interbus/words/word_reach.h"
#include "vocabulary/hex.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

// One step, as reported by an encoder that counts steps minus 1 (FRABA manual 10.2).
bool isStepsMinusOne(const DeviceDescription &device, const ParameterDescription &parameter,
                     std::int64_t value)
{
    return device.quirks.mayCountStepsMinusOne && parameter.parameter == Parameter::steps && value == 0;
}

// Turns the numbers of a meaning into texts.
class MeaningParts
{
    Q_DECLARE_TR_FUNCTIONS(Meaning)

public:
    explicit MeaningParts(const DeviceDescription &device)
        : m_device(device)
    {}

    QStringList of(const Meaning &meaning) const;

private:
    enum class In { startOfSentence, sentence };

    QStringList parameterAndValue(const Meaning &meaning, In place) const;
    QString parameterLabel(unsigned number, In place) const;
    static QString outsideText(const ParameterDescription &parameter, std::int64_t value);
    QString parameterValue(unsigned number, std::int64_t value) const;
    QString readOutLabel(unsigned code) const;
    QString readOutValueText(unsigned code, Word value) const;
    QString errorText(unsigned number) const;
    QString serviceLabel(std::int64_t service) const;
    QString serviceData(const Meaning &meaning) const;
    QString outText(Word word, Mode mode) const;

    static QString number(std::int64_t value) { return argumentText(value); }
    static QString hex(std::int64_t value) { return hexWord(static_cast<Word>(value)); }
    static QString camList(std::int64_t bits);
    static QString bitList(std::int64_t bits);
    static QString limited(std::int64_t value, unsigned smallest, unsigned largest);
    static QString manufacturerErrorText(std::int64_t code);

    const DeviceDescription &m_device;
};

QString MeaningParts::camList(std::int64_t bits)
{
    QStringList cams;
    for (unsigned cam = 0; cam < k3::camCount; ++cam)
        if (bits >> cam & 1)
            cams << number(cam);
    return cams.isEmpty() ? tr("none") : cams.join(QStringLiteral(", "));
}

// "D25, D24"
QString MeaningParts::bitList(std::int64_t bits)
{
    QStringList names;
    for (int bit = 31; bit >= 0; --bit)
        if (bits >> bit & 1)
            names << QStringLiteral("D%1").arg(bit);
    return names.join(QStringLiteral(", "));
}

QString MeaningParts::limited(std::int64_t value, unsigned smallest, unsigned largest)
{
    if (value >= smallest && value <= largest)
        return number(value);
    return sentence(tr("%1 (there are only %2 to %3)"), {number(value), number(smallest), number(largest)});
}

QString MeaningParts::manufacturerErrorText(std::int64_t code)
{
    constexpr std::int64_t camAboveRange = 4; // FRABA 10.6
    return code == camAboveRange
               ? sentence(tr("%1: cam start or stop above the largest position"), {number(code)})
               : number(code);
}

QString MeaningParts::parameterLabel(unsigned parameterNumber, In place) const
{
    const ParameterDescription *parameter = findNumber(m_device, parameterNumber);
    if (!parameter && !hasNumber(m_device, parameterNumber))
        return sentence(place == In::startOfSentence ? tr("Parameter %1 (not defined for this encoder)")
                                                     : tr("parameter %1 (not defined for this encoder)"),
                        {number(parameterNumber)});
    if (!parameter)
        return sentence(place == In::startOfSentence ? tr("Parameter %1") : tr("parameter %1"),
                        {number(parameterNumber)});
    return sentence(place == In::startOfSentence ? tr("Parameter %1 %2") : tr("parameter %1 %2"),
                    {number(parameterNumber), parameterNameInText(parameter->parameter)});
}

// "20000 (outside 1 to 4096)", "5 (there are: 3, 4)"
QString MeaningParts::outsideText(const ParameterDescription &parameter, std::int64_t value)
{
    if (parameter.choices.empty())
        return sentence(tr("%1 (outside %2 to %3)"),
                        {valueText(parameter, value), valueText(parameter, parameter.minimum),
                         valueText(parameter, parameter.maximum)});
    QStringList there;
    for (const Choice &choice : parameter.choices)
        there << number(choice.value);
    return sentence(tr("%1 (there are only %2)"), {number(value), there.join(QStringLiteral(", "))});
}

QString MeaningParts::parameterValue(unsigned parameterNumber, std::int64_t value) const
{
    if (const ParameterDescription *parameter = findNumber(m_device, parameterNumber))
        return takesValue(m_device, parameterNumber, value) ? valueText(*parameter, value)
                                                            : outsideText(*parameter, value);
    return parameterNumber == k3::setToDefault && value == 0
               ? sentence(tr("%1 (reset to factory settings)"), {number(value)})
               : number(value);
}

QStringList MeaningParts::parameterAndValue(const Meaning &meaning, In place) const
{
    const auto parameterNumber = static_cast<unsigned>(meaning.number[0]);
    return {parameterLabel(parameterNumber, place), parameterValue(parameterNumber, meaning.number[1])};
}

QString MeaningParts::readOutLabel(unsigned code) const
{
    const ParameterDescription *parameter = findReadOut(m_device, code);
    return parameter ? parameterNameInText(parameter->parameter)
                     : sentence(tr("code %1, which is not defined"), {number(code)});
}

// Read-outs below 0 come as 16-bit or as 25-bit two's complement.
std::int64_t readOutNumber(const ParameterDescription &parameter, Word value)
{
    if (parameter.minimum >= 0)
        return value;
    return value <= 0xFFFF ? static_cast<std::int16_t>(value) : k3::signedData(value);
}

QString MeaningParts::readOutValueText(unsigned code, Word value) const
{
    const ParameterDescription *parameter = findReadOut(m_device, code);
    if (!parameter)
        return number(value);
    const std::int64_t told = readOutNumber(*parameter, value);
    // Of the direction 0 and 1 may come (K3Knowledge).
    const bool isDirection = parameter->parameter == Parameter::direction && told <= 1;
    const bool isTaken = isDirection || isStepsMinusOne(m_device, *parameter, told) || parameter->takes(told);
    const QString text = isTaken ? valueText(*parameter, told) : outsideText(*parameter, told);
    const QString unit = unitText(parameter->unit);
    return unit.isEmpty() || parameter->canBeWritten ? text : text + u' ' + unit;
}

// The parameter that a service of the LA-66 writes, reads, or both.
const ParameterDescription *serviceParameter(const DeviceDescription &device, unsigned service)
{
    const ParameterDescription *written = findNumber(device, service);
    return written ? written : findReadOut(device, service);
}

QString MeaningParts::errorText(unsigned errorNumber) const
{
    const DeviceError *error = m_device.findError(errorNumber);
    return deviceErrorName(error ? error->meaning : RefusalId::otherDeviceError);
}

// "2 measuring length in steps"
QString MeaningParts::serviceLabel(std::int64_t service) const
{
    const auto code = static_cast<unsigned>(service);
    const ParameterDescription *parameter = serviceParameter(m_device, code);
    const QString name = code == la66::presetAdjustment ? tr("preset adjustment")
                         : parameter                    ? parameterNameInText(parameter->parameter)
                                                        : QString();
    return QStringLiteral("%1 %2").arg(number(service), name).trimmed();
}

// number[1] as the value of service number[0]: "1 (decreasing)"
QString MeaningParts::serviceData(const Meaning &meaning) const
{
    const ParameterDescription *parameter =
        serviceParameter(m_device, static_cast<unsigned>(meaning.number[0]));
    return parameter ? valueText(*parameter, meaning.number[1]) : number(meaning.number[1]);
}

QString MeaningParts::outText(Word word, Mode mode) const
{
    return explanationText(m_device,
                           explainWord(m_device, word, {.direction = WordDirection::out, .mode = mode}));
}

QStringList MeaningParts::of(const Meaning &meaning) const
{
    const auto &n = meaning.number;
    switch (meaning.id) {
    case MeaningId::parameterRequest:
    case MeaningId::parameterRequestInCamMode:
    case MeaningId::parameterRequestInvalid:
    case MeaningId::parameterRequestUndefined:
    case MeaningId::confirmed:
        return parameterAndValue(meaning, In::startOfSentence);
    case MeaningId::oldConfirmation:
        return parameterAndValue(meaning, In::sentence);
    case MeaningId::readOutRequest:
        return {readOutLabel(static_cast<unsigned>(n[0]))};
    case MeaningId::readOutValue:
        return {readOutLabel(static_cast<unsigned>(n[0])),
                readOutValueText(static_cast<unsigned>(n[0]), static_cast<Word>(n[1]))};
    case MeaningId::opcRegisterValue:
    case MeaningId::grayPosition:
        return {number(n[0]), hex(n[1])};
    case MeaningId::unusedBitsSet:
        return {bitList(n[0]), number(n[1])};
    case MeaningId::runIgnoresRest:
    case MeaningId::rawPosition:
        return {hex(n[0])};
    case MeaningId::camMode:
        return {limited(n[0], 1, k3::camProgramCount)};
    case MeaningId::setCamShift:
        return {limited(n[0], 0, k3::largestCamShift)};
    case MeaningId::camConfiguration:
    case MeaningId::camConfigurationValue:
        return {camList(n[0])};
    case MeaningId::cams:
        return {camList(n[0]), number(n[1])};
    case MeaningId::manufacturerBitIgnored:
        return {outText(static_cast<Word>(n[0]), Mode::position)};
    case MeaningId::camConfirmation:
        return {outText(static_cast<Word>(n[0]), Mode::cam)};
    case MeaningId::serviceRead:
        return {serviceLabel(n[0]), number(n[1])};
    case MeaningId::serviceWrite:
    case MeaningId::serviceWriteInvalid:
        return {serviceLabel(n[0]), serviceData(meaning), number(n[2])};
    case MeaningId::serviceWritten:
    case MeaningId::serviceValue:
    case MeaningId::oldServiceAnswer:
        return {serviceLabel(n[0]), serviceData(meaning)};
    case MeaningId::serviceRefused:
        return {outText(static_cast<Word>(n[0]), Mode::position)};
    case MeaningId::deviceError:
        return {number(n[0]), errorText(static_cast<unsigned>(n[0]))};
    case MeaningId::manufacturerError:
        return {manufacturerErrorText(n[0])};
    default:
        return {number(n[0]), number(n[1])};
    }
}

} // namespace

bool hasNumber(const DeviceDescription &device, unsigned number)
{
    const bool isOpen = device.dialect == k3::Dialect::generic;
    return number == k3::setToDefault || findNumber(device, number) != nullptr ||
           (isOpen && k3::isKnownNumber(number));
}

bool takesValue(const DeviceDescription &device, unsigned number, std::int64_t value)
{
    const ParameterDescription *parameter = findNumber(device, number);
    return parameter == nullptr || parameter->takes(value) || isStepsMinusOne(device, *parameter, value);
}

QStringList meaningParts(const DeviceDescription &device, const Meaning &meaning)
{
    return MeaningParts(device).of(meaning);
}

} // namespace codewheel
