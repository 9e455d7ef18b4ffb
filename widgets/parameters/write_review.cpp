// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/write_review.h"

#include "catalog/value_text.h"
#include "jobs/protocol.h"
#include "jobs/step_text.h"
#include "jobs/write_plan.h"
#include "widgets/job/known_text.h"
#include "widgets/look/fitted_columns.h"
#include "widgets/models/age_text.h"
#include "widgets/models/device_traits.h"

#include <QTableView>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int parameterColumn = 0;

QString howItIsSent(const DeviceDescription &device)
{
    if (!device.hasWords())
        return device.capabilities.reads
                   ? WriteReview::tr("Sends these requests, and reads back each value")
                   : WriteReview::tr("Sends this; the encoder confirms it, and cannot be read");
    return activatesByRun(device)
               ? WriteReview::tr("Sends these words, then run (80000000)")
               : WriteReview::tr("Sends these words, each with its handshake on the service bit");
}

ReviewRow rowOf(const EncoderSession &encoder, const WriteRow &row)
{
    const ParameterDescription &parameter = *encoder.device().find(row.wanted.parameter);
    const auto text = [&](const Value &value) { return valueText(parameter, value, encoder.valueOptions()); };
    return {.cells = {parameterName(parameter),
                      row.known ? text(row.known->value) : WriteReview::tr("unknown"), text(row.wanted.value),
                      sentText(*row.step)},
            .tips = {{},
                     howKnown(row.known, encoder),
                     {},
                     row.step->line.isEmpty() ? WriteReview::tr("The word that will be in OUT")
                                              : protocolOf(encoder.device()).lineText()}};
}

// Whether it still has them, or is still the same encoder, is not known while it is out of sight.
QString nothingToWrite(const EncoderSession &encoder)
{
    const QString why = outOfSightReason(encoder);
    return why.isEmpty()
               ? WriteReview::tr("The encoder is known to have all wanted values. There is nothing to write.")
               : WriteReview::tr("The encoder had all wanted values when it was seen last. Whether it has "
                                 "them now is not known: %1",
                                 "a sentence")
                     .arg(why);
}

QStringList notesOf(const EncoderSession &encoder, const WritePlan &plan)
{
    QStringList lines;
    const auto there = std::ranges::count(plan.rows, true, &WriteRow::isThere);
    if (plan.jobs.empty())
        lines << nothingToWrite(encoder);
    else if (there > 0)
        lines << WriteReview::tr("Left out because they are there already: %1.").arg(there);
    lines << howItIsWritten(plan);
    for (const ValueNote &note : plan.notes)
        lines << noteText(note);
    if (valueOf(plan.job.values, Parameter::preset))
        lines << WriteReview::tr("The preset acts once it is initialised (40000000).");
    return lines;
}

} // namespace

WriteReview::WriteReview(QWidget *parent)
    : JobReview("confirmWrite", parent)
{
    FittedColumns::useIn(table(), parameterColumn);
}

void WriteReview::review(EncoderSession &encoder, const ParameterValues &wanted)
{
    using Kind = ReviewColumn::Kind;
    const bool sendsRequests = !encoder.device().hasWords();
    m_wanted = wanted;
    begin(encoder,
          {{tr("Parameter")},
           {tr("Old"), Kind::value},
           {tr("New"), Kind::value},
           {sendsRequests ? tr("Request") : tr("Word"), Kind::code}},
          howItIsSent(encoder.device()),
          sendsRequests ? TextSize::small : TextSize::normal); // they are long, and the dock is narrow
}

JobReview::Contents WriteReview::contents(const EncoderSession &encoder, bool writesAll) const
{
    const WritePlan plan = planWrite(encoder, {.wanted = m_wanted, .writeAll = writesAll});
    Contents contents{.job = plan.job, .problem = plan.refusal, .notes = notesOf(encoder, plan)};
    for (const WriteRow &row : plan.rows)
        if (row.step)
            contents.rows.push_back(rowOf(encoder, row));
    const auto sent = contents.rows.size();
    contents.write = sent == 1 ? tr("&Write this value") : tr("&Write these %1 values").arg(sent);
    return contents;
}

} // namespace codewheel
