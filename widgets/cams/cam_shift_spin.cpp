// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/cam_shift_spin.h"

#include "encoder/cam_program.h"
#include "encoder/hex.h"
#include "encoder/refusal_text.h"

#include <QLineEdit>

namespace codewheel {

CamShiftSpin::CamShiftSpin(QWidget *parent)
    : QSpinBox(parent)
{
    setRange(0, CamProgram::largestShift);
    setAlignment(Qt::AlignRight);
    setKeyboardTracking(false);
    setCorrectionMode(CorrectToPreviousValue);
    setAccessibleName(tr("Shift of the position"));
    setToolTip(
        tr("shift_iw: by how many bits the position is shifted right before it stands in D24 to D8. 25 "
           "shows the cams only."));
    connect(lineEdit(), &QLineEdit::textEdited, this, &CamShiftSpin::check);
    connect(this, &QSpinBox::valueChanged, this, [this] { Q_EMIT inputChecked({}); });
}

QValidator::State CamShiftSpin::validate(QString &input, int &position) const
{
    const QValidator::State state = QSpinBox::validate(input, position);
    return state == QValidator::Invalid ? QValidator::Intermediate : state;
}

void CamShiftSpin::check(const QString &typed)
{
    const auto shift = parseNumber(typed);
    const bool isGood = shift && *shift <= CamProgram::largestShift;
    const RefusalArgument given =
        shift ? RefusalArgument(*shift) : RefusalArgument(typed.isEmpty() ? tr("nothing") : typed);
    const QString wrong =
        isGood ? QString() : refusalText({RefusalKind::badInput, RefusalId::camShiftOutOfRange, {given}});
    setAccessibleDescription(wrong);
    Q_EMIT inputChecked(wrong);
}

} // namespace codewheel
