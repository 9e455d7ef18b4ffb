// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/input/number_fields.h"

namespace codewheel {

// The number of a node, in decimal as on switches; shows how it stands in identifiers, too.
class NodeNumberField final : public IntegerField
{
    Q_OBJECT

public:
    explicit NodeNumberField(QWidget *parent = nullptr);

protected:
    QString textFromValue(int value) const override;
    tl::expected<int, QString> read(const QString &bare) const override;
};

} // namespace codewheel
