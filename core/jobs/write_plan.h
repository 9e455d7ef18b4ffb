// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/value_notes.h"
#include "jobs/values_to_write.h"

#include <vector>

namespace codewheel {

// One value with what is known of it, and what carries it.
struct WriteRow
{
    ParameterValue wanted;
    std::optional<Known> known{}; // of the encoder now
    std::optional<Step> step{};   // that carries it: its word, or its request; empty: it is not sent
    bool isThere = false;         // known to be there already: left out
    bool goesAlong = false;       // not wanted: computed from the others, like the factor of a serial encoder
    bool isOnlyStored = false;    // in force already, and perhaps lost without supply
    bool isRearmed = false;       // there already, and written all the same if the preset is used up
    std::optional<Refusal> hindrance{}; // why the encoder does not take it

    // Not wanted either, but not computed: the step of others carries all values.
    bool isInStepOfOthers() const { return goesAlong && step && step->parameters.size() > 1; }
};

// What writing the wanted values involves, for review before anything is sent: in the parameter panel, the
// wizard, transfers and on the command line.
struct WritePlan
{
    WriteParameters job{};            // for the values
    std::vector<Job> jobs{};          // everything, one after the other; empty: there is nothing to do
    std::vector<Step> steps{};        // of the jobs
    std::vector<WriteRow> rows{};     // what is sent, in its order, then what is not
    std::optional<Refusal> refusal{}; // why the jobs cannot be planned; there are no steps then
    // The encoder may count steps minus 1, which is read before the first word: the word for the steps may be
    // one less.
    bool stepsMayBeLess = false;
    // The encoder has lost its parameters, and these of parameters 1 to 4 are not among the values: it will
    // not work.
    std::vector<Parameter> lostAndNotWritten{};
    std::vector<ValueNote> notes{}; // what else the values bring about
};

// That a wanted zero offset is left out.
std::optional<ValueNote> leftOutNote(const DeviceDescription &device, const WriteWish &wish);

QString parameterNames(const std::vector<Parameter> &parameters); // "steps, preset"

// How the values are written, one sentence each: what is read before, what the words may turn out to be.
QString readsFirstText();
QStringList howItIsWritten(const WritePlan &plan);

// Leaves out what the encoder is known to have, unless everything is to be written. A value that was only
// told but can be read is read by the job first.
WritePlan planWrite(const EncoderSession &encoder, const WriteWish &wish);

} // namespace codewheel
