// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSpinBox>

namespace codewheel {

// A field for shift_iw, 0..25, that lets another number be typed and says what is wrong with it; only what is
// good is taken.
class CamShiftSpin : public QSpinBox
{
    Q_OBJECT

public:
    explicit CamShiftSpin(QWidget *parent = nullptr);

Q_SIGNALS:
    void inputChecked(const QString &wrong); // a sentence, or empty where the input is good

protected:
    QValidator::State validate(QString &input, int &position) const override;

private:
    void check(const QString &typed);
};

} // namespace codewheel
