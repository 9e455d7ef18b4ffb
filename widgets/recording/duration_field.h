// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"
#include "widgets/input/number_fields.h"

class QComboBox;

namespace codewheel {

// A duration as a number and its unit, from seconds to days.
class DurationField : public QWidget
{
    Q_OBJECT

public:
    // `name`, `tip`: of the number, as in describe().
    DurationField(const char *id, const QString &name, const QString &tip, QWidget *parent);

    Instant value() const; // as last taken
    void setValue(Instant value);

Q_SIGNALS:
    void changed();

private:
    DecimalField *m_number;
    QComboBox *m_unit;
};

} // namespace codewheel
