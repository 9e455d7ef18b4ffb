// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/esc/esc_line_write.h"

#include "catalog/device_description.h"
#include "cli/call/texts.h"
#include "cli/encoder/jobs.h"
#include "cli/kinds/esc/esc_line_access.h"
#include "cli/kinds/esc/scan_line.h"
#include "kinds/esc/driver/esc_values.h"
#include "vocabulary/sentence.h"
#include "vocabulary/serial_number_text.h"

#include <algorithm>

namespace codewheel {

Checked<void> readWhatIsWritten(const Call &call, EncoderSession &encoder, const ParameterValues &wanted)
{
    ReadParameters read;
    for (const ParameterValue &value : wanted)
        if (const ParameterDescription *its = encoder.device().find(value.parameter); its && its->canBeRead)
            read.parameters.push_back(value.parameter);
    for (const Parameter scale : {Parameter::revolutions, Parameter::measuringRange, Parameter::scaling})
        if (std::ranges::count(read.parameters, scale) == 0)
            read.parameters.push_back(scale);
    const FinishedJob job = runToEnd(call, {encoder, std::move(read)});
    if (job.wasCancelled)
        return tl::unexpected(aboutCancelling());
    if (!job.outcome.result)
        return tl::unexpected(complaintAboutJob(call, encoder.place(), job.outcome.result.error()));
    return {};
}

Checked<void> checkAddressIsFree(const Call &call, EscLineAccess &line, const EncoderSession &encoder,
                                 const ParameterValues &wanted)
{
    const auto address = valueOf(wanted, Parameter::lineAddress);
    if (!address || *address < 1 || *address > EscLineAddress::last)
        return {};
    for (const EscLineAddress reading : escReadingsOf({static_cast<std::uint8_t>(*address)})) {
        if (reading == EscLineAddress::of(encoder.place().node))
            continue;
        const auto there = whoIsAt(call, line, reading);
        if (!there)
            return tl::unexpected(there.error());
        if (*there)
            return tl::unexpected(complaintAbout(
                {RefusalKind::badInput,
                 RefusalId::lineAddressTaken,
                 {reading.shown(), sentence(CommandLine::tr("an encoder with the serial number %1"),
                                            {serialNumberText((*there)->serialNumber.value_or(0))})}}));
    }
    return {};
}

} // namespace codewheel
