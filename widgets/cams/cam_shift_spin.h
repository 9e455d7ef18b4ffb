// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/input/number_fields.h"

namespace codewheel {

// The field for shift_iw, 0..25.
class CamShiftSpin : public IntegerField
{
    Q_OBJECT

public:
    explicit CamShiftSpin(QWidget *parent = nullptr);

Q_SIGNALS:
    void inputChecked(const QString &wrong); // a sentence, or empty where the input is good

protected:
    tl::expected<int, QString> read(const QString &bare) const override;
    void checked(const QString &wrong) override { Q_EMIT inputChecked(wrong); }
};

} // namespace codewheel
