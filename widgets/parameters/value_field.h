// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "encoder/refusal.h"

#include <QWidget>

#include <optional>

namespace codewheel {

// A field for one value of an encoder on a page of fields: a number, or one of the choices the device has
// (widgets/parameters/value_input.h). Empty: no value given. Esc gives what stood there before.
class ValueField : public QWidget
{
    Q_OBJECT

public:
    // `ifEmpty` stands in the empty field: "as it is".
    ValueField(const ParameterDescription &parameter, const QString &ifEmpty, QWidget *parent = nullptr);
    ~ValueField() override;

    void setValue(std::optional<std::int64_t> value);
    // Nothing: empty. Refused: no number, or out of the parameter's range.
    Result<std::optional<std::int64_t>> value() const;

Q_SIGNALS:
    // Not by setValue(). typed: another character stands there. edited: a value was taken, since the field
    // was left, Return was pressed, a choice made, or a screen reader has set it. What is refused is not
    // taken.
    void typed();
    void edited();
    void entered(); // Return in a number that is good

protected:
    bool eventFilter(QObject *input, QEvent *event) override;

private:
    void takeText();

    QWidget *m_input;
    QString m_taken;        // as it stood when a value was taken last
    bool m_isTyped = false; // the change that is told now
};

} // namespace codewheel
