// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "drivers/position_scale.h"
#include "encoder/encoder_session.h"
#include "encoder/event.h"

#include <vector>

namespace codewheel {

// What is known of an encoder as its jobs are planned.
struct PlanBasis
{
    std::vector<Known> known{};
    std::vector<KnownCams> cams{};
    Word out = 0; // stands in OUT
    std::optional<ValueOptions> options{};
    NodeId node{}; // where it stands
};

// What the protocol of an encoder makes of jobs and values before anything is sent. One object for each; as
// it stands, of encoders that are told values in words. `known` are the values an encoder has, `written`
// those that one job writes.
class Protocol
{
public:
    virtual ~Protocol() = default;

    // See plannedSteps().
    virtual Result<std::vector<Step>> planned(const DeviceDescription &device, const Job &job,
                                              const PlanBasis &basis) const = 0;
    // What a request asks or tells, for the user: "03: preset := 5200h = 20992".
    virtual QString requestText(const QByteArray &line) const { return QString::fromLatin1(line); }
    // The command that sets the position to a value it brings along.
    virtual QString presetCommand() const { return {}; }

    // Whether a job that came this far has sent this value; without one, the position. No: nobody can tell.
    virtual bool wasSent(const Progress & /*job*/, std::optional<Parameter> /*parameter*/) const
    {
        return false;
    }
    // Whether nobody knows if the encoder has what this job sent, and did not tell as written: the job ended
    // before that was looked at.
    virtual bool isFateUnknown(const EncoderSession & /*encoder*/, std::optional<Parameter> /*parameter*/,
                               const Outcome & /*outcome*/, const Progress & /*job*/) const
    {
        return false;
    }

    // The description with the range that the encoder's own values and the options leave.
    virtual ParameterDescription narrowed(const DeviceDescription &device, Parameter parameter,
                                          const ParameterValues &known,
                                          const std::optional<ValueOptions> &options) const;
    // What the encoder sets by itself with these values.
    virtual ParameterValues setAlong(const ParameterValues & /*written*/,
                                     const ParameterValues & /*known*/) const
    {
        return {};
    }
    // Whether a wanted value is sent with those that are written even where the encoder has it already.
    virtual bool goesAlong(Parameter /*parameter*/, const ParameterValues & /*written*/) const
    {
        return false;
    }
    // How many values are written besides these.
    virtual int writtenBesides(const ParameterValues & /*written*/) const { return 0; }

    // See scaleOf() and scaleAfter().
    virtual std::optional<PositionScale> scaleOf(const DeviceDescription &device,
                                                 const ValueOf &valueOf) const;
    virtual std::optional<std::int64_t> valueAfter(Parameter parameter, const ParameterValues &written,
                                                   const ParameterValues &known) const;
    // Where a preset is kept as the scaling changes.
    virtual Parameter presetOffset() const { return Parameter::zeroOffset; }
};

const Protocol &protocolOf(const DeviceDescription &device);

// The words that `job` will put into OUT, or the requests it will send, step by step, as far as they can be
// told beforehand: what is read on the way may leave out values the encoder already has, and may make steps
// into steps - 1. For review before anything is sent; refused like the job itself where the input is bad. A
// WriteCams that writes only what differs reads each program first; what follows is told by the cams of the
// basis, where the program is known.
Result<std::vector<Step>> plannedSteps(const DeviceDescription &device, const Job &job,
                                       const PlanBasis &basis = {});

} // namespace codewheel
