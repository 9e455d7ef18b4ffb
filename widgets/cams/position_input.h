// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/refusal.h"
#include "widgets/input/input_mark.h"

#include <QLineEdit>

#include <functional>
#include <optional>

namespace codewheel {

// A field for a position, decimal or hexadecimal, that says while you type what is wrong. Anything can be
// typed; only what is good is taken.
class PositionInput : public QLineEdit
{
    Q_OBJECT

public:
    // The sentence about what was typed, a number or a text.
    using Complaint = std::function<QString(const RefusalArgument &given)>;

    // For a position from least to largest.
    PositionInput(std::int64_t least, std::int64_t largest, Complaint complaint, QWidget *parent = nullptr);

    std::optional<std::int64_t> value() const; // nothing: bad input

Q_SIGNALS:
    void inputChecked(const QString &wrong); // a sentence, or empty where the input is good

private:
    QString complaint() const;
    void showCheck();

    std::int64_t m_least;
    std::int64_t m_largest;
    Complaint m_complaint;
    InputMark m_mark;
};

} // namespace codewheel
