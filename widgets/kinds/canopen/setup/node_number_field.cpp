// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/setup/node_number_field.h"

#include "kinds/canopen/protocol/canopen_address.h"
#include "vocabulary/hex.h"

namespace codewheel {

NodeNumberField::NodeNumberField(QWidget *parent)
    : IntegerField(parent)
{
    setRange(1, canopen::lastNode);
}

QString NodeNumberField::textFromValue(int value) const
{
    return CanopenAddress{value}.shown();
}

tl::expected<int, QString> NodeNumberField::read(const QString &bare) const
{
    const auto number = parseNumber(QStringView(bare).left(bare.indexOf(u'(')).trimmed());
    if (number && *number >= minimum() && *number <= maximum())
        return static_cast<int>(*number);
    return tl::unexpected(tr("\"%1\" is not a node number. Give one from 1 to 127.").arg(bare));
}

} // namespace codewheel
