// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "encoder/refusal.h"

#include <QWidget>

#include <optional>

namespace codewheel {

// A field for one value of an encoder on a page of fields: a number, or one of the choices the device has
// (widgets/parameters/value_input.h). Empty: no value given.
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
    void edited();  // by mouse, keys or a screen reader; not by setValue()
    void entered(); // Enter in a number that is good

private:
    QWidget *m_input;
};

} // namespace codewheel
