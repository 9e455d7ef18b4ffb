// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/encoder_session.h"

#include <span>

namespace codewheel {

struct WriteWish
{
    ParameterValues wanted;
    bool initialisePreset = false; // set the position to the preset now
    // Set the position to this value now, after the values; for commands that need it (presetNeedsValue).
    std::optional<std::int64_t> setPositionTo{};
    bool writeAll = false;     // including what the encoder already has
    bool inOrderGiven = false; // otherwise in that of the description
};

// A wanted offset that setting the position replaces: it would be written for nothing.
std::optional<ParameterValue> offsetLeftOut(const DeviceDescription &device, const WriteWish &wish);

// What is wanted, in the order in which it is written, without the offset that is left out; what the device
// does not have comes last.
ParameterValues inTurn(const DeviceDescription &device, const WriteWish &wish);

// Whether the encoder is known to have the value, so that it need not be written. A value that was only told
// counts if the encoder cannot be read; one in force that may be lost without supply does not.
bool isThereAlready(const EncoderSession &encoder, const ParameterValue &value);
// Whether it is known to work with the value, which only has to be stored.
bool isOnlyToBeStored(const EncoderSession &encoder, const ParameterValue &value);

// Error 3. What can be read from it, if anything, is not what it works with: only parameters 1 to 4, all of
// them, bring it back, or its default values.
bool hasLostParameters(const EncoderSession &encoder);
// Error 1 or 3. What is known of it is not what it holds: values that run refused wait beside those it worked
// with, and every further run refuses them, until they are written anew.
bool holdsOtherValues(const EncoderSession &encoder);
// Of parameters 1 to 4, those that are not among the values; none if the encoder has not lost them.
std::vector<Parameter> lostAndNotAmong(const EncoderSession &encoder, const ParameterValues &values);

// The job for a wish: what is known, equal and kept is left out. If the encoder can be read and a value is
// not known from reading, the job reads it first and leaves it out if it is already there. An encoder that
// holds other values gets all of it; the position to be set is its preset. A used-up preset (FRABA) is
// programmed again, as it could not be initialised otherwise.
WriteParameters jobForWish(const EncoderSession &encoder, const WriteWish &wish);

// All of it, one job after the other: writing the values, then setting the position to a value, or to a
// preset that is not given and may be used up (FRABA): the encoder's own is programmed again. A preset wanted
// in addition to another position is written last, since setting the position uses the preset itself.
std::vector<Job> jobsForWish(const EncoderSession &encoder, const WriteWish &wish);
// Their steps, as far as can be told beforehand: from the mode the encoder is in now, with what is known of
// its values and cams. `out` is what is in OUT. Whoever does not know that calls EncoderSession::planned().
Result<std::vector<Step>> stepsForJobs(const EncoderSession &encoder, const std::vector<Job> &jobs, Word out);

// All that is known of an encoder.
std::vector<Known> allKnown(const EncoderSession &encoder);

// Whether the encoder takes anything with this step, a value or a position that becomes its preset.
bool takesValue(const Step &step);
// Whether that is values of the step's parameters.
bool writesValue(const Step &step);

// Whether the step only reads cams, or ends such a read-out.
bool readsCams(const Step &step);

// The steps that write values to the EEPROM: each that takes one, or, where taking does not store, each that
// stores.
int storingSteps(std::span<const Step> steps, const DeviceDescription &device);
// EEPROM writes these steps will cost at most, with those of the preset if it may be stored.
int eepromWritesOf(const std::vector<Step> &steps, const DeviceDescription &device);

} // namespace codewheel
