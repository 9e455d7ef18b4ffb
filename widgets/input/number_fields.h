// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/input/form_fields.h"
#include "widgets/input/input_mark.h"

#include <QDoubleSpinBox>
#include <QSpinBox>

#include <functional>
#include <tl/expected.hpp>

namespace codewheel {

// The field for a number in every form. What is typed is taken when the field is left or Return is pressed,
// and only if it is good; until then a mark says what is wrong. Esc restores the previous value. Point and
// comma are both decimal signs.
template <typename SpinBox>
class SpinField : public SpinBox, public FormField
{
public:
    using Number = decltype(std::declval<SpinBox>().value());

    explicit SpinField(QWidget *parent = nullptr);

    QString takeTyped() override;
    QString complaint() const; // about the text in the field; empty: none
    // What was typed gives way, and with it what is wrong with it; also while signals are blocked.
    void setValue(Number value);

protected:
    // The number as typed, without prefix and suffix.
    virtual tl::expected<Number, QString> read(const QString &bare) const;
    // While typing: a sentence, or empty where it is good.
    virtual void checked(const QString &) {}

    QValidator::State validate(QString &text, int &position) const override;
    Number valueFromText(const QString &text) const override;
    void fixup(QString &) const override {} // Qt's own would drop thousands separators
    void keyPressEvent(QKeyEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    QString bareText(QString text) const;
    void check();
    void keepingRefused(const std::function<void()> &handle);

    InputMark m_mark;
};

extern template class SpinField<QDoubleSpinBox>;
extern template class SpinField<QSpinBox>;

using DecimalField = SpinField<QDoubleSpinBox>;
using IntegerField = SpinField<QSpinBox>;

// For the number of something, as a port or a register: its range is said without signs between thousands.
void leaveSeparatorsOut(QSpinBox &field);

} // namespace codewheel
