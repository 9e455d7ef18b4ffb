// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/cam_shift_spin.h"

#include "vocabulary/cam_program.h"
#include "vocabulary/refusal_text.h"
#include "widgets/input/decimal_text.h"
#include "widgets/look/describe.h"

namespace codewheel {

CamShiftSpin::CamShiftSpin(QWidget *parent)
    : IntegerField(parent)
{
    setRange(0, CamProgram::largestShift);
    setAlignment(Qt::AlignRight);
    describe(this, tr("Shift of the position"),
             tr("shift_iw: by how many bits the position is shifted right before it stands in D24 to D8. 25 "
                "shows the cams only."));
}

tl::expected<int, QString> CamShiftSpin::read(const QString &bare) const
{
    const auto shift = readWhole(bare);
    if (!shift)
        return tl::unexpected(shift.error());
    if (*shift < minimum() || *shift > maximum())
        return tl::unexpected(
            refusalText({RefusalKind::badInput, RefusalId::camShiftOutOfRange, {RefusalArgument(*shift)}}));
    return static_cast<int>(*shift);
}

} // namespace codewheel
