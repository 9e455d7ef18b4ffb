// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "vocabulary/refusal.h"
#include "widgets/input/input_mark.h"

#include <QLineEdit>
#include <QVariant>

namespace codewheel {

// A field for one value of an encoder that is typed: a number, decimal or hexadecimal, a length in mm, or a
// text. It says while you type what is wrong. May be empty: no value.
class ValueInput : public QLineEdit
{
    Q_OBJECT

public:
    ValueInput(ParameterDescription parameter, QWidget *parent = nullptr);

    Parameter parameter() const { return m_parameter.parameter; }
    void setValue(const std::optional<Value> &value);
    Result<std::optional<Value>> value() const;
    QSize minimumSizeHint() const override; // with room for the text of an empty one

Q_SIGNALS:
    // While typing: a sentence, or empty where the input is good.
    void inputChecked(const QString &wrong);

private:
    void check();

    ParameterDescription m_parameter;
    InputMark m_mark;
};

// For item delegates, the "tell" row and forms: a ValueInput, or a combo box for the choices the device has.
// ifEmpty stands for no value: "as it is".
QWidget *makeValueInput(const ParameterDescription &parameter, const QString &ifEmpty, QWidget *parent);
void setInputValue(QWidget &input, const std::optional<Value> &value);
Result<std::optional<Value>> inputValue(const QWidget &input);

// In the models of items; invalid: no value.
QVariant variantOf(const std::optional<Value> &value);
std::optional<Value> valueFromVariant(const QVariant &variant);

} // namespace codewheel
