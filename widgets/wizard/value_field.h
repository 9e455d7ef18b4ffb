// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "encoder/refusal.h"

#include <QWidget>

#include <optional>

class QComboBox;
class QLineEdit;

namespace codewheel {

// A field for one value of an encoder: a number (decimal or hexadecimal), or one of the choices the device
// has. Empty: no value given.
class ValueField : public QWidget
{
    Q_OBJECT

public:
    // `ifEmpty` stands in the empty field: "as it is".
    ValueField(const ParameterDescription &parameter, const QString &ifEmpty, QWidget *parent = nullptr);

    void setValue(std::optional<std::int64_t> value);
    // Nothing: empty. Refused: no number, or out of the parameter's range.
    Result<std::optional<std::int64_t>> value() const;

Q_SIGNALS:
    void edited(); // by mouse, keys or a screen reader; not by setValue()

private:
    ParameterDescription m_parameter;
    QLineEdit *m_number = nullptr;
    QComboBox *m_choice = nullptr;
};

} // namespace codewheel
