// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/job_check.h"

#include "catalog/kept_values.h"
#include "catalog/protocol_rules.h"
#include "catalog/value_text.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"

#include <QStringList>

#include <set>

namespace codewheel {
namespace {

QString allowedTexts(const ParameterDescription &parameter)
{
    QStringList keys;
    for (const Choice &choice : parameter.choices)
        keys.append(choice.key);
    return keys.join(QStringLiteral(", "));
}

// Why the device cannot do it, whatever the input; empty: it can.
struct WhyNot
{
    const DeviceDescription &device;
    const Capabilities &can = device.capabilities;
    using Id = std::optional<RefusalId>;

    static Id unless(bool possible, RefusalId id) { return possible ? std::nullopt : std::optional(id); }

    Id operator()(const ReadParameters &) const { return unless(can.reads, RefusalId::readingNotSupported); }
    Id operator()(const WriteParameters &) const
    {
        return unless(can.writes, RefusalId::writingNotSupported);
    }
    Id operator()(const EndParameterization &) const
    {
        return unless(can.writes, RefusalId::writingNotSupported);
    }
    Id operator()(const SetPreset &job) const
    {
        if (!can.presets)
            return RefusalId::presetNotSupported;
        return unless(job.command != PresetCommand::manufacturer || can.manufacturerPreset,
                      RefusalId::manufacturerPresetNotSupported);
    }
    Id operator()(const SwitchMode &job) const
    {
        if (job.mode == Mode::cam)
            return unless(can.cams.has_value(), RefusalId::camsNotSupported);
        return unless(device.quirks.hasModes && (job.mode != Mode::velocity || can.velocity),
                      RefusalId::velocityNotSupported);
    }
    Id operator()(const ResetToDefault &) const { return unless(can.resets, RefusalId::resetNotSupported); }
    Id operator()(const StoreParameters &) const
    {
        return unless(protocolRules(device.profile).storesByStep() && keepsValues(device),
                      RefusalId::jobNotSupported);
    }
    Id operator()(const ReadCams &) const
    {
        return unless(can.cams.has_value(), RefusalId::camsNotSupported);
    }
    Id operator()(const WriteCams &) const
    {
        return unless(can.cams.has_value(), RefusalId::camsNotSupported);
    }
    Id operator()(const SendWords &) const
    {
        return unless(device.outWords > 0, RefusalId::sendingNotSupported);
    }
};

// Whether the input makes sense.
struct Input
{
    const DeviceDescription &device;
    const KindData &options;

    static Result<void> nothing() { return refuse(RefusalKind::badInput, RefusalId::nothingToDo); }
    Result<void> noPosition() const
    {
        return refuse(RefusalKind::badInput, RefusalId::presetNeedsValue, {device.fullName()});
    }

    Result<void> operator()(const ReadParameters &job) const
    {
        for (const Parameter parameter : job.parameters)
            if (const auto *description = device.find(parameter); !description || !description->canBeRead)
                return refuse(RefusalKind::badInput, RefusalId::parameterNotSupported,
                              {parameter, device.fullName()});
        return job.parameters.empty() ? nothing() : Result<void>();
    }
    Result<void> operator()(const WriteParameters &job) const
    {
        if (job.initialisePreset && device.capabilities.presetNeedsValue)
            return noPosition();
        return job.values.empty() && !job.initialisePreset ? nothing() : checkValues(job.values);
    }
    Result<void> operator()(const EndParameterization &job) const { return checkValues(job.restore); }
    Result<void> operator()(const SetPreset &job) const
    {
        return device.capabilities.presetNeedsValue && !job.value ? noPosition() : Result<void>();
    }
    Result<void> operator()(const SendWords &job) const
    {
        return job.words.empty() ? nothing() : Result<void>();
    }
    template <typename Other>
    Result<void> operator()(const Other &) const
    {
        return {};
    }

    Result<void> checkValues(const ParameterValues &values) const
    {
        std::set<Parameter> seen;
        for (const ParameterValue &value : values) {
            if (auto checked = checkValue(device, value, options); !checked)
                return checked;
            if (!seen.insert(value.parameter).second)
                return refuse(RefusalKind::badInput, RefusalId::parameterGivenTwice, {value.parameter});
        }
        return {};
    }
};

} // namespace

Result<void> checkJob(const DeviceDescription &device, const Job &job, const KindData &options)
{
    if (const auto why = std::visit(WhyNot{device}, job))
        return refuse(RefusalKind::notSupported, *why, {device.fullName()});
    return std::visit(Input{device, options}, job);
}

Result<void> checkText(const ParameterDescription &parameter, const Value &value)
{
    if (parameter.takes(value))
        return {};
    return refuse(RefusalKind::badInput, RefusalId::valueNotAllowed,
                  {parameter.parameter, value.toString(), textLimit(parameter)});
}

Result<void> checkRange(const ParameterDescription &parameter, const Value &value)
{
    const auto number = value.asNumber();
    if (!number)
        return refuse(
            RefusalKind::badInput, RefusalId::valueNotAllowed,
            {parameter.parameter, value.toString(),
             QStringLiteral("%1..%2").arg(numberText(parameter.minimum), numberText(parameter.maximum))});
    if (*number >= parameter.minimum && *number <= parameter.maximum)
        return {};
    const auto asTyped = [&](std::int64_t typed) {
        constexpr int wholeWord = 8;
        return parameter.form != nullptr && parameter.form->typedHexDigits == wholeWord
                   ? RefusalArgument(hexWord(static_cast<Word>(typed)) + u'h')
                   : RefusalArgument(typed);
    };
    return refuse(
        RefusalKind::badInput, RefusalId::valueOutOfRange,
        {parameter.parameter, asTyped(*number), asTyped(parameter.minimum), asTyped(parameter.maximum)});
}

Result<void> checkValue(const DeviceDescription &device, const ParameterValue &value, const KindData &options)
{
    const ParameterDescription *parameter = device.find(value.parameter);
    if (parameter == nullptr)
        return refuse(RefusalKind::badInput, RefusalId::parameterNotSupported,
                      {value.parameter, device.fullName()});
    if (!parameter->canBeWritten)
        return refuse(RefusalKind::badInput, RefusalId::parameterReadOnly,
                      {value.parameter, device.fullName()});
    if (parameter->isText())
        return checkText(*parameter, value.value);
    if (!parameter->choices.empty()) {
        if (parameter->findChoice(value.value) == nullptr)
            return refuse(RefusalKind::badInput, RefusalId::valueNotAllowed,
                          {value.parameter, value.value.toString(), allowedTexts(*parameter)});
    } else if (auto checked = checkRange(withOptions(*parameter, options), value.value); !checked) {
        return checked;
    }
    // Whatever the description says: the word would carry a different value.
    const ProtocolRules &rules = protocolRules(device.profile);
    if (value.value.number() < rules.smallestData() || value.value.number() > rules.largestData())
        return refuse(RefusalKind::badInput, RefusalId::valueOutOfRange,
                      {value.parameter, value.value.number(), rules.smallestData(), rules.largestData()});
    return {};
}

} // namespace codewheel
