// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cams/cam_fields.h"
#include "catalog/protocol_rules.h"
#include "jobs/position_scale.h"
#include "vocabulary/encoder_session.h"
#include "vocabulary/event.h"

#include <span>
#include <vector>

namespace codewheel {

// What is known of an encoder when its jobs are planned.
struct PlanBasis
{
    std::vector<Known> known{};
    std::vector<KnownCams> cams{};
    Word out = 0; // currently in OUT
    KindData options{};
    NodeId node{};                    // where it is
    std::optional<Reading> reading{}; // what it shows: the mode it is in comes before that known of its start
};

struct CamStep
{
    bool choosesProgram = false;
    std::optional<unsigned> program{}; // empty: none from now on
    std::optional<CamField> field{};
    std::int64_t value = 0;
};

// What the protocol of an encoder makes of jobs and values before anything is sent. One object per protocol;
// the base class stands for encoders that receive values in words. `known` are the values an encoder has,
// `written` those that one job writes.
class Protocol
{
public:
    virtual ~Protocol() = default;

    // See plannedSteps().
    virtual Result<std::vector<Step>> planned(const DeviceDescription &device, const Job &job,
                                              const PlanBasis &basis) const = 0;
    // The line of a step in the wizard: "Parameter 1 steps = 255", "03: preset := 5200h = 20992".
    virtual QString stepText(const DeviceDescription &device, const Step &step) const;
    // The command that sets the position to the value it carries.
    virtual QString presetCommand() const { return {}; }

    // The values that a line of this step gives the encoder, wanted or not.
    virtual ParameterValues valuesIn(const DeviceDescription &device, const Step &step) const;
    // What to say of a line that is sent, where it is shown as it is.
    virtual QString lineText() const;

    // How the words or commands of a write go out and are checked, for its review; empty: as everybody
    // expects.
    virtual QString howItIsSent() const { return {}; }
    // What to say about an encoder that shows an error number by itself: no job asked it for anything.
    virtual Refusal shownError(const DeviceDescription &device, const Reading &reading) const;
    // The word that this job begins with where no mode changes it; 0: it has none.
    virtual Word firstWord(const DeviceDescription & /*device*/, const Job & /*job*/) const { return 0; }
    // What IN shows to somebody who has seen nothing before it, and knows these values. Empty: the encoder
    // has no words.
    virtual std::optional<Reading> readingOf(const DeviceDescription & /*device*/,
                                             const std::vector<Known> & /*known*/, Word /*in*/, Word /*out*/,
                                             Instant /*at*/) const
    {
        return {};
    }
    // The part of the position that IN holds beside cams.
    virtual Word positionBesideCams(Word /*in*/) const { return 0; }
    // The value that this OUT word gives the encoder, and the one that this IN word confirms.
    virtual std::optional<ParameterValue> valueIn(const DeviceDescription & /*device*/, Word /*out*/) const
    {
        return {};
    }
    virtual std::optional<ParameterValue> confirmedIn(const DeviceDescription & /*device*/, Word /*in*/) const
    {
        return {};
    }
    // What a step of a cam job says: the program it chooses, the field it sets and to what.
    virtual CamStep camStep(const Step & /*step*/) const { return {}; }
    // The word that sets a field of a cam program; 0: it has none.
    virtual Word camWord(CamField /*field*/, std::int64_t /*value*/) const { return 0; }
    // The coding that its parameter of that name stands for; empty: none, or it has no such parameter.
    virtual std::optional<PositionCoding> codingFor(const DeviceDescription & /*device*/,
                                                    std::int64_t /*value*/) const
    {
        return {};
    }
    // Whether another position may belong to the same place after this OUT word.
    virtual bool mayChangeScale(Word /*out*/) const { return true; }
    // How often at most these words, sent one after the other by hand, write to its EEPROM.
    virtual int eepromWrites(const DeviceDescription & /*device*/, std::span<const Word> /*words*/,
                             bool /*mayBeInCamMode*/) const
    {
        return 0;
    }

    // Whether a job that got this far has sent this value; without a parameter, the position. False: nobody
    // can tell.
    virtual bool wasSent(const Progress & /*job*/, std::optional<Parameter> /*parameter*/) const
    {
        return false;
    }
    // Whether nobody knows if the encoder has what this job sent but did not report as written: the job ended
    // before that was checked. Without a parameter, the position.
    virtual bool isFateUnknown(const EncoderSession & /*encoder*/, std::optional<Parameter> parameter,
                               const Outcome &outcome, const Progress & /*job*/) const
    {
        const InDoubt &doubt = outcome.inDoubt;
        return parameter ? doubt.reset || findValue(doubt.values, *parameter) : doubt.position;
    }

    // The description with its range narrowed by the encoder's own values and the options.
    virtual ParameterDescription narrowed(const DeviceDescription &device, Parameter parameter,
                                          const ParameterValues &known, const KindData &options) const;
    // What the encoder sets by itself with these values.
    virtual ParameterValues setAlong(const ParameterValues & /*written*/,
                                     const ParameterValues & /*known*/) const
    {
        return {};
    }
    // Whether a wanted value is sent along with those written even if the encoder already has it.
    virtual bool goesAlong(Parameter /*parameter*/, const ParameterValues & /*written*/) const
    {
        return false;
    }
    // How many values are written in addition to these.
    virtual int writtenBesides(const ParameterValues & /*written*/) const { return 0; }

    // See scaleOf() and scaleAfter().
    virtual std::optional<PositionScale> scaleOf(const DeviceDescription &device,
                                                 const ValueOf &valueOf) const;
    virtual std::optional<std::int64_t> valueAfter(Parameter parameter, const ParameterValues &written,
                                                   const ParameterValues &known) const;
    // Where a preset is kept when the scaling changes; empty: nowhere.
    virtual std::optional<Parameter> presetOffset() const { return Parameter::zeroOffset; }
};

// A protocol of encoders: the profile that descriptions name it by, and what knows it. Both outlive the
// program.
struct ProtocolKind
{
    Profile profile;
    const ProtocolRules &rules;
    const Protocol &protocol;
};
// Those of kinds/protocols.cpp, and any that were added, before descriptions are read.
void addProtocol(const ProtocolKind &kind);

// That of its profile; noProtocol() if no kind has it.
const Protocol &protocolOf(const DeviceDescription &device);
// Refuses every job.
const Protocol &noProtocol();

// The words that `job` will put into OUT, or the requests it will send, step by step, as far as can be told
// beforehand: what is read on the way may remove values the encoder already has, and may turn steps into
// steps - 1. For review before anything is sent; refused like the job itself if the input is bad. A WriteCams
// that writes only what differs reads each program first; what follows is derived from the cams of the basis,
// if the program is known.
Result<std::vector<Step>> plannedSteps(const DeviceDescription &device, const Job &job,
                                       const PlanBasis &basis = {});

} // namespace codewheel
