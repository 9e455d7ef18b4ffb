// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/k3/k3_reading.h"

#include "kinds/interbus/words/k3_cam_word.h"
#include "kinds/interbus/words/position_code.h"

namespace codewheel {
namespace {

bool positionCanBeRead(const K3View &view)
{
    return view.coding && (!view.mayHaveModes || view.mode == Mode::position);
}

} // namespace

EncoderState stateOf(Word in, k3::Dialect dialect) noexcept
{
    if (k3::isOperation(in))
        return EncoderState::operation;
    if (k3::isConfirmation(in))
        return EncoderState::parameterization;
    if (!k3::isErrorOrReadOut(in))
        return EncoderState::unknown;
    if (k3::isReadOutAnswer(in) && dialect != k3::Dialect::baumer)
        return EncoderState::readOut;
    return EncoderState::error;
}

bool isErrorAnswer(Word in, k3::Dialect dialect) noexcept
{
    return stateOf(in, dialect) == EncoderState::error && k3::number(in) != 0;
}

Reading decodeReading(Word in, Instant at, const K3View &view) noexcept
{
    Reading reading;
    reading.at = at;
    reading.in = in;
    reading.state = stateOf(in, view.dialect);
    reading.mode = view.mode;
    reading.camProgram = view.camProgram;
    reading.coding = view.coding;
    if (reading.state == EncoderState::error)
        reading.errorNumber = k3::number(in);
    else if (reading.state == EncoderState::operation && view.mayHaveModes && view.mode == Mode::velocity)
        reading.velocity = k3::signedData(in);
    else if (reading.state == EncoderState::operation && view.mayHaveModes && view.mode == Mode::cam)
        reading.cams = {k3::camsOn(in), k3::camPositionPart(in)};
    else if (reading.state == EncoderState::operation && positionCanBeRead(view))
        reading.position = k3::decodePosition(in, *view.coding);
    return reading;
}

} // namespace codewheel
