// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/dragged_place.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

const QString placeType = QStringLiteral("application/x-codewheel-place");

QByteArray ofThisProgram()
{
    return QByteArray::number(QCoreApplication::applicationPid()) + ' ';
}

} // namespace

std::unique_ptr<QMimeData> draggedPlace(Place place, const QString &text)
{
    auto data = std::make_unique<QMimeData>();
    data->setData(placeType, ofThisProgram() + place.key().toUtf8());
    data->setText(text);
    return data;
}

std::optional<Place> placeDragged(const QMimeData &data)
{
    const QByteArray key = data.data(placeType);
    return key.startsWith(ofThisProgram())
               ? Place::parse(QString::fromUtf8(key.sliced(ofThisProgram().size())))
               : std::nullopt;
}

} // namespace codewheel
