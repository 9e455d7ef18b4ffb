// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "vocabulary/refusal.h"

#include <QWidget>

#include <optional>

namespace codewheel {

// A field for one value of an encoder in a form: a number, or one of the choices the device has
// (widgets/parameters/value_input.h). Empty: no value. Esc restores the previous input.
class ValueField : public QWidget
{
    Q_OBJECT

public:
    // `ifEmpty` is shown in the empty field: "as it is".
    ValueField(const ParameterDescription &parameter, const QString &ifEmpty, QWidget *parent = nullptr);
    ~ValueField() override;

    void setValue(const std::optional<Value> &value);
    bool isBeingTyped() const; // and not taken yet
    void takeTyped();          // as if the field were left
    // Nothing: empty. Refused: not a number, or out of the parameter's range.
    Result<std::optional<Value>> value() const;

Q_SIGNALS:
    // Not by setValue(). typed: the text has changed. edited: a value was taken, because the focus went to
    // another part of its form (FormFocus), Return was pressed, a choice was made, or a screen reader has set
    // it. Refused input is not taken.
    void typed();
    void edited();
    void entered(); // Return in a valid number

protected:
    bool eventFilter(QObject *input, QEvent *event) override;

private:
    QWidget *m_input;
    QString m_taken;        // the text when a value was last taken
    bool m_isTyped = false; // the cause of the present change
};

} // namespace codewheel
