// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/device_description.h"
#include "jobs/planned_by.h"
#include "jobs/protocol.h"
#include "kinds/interbus/interbus_protocols.h"
#include "kinds/interbus/k3/k3_mode.h"
#include "kinds/interbus/k3/k3_plan.h"
#include "kinds/interbus/k3/k3_refusal.h"
#include "kinds/interbus/words/k3_cam_fields.h"
#include "kinds/interbus/words/k3_cam_word.h"
#include "kinds/interbus/words/word_protocol.h"
#include "kinds/interbus/words/word_reach.h"

#include <utility>

namespace codewheel {
namespace {

class K3Protocol final : public WordProtocol
{
public:
    Result<std::vector<Step>> planned(const DeviceDescription &device, const Job &job,
                                      const PlanBasis &basis) const override
    {
        K3Knowledge knowledge(device);
        knowledge.set(knownNow(device, basis));
        knowledge.setCams(basis.cams);
        const K3Plan plan(device, knowledge);
        return plannedBy(plan, job, [&] {
            K3Steps steps = plan.stepsFor(job);
            if (basis.out != k3::normalRunning)
                K3Plan::clearOutFirst(steps, job);
            return steps;
        });
    }
    Refusal shownError(const DeviceDescription &device, const Reading &reading) const override
    {
        const K3Step step = k3Step(StepKind::word, k3::normalRunning);
        const ParameterValues none;
        return k3Refusal({.device = device,
                          .step = step,
                          .confirmed = none,
                          .written = none,
                          .inCamMode = reading.mode == Mode::cam},
                         reading.in);
    }
    Word firstWord(const DeviceDescription &device, const Job &job) const override
    {
        if (const auto *preset = std::get_if<SetPreset>(&job))
            return preset->command == PresetCommand::manufacturer ? k3::frabaPreset : k3::initialisePreset;
        if (const auto *mode = std::get_if<SwitchMode>(&job))
            return mode->mode == Mode::velocity ? k3::velocityOn : k3::programWord;
        const auto *write = std::get_if<WriteParameters>(&job);
        if (write == nullptr || write->values.empty())
            return k3::normalRunning;
        const ParameterValue &first = write->values.front();
        const ParameterDescription *parameter = device.find(first.parameter);
        return k3::parameterWord(parameter != nullptr ? wordReach(*parameter).number.value_or(0) : 0,
                                 static_cast<Word>(first.value.number()));
    }
    std::optional<ParameterValue> valueIn(const DeviceDescription &device, Word out) const override
    {
        return k3::isParameterWord(out) ? valueOf(device, out) : std::nullopt;
    }
    std::optional<ParameterValue> confirmedIn(const DeviceDescription &device, Word in) const override
    {
        return k3::isConfirmation(in) ? valueOf(device, in) : std::nullopt;
    }
    CamStep camStep(const Step &step) const override
    {
        if (k3::isProgramWord(step.out)) {
            const Word program = step.out & ~k3::programWord;
            return {.choosesProgram = true,
                    .program = program == 0 ? std::nullopt : std::optional<unsigned>(program)};
        }
        const auto field = step.effect == Effect::takesCams ? fieldSetBy(step.out) : std::nullopt;
        return {.field = field, .value = field ? dataOf(*field, step.out) : 0};
    }
    Word camWord(CamField field, std::int64_t value) const override { return settingWord(field, value); }
    std::optional<PositionCoding> codingFor(const DeviceDescription &device,
                                            std::int64_t value) const override
    {
        K3Knowledge knowledge(device);
        knowledge.set({{.parameter = Parameter::coding, .value = value}});
        return knowledge.coding();
    }
    Word positionBesideCams(Word in) const override { return k3::camPositionPart(in); }
    bool mayChangeScale(Word out) const override
    {
        return k3::isParameterWord(out) || (out & k3::presetBit) != 0;
    }
    int eepromWrites(const DeviceDescription &device, std::span<const Word> words,
                     bool mayBeInCamMode) const override
    {
        int writes = 0;
        for (const Word out : words)
            writes += storedBy(device, out, mayBeInCamMode) ? 1 : 0;
        return writes;
    }

private:
    static std::optional<ParameterValue> valueOf(const DeviceDescription &device, Word word)
    {
        const ParameterDescription *parameter = findNumber(device, k3::number(word));
        return parameter != nullptr ? std::optional(ParameterValue{parameter->parameter, k3::data(word)})
                                    : std::nullopt;
    }

    // A plan takes in the current mode as a start-up mode that was told; the known one may be out of date.
    static std::vector<Known> knownNow(const DeviceDescription &device, const PlanBasis &basis)
    {
        std::vector<Known> known = basis.known;
        if (!basis.reading || !device.mayHaveModes())
            return known;
        std::erase_if(known, [](const Known &one) { return one.parameter == Parameter::startUpMode; });
        const Reading &reading = *basis.reading;
        const auto startUp = reading.mode ? startUpModeFor(*reading.mode, reading.camProgram) : std::nullopt;
        if (startUp)
            known.push_back({Parameter::startUpMode, *startUp, Evidence::told, reading.at});
        return known;
    }

    // As far as the effect of a word depends on earlier ones.
    static bool storedBy(const DeviceDescription &device, Word out, bool &mayBeInCamMode)
    {
        if (k3::isProgramWord(out)) // leaves the current program, and stores it
            return std::exchange(mayBeInCamMode, device.mayHaveModes());
        if ((out & k3::startBit) != 0)
            return false;
        if ((out & k3::presetBit) != 0) // in cam mode a cam, which is stored with its program
            return mayStorePreset(device);
        return k3::isParameterWord(out);
    }
};

} // namespace

const Protocol &k3Protocol()
{
    static const K3Protocol protocol;
    return protocol;
}

} // namespace codewheel
